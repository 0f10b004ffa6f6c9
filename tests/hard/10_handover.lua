-- 10. Sliding across a coplanar joint (hand-over from edge to edge): acceleration jump < 1 %, no snag.
-- From one held block onto the next. Source: Coulomb friction, v = v0 − μ g t. (0.1 s CPU)
local talus = require "talus"
local mu, g = 0.2, 9.81
local rock = talus.material { name = "rock", density = 2500, young = 10e9, poisson = 0.2 }
local sim = talus.simulation {
  gravity = {0, -g}, contact = talus.joint { name = "seat", friction = math.atan(mu) },
  regions = {
    talus.region { name = "near", outline = talus.rect(-4, -1, 1, 0), material = rock, held = true },
    talus.region { name = "far", outline = talus.rect(1, -1, 10, 0), material = rock, held = true },
    talus.region { name = "sledge", outline = talus.rect(-1, 0, 0, 0.5), material = rock, velocity = {4, 0} },
  },
  time = { mode = "dynamic", t_end = 1, dt = 1e-3, start = "settled" },
}
local worst, before, cuts = 0, 4, 0
for status in sim:steps() do
  local v = sim.blocks[3].velocity[1]
  worst = math.max(worst, math.abs((v - before)/status.dt/(-mu*g) - 1))
  before, cuts = v, cuts + status.cuts
end
talus.check.below("hand-over: largest jump of the deceleration, relative", worst, 0.01)
talus.check.near("hand-over: speed after 1 s, m/s", before, 4 - mu*g, { rel = 1e-6 })
talus.check.below("hand-over: way up or down, m", math.abs(sim.blocks[3].uy), 1e-6)
talus.check.equal("hand-over: cuts", cuts, 0)
