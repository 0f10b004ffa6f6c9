-- A flattened disc with a notch across its centre at 45 degrees: wing cracks grow from both tips to the plates.
-- Run: scripts/run examples/07_notched_disc.lua               (4 s CPU)
--      scripts/run examples/07_notched_disc.lua -p dip=60     a steeper notch
-- Teaches: a trace that ends inside a meshed region is a crack; its own joint property; kinds of cracks.
-- Picture: docs/pictures/07_notched_disc_initiation.svg, docs/pictures/07_notched_disc.svg (split)
-- Source: Ning, Yang, An & Ma (2011), Fig. 7: notch of 1.5 cm at 45 degrees, its faces without friction, 1280 blocks.
local talus = require "talus"
local u = talus.units
local disc = require "parts.flattened_disc"

local size = talus.param("size", 1.85*u.mm, "triangle edge, m")
local dip = talus.param("dip", 45, "of the notch against the horizontal, degrees")
local length = 15*u.mm

local along = { length/2*math.cos(dip*u.deg), length/2*math.sin(dip*u.deg) }
local notch = talus.trace { points = { { -along[1], -along[2] }, along }, joint = talus.joint { name = "notch", friction = 0 } }
local body = talus.region { name = "disc", outline = disc.outline(size), material = disc.rock, mesh = { size = size },
                            joint = disc.joint(), cuts = { notch } }
local sim, seen = disc.break_up(body, { title = "Flattened disc with a notch", output = { dir = "out/notched_disc" } },
                                { height = disc.at_plates, blank = along[2] })

local function from_tip(crack, sign) return math.sqrt((crack.x - sign*along[1])^2 + (crack.y - sign*along[2])^2) end
local upper, lower, first_upper, first_lower = 0, 0, nil, nil
for _, crack in ipairs(seen.failed) do
  if crack.y > along[2] then upper, first_upper = math.max(upper, crack.y), first_upper or crack end
  if crack.y < -along[2] then lower, first_lower = math.max(lower, -crack.y), first_lower or crack end
end
print(string.format("%d blocks; first crack at (%.1f, %.1f) mm, %.2f kN/m; split at %.2f kN/m; cracks reach y = %.1f and %.1f mm",
                    #sim.blocks, 1e3*seen.first.x, 1e3*seen.first.y, seen.initiation/u.kN, seen.splitting/u.kN, -1e3*lower, 1e3*upper))
talus.check.truth("split in two", seen.split)
talus.check.equal("the first crack grows from the notch", seen.first.kind, "propagated")
talus.check.below("first crack, distance from a tip / edge", math.min(from_tip(seen.first, 1), from_tip(seen.first, -1))/size, 1.5)
talus.check.above("wings reach towards the plates, of the half height", math.min(upper, lower)/disc.half_height, 0.8)
