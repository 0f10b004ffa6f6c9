-- A disc of bonded blocks that spins free for ten turns: stress and area keep to the centrifugal solution.
-- Source: rotating solid disc, plane stress (Timoshenko & Goodier, Theory of Elasticity, § 32):
-- at the centre (3 + nu)/8 rho w² R².
local talus = require "talus"
local u = talus.units
local radius, spin, density, poisson = 1, 50, 2500, 0.25
local rock = talus.material { name = "rock", density = density, young = 20*u.GPa, poisson = poisson }
local turn = 2*math.pi/spin

local sim = talus.simulation {
  regions = { talus.region { name = "disc", outline = talus.circle { at = {0, 0}, radius = radius, sides = 32 },
                             material = rock, mesh = { size = 0.195 }, spin = spin } },
  probes = { centre = {0, 0} },
  time = { mode = "dynamic", t_end = 10*turn, dt = turn/200 },
}
local function area()
  local sum = 0
  for _, a in ipairs(sim.blocks:field("area")) do sum = sum + a end
  return sum
end
local means, sum, count, areas = {}, 0, 0, {}
for _ in sim:steps() do
  local p = sim.probes.centre
  sum, count = sum + (p.sxx + p.syy)/2, count + 1
  if count == 200 then
    means[#means + 1], areas[#areas + 1] = sum/count, area()
    sum, count = 0, 0
  end
end
talus.check.near("blocks of the disc", #sim.blocks, 200, { abs = 40 })
local expected = (3 + poisson)/8*density*spin^2*radius^2
talus.check.near("disc, 10th turn: mean stress at the centre, Pa", means[10], expected, { rel = 0.02 })
talus.check.near("disc: stress of the 10th turn against the 3rd", means[10]/means[3], 1, { abs = 1e-3 })
talus.check.near("disc: area after the 10th turn against the 3rd", areas[10]/areas[3], 1, { abs = 1e-9 })
