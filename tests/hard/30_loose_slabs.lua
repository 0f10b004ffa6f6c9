-- 30. As case 10, over five loose slabs side by side on a floor: no snag, and no more of a jump than the slabs' own give, which goes with 1/E.
-- Source: Coulomb friction, v = v0 − μ g t. A slab is one strain, and the next one carries nothing until the sledge's corner is on it: it then gives by up to w = m g h/(E b),
-- slab h by b, which the sledge follows within a step, so that its weight and with it the deceleration is off by up to w/(g Δt²) of itself. Ours: the step of w up to the
-- unloaded slab held the sledge up: k_n w is forty times its weight. (0.4 s CPU)
local talus = require "talus"
local mu, g, density = 0.2, 9.81, 2500
local dt, mass, h, b = 1e-3, density*1*0.5, 1, 1
for _, gpa in ipairs { 10, 100, 1000 } do
  local rock = talus.material { name = "rock", density = density, young = gpa*1e9, poisson = 0.2 }
  local sim = talus.simulation {
    gravity = {0, -g}, contact = talus.joint { name = "seat", friction = math.atan(mu) },
    regions = {
      talus.region { name = "floor", outline = talus.rect(-10, -3, 12, -h), material = rock, held = true },
      talus.region { name = "slabs", blocks = { talus.rect(-2, -h, 0.5, 0), talus.rect(0.5, -h, 0.5 + b, 0), talus.rect(0.5 + b, -h, 0.5 + 2*b, 0),
                                                talus.rect(0.5 + 2*b, -h, 0.5 + 3*b, 0), talus.rect(0.5 + 3*b, -h, 6, 0) }, material = rock },
      talus.region { name = "sledge", outline = talus.rect(-1, 0, 0, 0.5), material = rock, velocity = {4, 0} },
    },
    time = { mode = "dynamic", t_end = 1, dt = dt, start = "settled" },
  }
  local worst, before, cuts = 0, 4, 0
  for status in sim:steps() do
    local v = sim.blocks[7].velocity[1]
    worst = math.max(worst, math.abs((v - before)/status.dt/(-mu*g) - 1))
    before, cuts = v, cuts + status.cuts
  end
  local label = string.format("hand-over over loose slabs of %d GPa: ", gpa)
  talus.check.below(label .. "largest jump of the deceleration, relative", worst, mass*h/(gpa*1e9*b*dt^2))
  talus.check.near(label .. "speed after 1 s, m/s", before, 4 - mu*g, { rel = 1e-3 })
  talus.check.below(label .. "way up or down, m", math.abs(sim.blocks[7].uy), 1e-5)
  talus.check.equal(label .. "cuts", cuts, 0)
end
