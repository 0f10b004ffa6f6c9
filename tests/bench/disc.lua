-- One turn of a free disc of bonded blocks, against the centrifugal stress at its centre (mean over the turn).
local talus = require "talus"
local u = talus.units
local size = talus.param("size", 0.2, "edge length of the mesh, m")
local spin, density, poisson = 50, 2500, 0.25
local rock = talus.material { name = "rock", density = density, young = 20*u.GPa, poisson = poisson }
local turn = 2*math.pi/spin
local sim = talus.simulation {
  regions = { talus.region { name = "disc", outline = talus.circle { at = {0, 0}, radius = 1, sides = 64 }, material = rock,
                             mesh = { size = size }, spin = spin } },
  probes = { centre = {0, 0} }, time = { mode = "dynamic", t_end = 2*turn, dt = turn/200 },
}
local sum, count = 0, 0
for _ in sim:steps() do
  if sim.time > turn then sum, count = sum + (sim.probes.centre.sxx + sim.probes.centre.syy)/2, count + 1 end
end
print(string.format("BENCH | %d | %d | stress at the centre %.2g %%", #sim.blocks, sim.totals.steps,
                    100*math.abs(sum/count/((3 + poisson)/8*density*spin^2) - 1)))
