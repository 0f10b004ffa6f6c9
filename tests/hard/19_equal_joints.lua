-- 19. N equal joints loaded to exactly their strength: all fail in one step, none before another, static and in motion.
-- N rigid columns side by side, each bonded to a base by one joint of its own, under equal pulls that end at the strength. In motion
-- they are pulled by steps to just beyond it. (0.2 s CPU)
local talus = require "talus"
local u = talus.units
local rock = talus.material { name = "rock", density = 2500, young = 10*u.GPa, poisson = 0.2 }
local strength = 0.5*u.MPa
local joint = talus.joint { name = "joint", friction = 35*u.deg, cohesion = 4*u.MPa, tension = strength }
local bound = talus.joint { name = "base", friction = 0.5 }

-- N columns side by side, cut apart by open traces down to y = 0, where each is bonded to the base.
local function comb(n)
  local cuts = { talus.trace { points = { {0, 0}, {n, 0} }, bonded = true, joint = joint } }
  for k = 1, n - 1 do
    cuts[#cuts + 1] = talus.trace { points = { {k, 0}, {k, 1} }, joint = bound }
  end
  return talus.region { name = "comb", outline = talus.rect(0, -1, n, 1), material = rock, order = "rigid", joint = bound, cuts = cuts }
end

local function run(n, pull, time, order)
  local steps, failed = 0, 0
  local sim = talus.simulation {
    regions = { comb(n) }, fix = { talus.fix { region = "comb", on = "bottom" } }, fracture = { order = order },
    loads = { talus.edge_load { region = "comb", on = "top", traction = {0, pull} } }, time = time,
    on_fracture = function(sim, cracks)
      steps, failed = steps + 1, failed + #cracks
      sim:stop()
    end,
  }
  sim:run()
  return steps, failed
end

for _, n in ipairs { 2, 7, 50 } do
  for _, order in ipairs { "critical", "all", "one" } do
    local label = string.format("%d equal joints, order %s, ", n, order)
    local steps, failed = run(n, { {0, 0}, {1, strength} }, { mode = "static", steps = 3 }, order)
    talus.check.equal(label .. "static: steps in which joints failed", steps, 1)
    talus.check.equal(label .. "static: joints that failed in it", failed, n)
  end
  local label = string.format("%d equal joints, in motion: ", n)
  local steps, failed = run(n, { {0, 0}, {1e-3, 1.5*strength} }, { mode = "dynamic", t_end = 1e-3, dt = 5e-5 }, "critical")
  talus.check.equal(label .. "steps in which joints failed", steps, 1)
  talus.check.equal(label .. "joints that failed in it", failed, n)
end
