-- 7. Drop into a 60° V: frictionless reaction W ± 1e-4, no ejection (no speed above 1.01 × the drop's).
-- A wedge that fits, and a square on its corner that does not. Source: equilibrium, energy. (0.3 s CPU)
local talus = require "talus"
local tools = require "tools"
local g = tools.g
local rock = talus.material { name = "rock", density = 2500, young = 10e9, poisson = 0.2 }
local a = math.rad(60)
local shapes = {
  { name = "wedge", drop = 0.5, { {0, 0.5}, {0.8, 0.5 + 0.8*math.tan(a)}, {-0.8, 0.5 + 0.8*math.tan(a)} } },
  { name = "square", drop = 0.5, { {-0.5, 0.5 + 0.5*math.tan(a)}, {0.5, 0.5 + 0.5*math.tan(a)}, {0.5, 1.5 + 0.5*math.tan(a)}, {-0.5, 1.5 + 0.5*math.tan(a)} } },
}
for _, shape in ipairs(shapes) do
  local sim = talus.simulation {
    gravity = {0, -g}, contact = talus.joint { name = "smooth", friction = 0 },
    regions = {
      talus.region { name = "v", outline = talus.polygon { {-3, -1}, {3, -1}, {3, 3*math.tan(a)}, {0, 0}, {-3, 3*math.tan(a)} },
                     material = rock, held = true },
      talus.region { name = "body", outline = talus.polygon(shape[1]), material = rock } },
    time = { mode = "dynamic", t_end = 3, dt = 1e-3 },
  }
  local fastest = 0
  for _ in sim:steps() do fastest = math.max(fastest, sim.blocks[2].speed) end
  local lift = 0
  for _, c in ipairs(sim.contacts) do lift = lift + c.normal_force*math.cos(a) end
  talus.check.near("V of 60 degrees, " .. shape.name .. ": reaction over weight", lift/(sim.blocks[2].mass*g), 1, { rel = 1e-4 })
  talus.check.below("V of 60 degrees, " .. shape.name .. ": largest speed over that of the drop", fastest/math.sqrt(2*g*shape.drop), 1.01)
end
