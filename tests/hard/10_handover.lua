-- 10. Sliding across a coplanar joint (hand-over from edge to edge): acceleration jump < 1 %, no snag.
-- From one held block onto the next, and over five loose slabs side by side on a floor.
-- Source: Coulomb friction, v = v0 − μ g t. (0.3 s CPU)
local talus = require "talus"
local mu, g = 0.2, 9.81
local rock = talus.material { name = "rock", density = 2500, young = 10e9, poisson = 0.2 }
local grounds = {
  held = { talus.region { name = "near", outline = talus.rect(-4, -1, 1, 0), material = rock, held = true },
           talus.region { name = "far", outline = talus.rect(1, -1, 10, 0), material = rock, held = true } },
  loose = { talus.region { name = "floor", outline = talus.rect(-10, -3, 12, -1), material = rock, held = true },
            talus.region { name = "slabs", blocks = { talus.rect(-2, -1, 0.5, 0), talus.rect(0.5, -1, 1.5, 0), talus.rect(1.5, -1, 2.5, 0),
                                                      talus.rect(2.5, -1, 3.5, 0), talus.rect(3.5, -1, 6, 0) }, material = rock } },
}
for _, name in ipairs { "held", "loose" } do
  local regions = grounds[name]
  regions[3] = talus.region { name = "sledge", outline = talus.rect(-1, 0, 0, 0.5), material = rock, velocity = {4, 0} }
  local sim = talus.simulation {
    gravity = {0, -g}, contact = talus.joint { name = "seat", friction = math.atan(mu) }, regions = regions,
    time = { mode = "dynamic", t_end = 1, dt = 1e-3, start = "settled" },
  }
  local sledge = sim.blocks:where { region = "sledge" }[1].id
  local worst, before, cuts = 0, 4, 0
  for status in sim:steps() do
    local v = sim.blocks[sledge].velocity[1]
    worst = math.max(worst, math.abs((v - before)/status.dt/(-mu*g) - 1))
    before, cuts = v, cuts + status.cuts
  end
  talus.check.below("hand-over, " .. name .. " ground: largest jump of the deceleration, relative", worst, 0.01)
  talus.check.near("hand-over, " .. name .. " ground: speed after 1 s, m/s", before, 4 - mu*g, { rel = name == "held" and 1e-6 or 1e-3 })
  talus.check.below("hand-over, " .. name .. " ground: way up or down, m", math.abs(sim.blocks[sledge].uy), name == "held" and 1e-6 or 1e-5)
  talus.check.equal("hand-over, " .. name .. " ground: cuts", cuts, 0)
end
