-- 30. As case 10, over five loose slabs side by side on a floor: acceleration jump < 1 %, no snag.
-- Source: Coulomb friction, v = v0 − μ g t. Ours: a slab is one strain, so the next one stands 1 µm above the loaded one, and the corner of the
-- sledge meets that step (k_n · 1 µm is forty times its weight). (0.1 s CPU)
local talus = require "talus"
local mu, g = 0.2, 9.81
local rock = talus.material { name = "rock", density = 2500, young = 10e9, poisson = 0.2 }
local sim = talus.simulation {
  gravity = {0, -g}, contact = talus.joint { name = "seat", friction = math.atan(mu) },
  regions = {
    talus.region { name = "floor", outline = talus.rect(-10, -3, 12, -1), material = rock, held = true },
    talus.region { name = "slabs", blocks = { talus.rect(-2, -1, 0.5, 0), talus.rect(0.5, -1, 1.5, 0), talus.rect(1.5, -1, 2.5, 0),
                                              talus.rect(2.5, -1, 3.5, 0), talus.rect(3.5, -1, 6, 0) }, material = rock },
    talus.region { name = "sledge", outline = talus.rect(-1, 0, 0, 0.5), material = rock, velocity = {4, 0} },
  },
  time = { mode = "dynamic", t_end = 1, dt = 1e-3, start = "settled" },
}
local worst, before, cuts = 0, 4, 0
for status in sim:steps() do
  local v = sim.blocks[7].velocity[1]
  worst = math.max(worst, math.abs((v - before)/status.dt/(-mu*g) - 1))
  before, cuts = v, cuts + status.cuts
end
talus.check.below("hand-over over loose slabs: largest jump of the deceleration, relative", worst, 0.01)
talus.check.near("hand-over over loose slabs: speed after 1 s, m/s", before, 4 - mu*g, { rel = 1e-3 })
talus.check.below("hand-over over loose slabs: way up or down, m", math.abs(sim.blocks[7].uy), 1e-5)
talus.check.equal("hand-over over loose slabs: cuts", cuts, 0)
