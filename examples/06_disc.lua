-- A flattened disc pressed between smooth plates splits along the loaded diameter: 40 kN pull the centre apart.
-- Run: scripts/run examples/06_disc.lua                    1450 blocks (3 s CPU)
--      scripts/run examples/06_disc.lua -p size=0.00185    1318 blocks, another mesh (3 s CPU)
-- Teaches: bonds that fail, static loading that stops at each failure, reactions, on_fracture, sim.cracks, parts of a scene in a
-- file of their own.
-- Picture: docs/pictures/06_disc_initiation.svg, docs/pictures/06_disc.svg (split)
-- Source: Ning, Yang, An & Ma (2011), Fig. 6. Load: 2D elasticity with these flats gives 39.5 to 40.7 kN per metre of thickness
-- for a tensile strength of 0.5 MPa; bonds that do not lie on the diameter cost some per cent.
local talus = require "talus"
local u = talus.units
local disc = require "parts.flattened_disc"

local size = talus.param("size", 1.78*u.mm, "triangle edge, m")

local body = talus.region { name = "disc", outline = disc.outline(size), material = disc.rock, mesh = { size = size },
                            joint = disc.joint() }
local sim, seen = disc.break_up(body, { title = "Flattened disc, without a flaw", output = { dir = "out/disc" } })

print(string.format("%d blocks; first crack at (%.1f, %.1f) mm, %.2f kN/m; split at %.2f kN/m; %.1f mm cracked in tension, %.1f mm"
                    .. " in shear", #sim.blocks, 1e3*seen.first.x, 1e3*seen.first.y, seen.initiation/u.kN, seen.splitting/u.kN,
                    1e3*sim.cracks.tension, 1e3*sim.cracks.shear))
talus.check.truth("split in two", seen.split)
talus.check.near("splitting load, kN/m", seen.splitting/u.kN, 40.1, { rel = 0.05 })
talus.check.below("first crack, distance from the loaded diameter / D", math.abs(seen.first.x)/(2*disc.radius), 0.1)
talus.check.above("failed length within 0.1 D of the loaded diameter",
                  disc.share(seen, function(x) return math.abs(x) < 0.2*disc.radius end), 0.95)
