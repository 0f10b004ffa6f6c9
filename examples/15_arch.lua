-- A semicircular arch of 21 loose voussoirs falls when it is thinner than t/R = 0.10679.
-- Run: scripts/run examples/15_arch.lua                   falls: hinges at feet, haunches, crown (0.2 s CPU)
--      scripts/run examples/15_arch.lua -p ratio=0.108    stands (0.2 s CPU)
-- Teaches: blocks from a Lua loop, contacts without tension, a parameter, a check that depends on it.
-- Picture: docs/pictures/15_arch.svg (t = 1.4 s)
-- Source: limit analysis of rigid voussoirs at high friction, R at mid-thickness. These are elastic and need a
-- little more: 0.1075 still sinks.
local talus = require "talus"
local u = talus.units

local ratio = talus.param("ratio", 0.105, "thickness t / mean radius R")
local voussoirs, radius, limit = 21, 5.0, 0.10679
local inner, outer = radius*(1 - ratio/2), radius*(1 + ratio/2)
local stone = talus.material { name = "stone", density = 2400, young = 10*u.GPa, poisson = 0.2 }

local function at(r, angle) return { r*math.cos(angle), r*math.sin(angle) } end
local stones = {}
for i = 1, voussoirs do
  local a, b = math.pi*(i - 1)/voussoirs, math.pi*i/voussoirs
  stones[i] = { at(inner, a), at(outer, a), at(outer, b), at(inner, b) }
end

local sim = talus.simulation {
  title   = string.format("Arch of %d voussoirs, t/R = %g", voussoirs, ratio),
  gravity = {0, -9.81},
  contact = talus.joint { name = "bed joint", friction = 60*u.deg },
  regions = {
    talus.region { name = "ground", outline = talus.rect(-6.5, -0.5, 6.5, 0), material = stone, held = true },
    talus.region { name = "arch", blocks = stones, material = stone },
  },
  probes = { crown = {0, radius} },
  time   = { mode = "dynamic", t_end = 1.5, dt = 5*u.ms },
  output = { dir = "out/arch", every = 0.1, picture = "s2" },
}
sim:run()
if ratio < limit then
  talus.check.below("fallen, way of the crown, m", sim.probes.crown.uy, -0.5)
else
  talus.check.near("standing, way of the crown, m", sim.probes.crown.uy, 0, { abs = 1e-3 })
end
