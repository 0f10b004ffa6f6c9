-- 1. Spinner: 1 m square, 10 rad/s, 0.01 rad a step, 100 turns, no gravity: |ΔA/A| < 1e-9, |Δ angular momentum| < 1e-8 relative,
-- kinetic energy within 1e-4. The area is held against that of the centrifugal strain, which the start lacks.
-- Source: rotating body, mean stress ρω²L²/12 in both directions; conservation. (0.6 s CPU)
local talus = require "talus"
local young, density, spin = 10e9, 2500, 10
local rock = talus.material { name = "rock", density = density, young = young, poisson = 0 }
local sim = talus.simulation {
  regions = { talus.region { name = "block", outline = talus.rect(0, 0, 1, 1), material = rock, spin = spin } },
  time = { mode = "dynamic", t_end = 20*math.pi, dt = 1e-3 },
}
local stretch = density*spin^2/12/young          -- of a side
local start = 0.5*density/6*spin^2
local area, momentum, kinetic = 0, 0, 0
local count = 0
for _ in sim:steps() do
  count = count + 1
  if count > 62000 then                          -- the last turn; the strain has long come to rest
    local b = sim.blocks[1]
    area = math.max(area, math.abs(b.area/(1 + stretch)^2 - 1))
    momentum = math.max(momentum, math.abs(b.spin*(1 + stretch)^2/spin - 1))
  end
  kinetic = math.max(kinetic, math.abs(sim.energy.kinetic/start - 1))
end
talus.check.below("spinner: area against that of the centrifugal strain, relative", area, 1e-9)
talus.check.below("spinner: angular momentum, relative", momentum, 1e-8)
talus.check.below("spinner: kinetic energy, relative, largest on the way", kinetic, 1e-4)
