-- 14. Arch of 21 voussoirs at t/R = 0.10679 (1 ± 0.01): stands / falls.
-- Source: limit analysis of rigid voussoirs at high friction, R at mid-thickness; E 55 GPa is nearly rigid. (0.5 s CPU)
local talus = require "talus"
local g = 9.81
local voussoirs, radius = 21, 5
local stone = talus.material { name = "stone", density = 2400, young = 55e9, poisson = 0.2 }
for _, part in ipairs { 1.01, 0.99 } do
  local ratio = 0.10679*part
  local function at(r, angle) return { r*math.cos(angle), r*math.sin(angle) } end
  local inner, outer = radius*(1 - ratio/2), radius*(1 + ratio/2)
  local stones = {}
  for i = 1, voussoirs do
    local a, b = math.pi*(i - 1)/voussoirs, math.pi*i/voussoirs
    stones[i] = { at(inner, a), at(outer, a), at(outer, b), at(inner, b) }
  end
  local sim = talus.simulation {
    gravity = {0, -g}, contact = talus.joint { name = "bed joint", friction = math.rad(60) },
    regions = { talus.region { name = "ground", outline = talus.rect(-6.5, -0.5, 6.5, 0), material = stone, held = true },
                talus.region { name = "arch", blocks = stones, material = stone } },
    probes = { crown = {0, radius} }, time = { mode = "dynamic", t_end = 3, dt = 5e-3 },
  }
  sim:run()
  if part > 1 then
    talus.check.near("arch at 1.01 of its least thickness: way of the crown, m", sim.probes.crown.uy, 0, { abs = 1e-3*radius })
  else
    talus.check.below("arch at 0.99 of its least thickness: way of the crown, m", sim.probes.crown.uy, -0.5)
  end
end
