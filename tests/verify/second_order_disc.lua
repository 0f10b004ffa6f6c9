-- The flattened disc of Ning et al. (2011), Fig. 6, in some 350 second-order blocks. On an unstructured mesh a crack goes along what
-- edges there are, and each that is 15 degrees off the loaded diameter takes 7 % more load; here a bonded trace along the diameter
-- gives every mesh the same path, and blocks of 0.8 mm at the flats the same pressure of the plates, so that what is left is the error of
-- the stress. Source: the splitting load of first-order blocks of 1.8 mm (1460) on the same path. (4 s CPU)
local talus = require "talus"
local u = talus.units
local disc = require "parts.flattened_disc"

local function splitting(size, order)
  local diameter = talus.trace { points = { {0, -disc.half_height}, {0, disc.half_height} }, bonded = true }
  local body = talus.region { name = "disc", outline = disc.outline(size), material = disc.rock, mesh = disc.mesh(size), joint = disc.joint(),
                              cuts = diameter, order = order }
  local sim, seen = disc.break_up(body, nil, { until_through = true })
  return seen.splitting, seen, sim
end

local fine = splitting(1.8*u.mm, 1)
for _, size in ipairs { 4.2, 4.0 } do
  local load, seen, sim = splitting(size*u.mm, 2)
  local label = ("%d second-order blocks: "):format(#sim.blocks)
  talus.check.truth(label .. "split", seen.through ~= nil)
  talus.check.near(label .. "splitting load against first order at 1.8 mm", load/fine, 1, { abs = 0.02 })
  talus.check.below(label .. "unexplained energy, of the work put in", math.abs(sim.energy.unexplained)/sim.energy.scale, 0.01)
end
