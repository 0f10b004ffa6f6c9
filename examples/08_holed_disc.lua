-- A flattened disc with a hole beside its centre: a small hole lets it split along the loaded diameter, a large one through the hole.
-- Run: scripts/run examples/08_holed_disc.lua                   large: a 7 mm, e 8 mm (3 s CPU)
--      scripts/run examples/08_holed_disc.lua -p hole=small     a 3.5 mm, e 12 mm (4 s CPU)
-- Teaches: holes, a parameter that picks a case.
-- Picture: docs/pictures/08_holed_disc_large.svg, docs/pictures/08_holed_disc_small.svg
-- Source: Ning, Yang, An & Ma (2011), Figs. 8 to 10, models 3-II (1464 blocks) and 3-I (1502 blocks).
local talus = require "talus"
local u = talus.units
local disc = require "parts.flattened_disc"

local case = talus.param("hole", "large", "small or large")
local radius, eccentricity, usual = 7*u.mm, 8*u.mm, 1.75*u.mm
if case == "small" then radius, eccentricity, usual = 3.5*u.mm, 12*u.mm, 1.9*u.mm end
local size = talus.param("size", usual, "triangle edge, m")

local body = disc.holed(size, radius, eccentricity)
local sim, seen = disc.break_up(body, { title = "Flattened disc with a " .. case .. " hole", output = { dir = "out/holed_disc" } },
                                case == "large" and { height = disc.at_plates, blank = radius }
                                                or { band = 0.2*disc.radius, until_through = true })

local function at_hole(crack) return disc.at_hole(crack, size, radius, eccentricity) end
local met, above, below = 0, false, false
for _, crack in ipairs(seen.failed) do
  local touches = at_hole(crack)
  if touches then met = met + crack.length end
  above, below = above or touches and crack.y > 0, below or touches and crack.y < 0
end
print(string.format("%d blocks; first crack at (%.1f, %.1f) mm, %.2f kN/m; split at %.2f kN/m; %.1f mm cracked at the hole",
                    #sim.blocks, 1e3*seen.first.x, 1e3*seen.first.y, seen.initiation/u.kN, seen.splitting/u.kN, 1e3*met))
talus.check.truth("the first crack is at the hole", at_hole(seen.first))
if case == "small" then
  talus.check.truth("splits beside the hole: cracks within 0.1 D of the loaded diameter cross it from plate to plate", seen.through ~= nil)
else
  talus.check.truth("split in two", seen.split)
  talus.check.truth("splits through the hole: cracks above and below it", above and below)
end
