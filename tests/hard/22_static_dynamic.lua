-- 22. Static run and settled dynamic run of one isostatic or bonded scene: the same contact forces within 0.1 % (frictional
-- hyperstatic forces are not unique). Isostatic: a beam on two smooth corners with a block on it; bonded: a meshed beam on two corners;
-- the beam's end is held along x.
-- Each in three ways: static, motion from a settled start, motion from rest that has died down. Source: equilibrium. (2 s CPU)
local talus = require "talus"
local tools = require "tools"
local g = tools.g
local rock = talus.material { name = "rock", density = 2500, young = 10e9, poisson = 0.2 }
local function supports()
  return talus.region { name = "supports", material = rock, held = true,
    blocks = { { {0.5, 0}, {0.2, -0.5}, {0.8, -0.5} }, { {3.2, 0}, {2.9, -0.5}, {3.5, -0.5} } } }
end
local function isostatic()
  return { supports(), talus.region { name = "beam", outline = talus.rect(0, 0, 4, 0.5), material = rock },
           talus.region { name = "load", outline = talus.polygon { {2.6, 0.5}, {3.4, 0.5}, {3.0, 1.3} }, material = rock } }
end
local function bonded()
  return { supports(), talus.region { name = "beam", outline = talus.rect(0, 0, 4, 0.5), material = rock, mesh = { kind = "cross", nx = 16, ny = 2 },
           joint = talus.joint { name = "bond", tension = 1e9, cohesion = 1e9 } } }
end
local function forces(make, time)
  local sim = talus.simulation { gravity = {0, -g}, contact = talus.joint { name = "smooth", friction = 0 }, regions = make(), time = time,
    fix = { talus.fix { region = "beam", on = talus.point(0, 0.25), x = true, y = false } } }
  sim:run()
  local sums = {}
  for _, c in ipairs(sim.contacts) do
    if c.normal_force > 0 then
      local held = sim.blocks[c.block_i].region == "supports" and c.block_i or sim.blocks[c.block_j].region == "supports" and c.block_j or "load"
      sums[held] = (sums[held] or 0) + c.normal_force
    end
  end
  return sums
end
for name, make in pairs { isostatic = isostatic, bonded = bonded } do
  local static = forces(make, { mode = "static" })
  local ways = { ["settled start"] = { mode = "dynamic", t_end = 0.2, dt = 1e-3, start = "settled" },
                 ["from rest"] = { mode = "dynamic", t_end = 20, dt = 5e-3 } }
  for way, time in pairs(ways) do
    local moving, off = forces(make, time), 0
    for key, force in pairs(static) do off = math.max(off, math.abs((moving[key] or 0)/force - 1)) end
    talus.check.below(string.format("%s, %s: contact forces against the static ones", name, way), off, 1e-3)
  end
end
