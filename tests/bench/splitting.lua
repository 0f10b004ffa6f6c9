-- The splitting load of the flattened disc of Ning et al. (2011) with a bonded trace along the diameter, so that every mesh has the same
-- path, and blocks of 0.8 mm at the flats, so that each has the pressure of the plates. The run with the most blocks is what the others are compared with.
package.path = "tests/verify/?.lua;" .. package.path
local talus = require "talus"
local u = talus.units
local disc = require "parts.flattened_disc"
local size, order = talus.param("size", 2, "edge, mm")*u.mm, talus.param("order", 1, "of the blocks")
local diameter = talus.trace { points = { {0, -disc.half_height}, {0, disc.half_height} }, bonded = true }
local body = talus.region { name = "disc", outline = disc.outline(size), material = disc.rock, mesh = disc.mesh(size), joint = disc.joint(),
                            cuts = diameter, order = order }
local sim, seen = disc.break_up(body, nil, { until_through = true })
print(("BENCH %d %.9g value"):format(#sim.blocks, seen.splitting or 0/0))
