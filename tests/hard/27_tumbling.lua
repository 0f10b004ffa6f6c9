-- 27. A square that tumbles at 0.01 to 0.1 rad a step falls on a smooth floor, again and again: energy never rises by more than 1e-6 of the start
-- in a step. Source: conservation. Ours: second-order overlaps of turning corners were pushed out by the penalty. (0.3 s CPU)
local talus = require "talus"
local tools = require "tools"
local g = tools.g
local young, L = 10e9, 0.1
local rock = talus.material { name = "rock", density = 2500, young = young, poisson = 0.2 }
for _, friction in ipairs { 0, 0.5 } do
  for _, dt in ipairs { 3e-4, 1e-3, 3e-3 } do
    local sim = talus.simulation {
      gravity = {0, -g}, contact = talus.joint { name = "floor", friction = friction },
      regions = { talus.region { name = "floor", outline = talus.rect(-20, -1, 20, 0), material = rock, held = true },
                  talus.region { name = "square", outline = { {-L/2, 0.2}, {L/2, 0.2}, {L/2, 0.2 + L}, {-L/2, 0.2 + L} }, material = rock, spin = 33, velocity = {0.5, 0} } },
      time = { mode = "dynamic", t_end = 1.5, dt = dt },
    }
    local gain = tools.gains(sim)
    for _ in sim:steps() do gain() end
    talus.check.below(string.format("tumbling, %g rad a step, friction %g: largest gain in a step over kinetic + stored", 33*dt, friction), gain(), 1e-6)
  end
end
