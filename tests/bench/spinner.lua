-- A free disc of bonded blocks for two turns: the centrifugal stress at its centre, mean over the second, against (3 + ν)/8 ρω²r².
local talus = require "talus"
local u = talus.units
local size, order = talus.param("size", 0.2, "edge, m"), talus.param("order", 1, "of the blocks")
local steps, theta = talus.param("steps", 200, "a turn"), talus.param("theta", 0.75, "of the scheme")
local spin, density, poisson = 50, 2500, 0.25
local turn = 2*math.pi/spin
local sim = talus.simulation {
  regions = { talus.region { name = "disc", outline = talus.circle { at = {0, 0}, radius = 1, sides = 64 }, order = order, spin = spin,
                             material = talus.material { density = density, young = 20*u.GPa, poisson = poisson }, mesh = { size = size } } },
  probes = { centre = {0, 0} }, numerics = { theta = theta }, time = { mode = "dynamic", t_end = 2*turn, dt = turn/steps },
}
local sum, count = 0, 0
for _ in sim:steps() do
  if sim.time > turn then sum, count = sum + (sim.probes.centre.sxx + sim.probes.centre.syy)/2, count + 1 end
end
print(("BENCH %d %.6g"):format(#sim.blocks, math.abs(sum/count/((3 + poisson)/8*density*spin^2) - 1)))
