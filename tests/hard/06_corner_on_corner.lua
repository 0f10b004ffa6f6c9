-- 6. Corner dropped on corner, offset 0, ±1e-12 L, ±1e-9 L: penetration < 1e-3 L, mirrored runs mirror to 1e-10, no lock-up.
-- Lock-up: a step cut, more than 10 iterations, or a hammer that hangs in the air at the end (1e-3 is added: it falls off).
-- Source: mirror symmetry. (0.4 s CPU)
local talus = require "talus"
local tools = require "tools"
local g = tools.g
local rock = talus.material { name = "rock", density = 2500, young = 10e9, poisson = 0.2 }
local function corners(offset)
  local s, deepest = math.sqrt(2)/2, 0
  local sim = talus.simulation {
    gravity = {0, -g}, contact = talus.joint { name = "contact", friction = 0.5 },
    regions = {
      talus.region { name = "anvil", outline = talus.polygon { {0, 0}, {-s, -s}, {0, -2*s}, {s, -s} }, material = rock, held = true },
      talus.region { name = "hammer", outline = talus.polygon { {offset, 0.1}, {offset + s, 0.1 + s}, {offset, 0.1 + 2*s}, {offset - s, 0.1 + s} },
                     material = rock } },
    time = { mode = "dynamic", t_end = 0.6, dt = 1e-3 },
  }
  local seen = tools.watch(sim, function()
    for _, c in ipairs(sim.contacts) do
      if c.normal_force > 0 then deepest = math.max(deepest, -c.gap) end
    end
  end)
  return sim.blocks[2], deepest, seen, sim
end
for _, offset in ipairs { 0, 1e-12, 1e-9, 1e-3 } do
  local label = string.format("corner on corner, offset %g: ", offset)
  local right, deep, seen, sim = corners(offset)
  talus.check.below(label .. "penetration, m", deep, 1e-3)
  talus.check.near(label .. "time reached, s", sim.time, 0.6, { rel = 1e-9 })
  talus.check.equal(label .. "cut steps", seen.cut_steps, 0)
  talus.check.below(label .. "most iterations of a step", seen.most_iterations, 10.5)
  if offset > 0 then
    local left = corners(-offset)
    talus.check.below(label .. "mirrored runs differ by, m",
                      math.max(math.abs(right.ux + left.ux), math.abs(right.uy - left.uy), math.abs(right.rotation + left.rotation)), 1e-10)
  end
end
