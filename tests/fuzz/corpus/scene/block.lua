-- A block falls onto a fixed slab: free flight against ½ g t², then rest.
-- Run: scripts/run examples/01_falling_block.lua      (0.1 s CPU)
-- Teaches: regions, materials, a held region, contacts, probes, checks.
-- Picture: docs/pictures/01_falling_block.svg (t = 0.4 s: the block falls at 3.92 m/s)
local talus = require "talus"
local u = talus.units

local rock = talus.material { name = "rock", density = 2500, young = 10*u.GPa, poisson = 0.25 }

local sim = talus.simulation {
  gravity = {0, -9.81},
  contact = talus.joint { name = "contact", friction = 30*u.deg },
  regions = {
    talus.region { name = "slab", outline = talus.rect(-2, -0.5, 2, 0), material = rock, held = true },
    talus.region { name = "block", outline = talus.rect(-0.5, 2, 0.5, 3), material = rock },
  },
  probes = { centre = {0, 2.5} },
  time   = { mode = "dynamic", t_end = 1.5, dt = 2*u.ms },
  output = { dir = "out/falling_block", every = 0.1, picture = "speed" },
}

for step in sim:steps() do
  if sim.time >= 0.5 then break end
end
talus.check.near("fall in 0.5 s", sim.probes.centre.uy, -0.5*9.81*sim.time^2, { rel = 1e-10 })
sim:step()
talus.check.near("block on the slab", sim.probes.centre.uy, -2, { abs = 1e-5 })
talus.check.below("speed at rest", math.abs(sim.probes.centre.vy), 1e-6)
