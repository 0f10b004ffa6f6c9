-- 35. Crushed rock: 1 GPa of gas in a hole breaks every bond round it within 50 microseconds and drives the triangles over each other, tip
-- by tip. No two blocks come to overlap by more than a part of their size.
-- Source: geometry, as in case 34.
-- Ours: thin tips went through each other until neither had a face left that the other could rest on. Such a pair had no contact, went on
-- into each other as far as their size, and every step that took it farther was halved, down to a microsecond: in 5 of 10 meshes more than
-- 1, in up to 4200 steps where 135 do. Then a contact was found for such a pair, but too late: tips that crossed like an X, no corner of one
-- in the other, within a step, were not seen to overlap (0.34 in one of 11 meshes, up to 0.85 of older versions; 0.2 and more in 10 of 46).
-- Run: scripts/run tests/hard/35_crushed_rock.lua -p full=true     (quick: one mesh that went wrong, to 2 ms)
local talus = require "talus"
local tools = require "tools"
local u = talus.units
local full = talus.param("full", false, "all meshes, to 3 ms")

local rock = talus.material { name = "rock", density = 2600, young = 55*u.GPa, poisson = 0.3, plane = "strain" }
local joint = talus.joint { name = "artificial", friction = 45*u.deg, cohesion = 2*u.MPa, tension = 0.5*u.MPa }
local faces = talus.joint { name = "faces", friction = 45*u.deg }
local deepest = 0
for _, size in ipairs(full and { 0.1, 0.095, 0.09, 0.087, 0.083, 0.08, 0.073, 0.067, 0.064, 0.058, 0.05 } or { 0.064 }) do
  local sim = talus.simulation {
    contact = faces,
    regions = {
      talus.region { name = "plate", outline = talus.rect(-1.5, -1.5, 1.5, 1.5), material = rock, joint = joint,
                     holes = { talus.circle { at = {0, 0}, radius = 0.1, sides = 22, name = "hole" } },
                     mesh = { size = talus.grade { { at = "hole", size = size }, far = 0.5 } } },
    },
    charges = { talus.charge { hole = "hole", eos = talus.eos.polytropic { pressure = 1*u.GPa, gamma = 1.4 }, gas_speed = 100 } },
    time = { t_end = full and 3e-3 or 2e-3 },
  }
  local most = 0
  for _ in sim:steps() do most = math.max(most, tools.overlap(sim)) end
  print(string.format("blocks of %g m at the hole: %d steps, %d cuts, deepest overlap %.3f", size, sim.totals.steps, sim.totals.cuts, most))
  deepest = math.max(deepest, most)
end
talus.check.below("crushed rock: deepest overlap over √area", deepest, 0.05)
