-- 2. Fast spinner, 1000 rad/s: mean strain within 5 % of the centrifugal value, no stress oscillation above 5 %.
-- Twenty turns, of which the last ten are judged, at 0.01 and at 0.1 rad a step.
-- Source: rotating body, mean stress ρω²L²/12 in both directions, in axes that turn with it. (0.3 s CPU)
local talus = require "talus"
local young, density, poisson, spin = 55e9, 2600, 0.3, 1000
local rock = talus.material { name = "rock", density = density, young = young, poisson = poisson }
local stress = density*spin^2/12
for _, angle in ipairs { 0.01, 0.1 } do
  local turn = 2*math.pi/spin
  local sim = talus.simulation {
    regions = { talus.region { name = "block", outline = talus.rect(0, 0, 1, 1), material = rock, spin = spin } },
    time = { mode = "dynamic", t_end = 20*turn, dt = angle/spin },
  }
  local low, high, sum, count = math.huge, -math.huge, 0, 0
  for _ in sim:steps() do
    if sim.time > 10*turn then
      local b = sim.blocks[1]
      low, high = math.min(low, b.s2), math.max(high, b.s1)
      sum, count = sum + (b.exx + b.eyy)/2, count + 1
    end
  end
  local label = string.format("fast spinner, %g rad a step: ", angle)
  talus.check.near(label .. "mean strain", sum/count, stress*(1 - poisson)/young, { rel = 0.05 })
  talus.check.below(label .. "range of the principal stresses over their mean", (high - low)/stress, 0.05)
end
