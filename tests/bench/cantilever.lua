-- The paper's cantilever by one way of bonding, against 2D elasticity (tip deflection).
local talus = require "talus"
local u = talus.units
local bond = talus.param("bond", "exact", "exact or spring (40E at each end of an edge)")
local size = talus.param("size", 0.12, "edge length of the mesh, m")
local rock = talus.material { name = "rock", density = 2500, young = 35*u.GPa, poisson = 0.3, plane = "stress" }
local joint = talus.joint { name = "bond", bond = bond, shear_ratio = bond == "spring" and 1/2.5 or nil,
                            stiffness = bond == "spring" and { per = "contact", value = 40*35*u.GPa } or nil }
local sim = talus.simulation {
  regions = { talus.region { name = "beam", outline = talus.rect(0, 0, 8, 1), material = rock, mesh = { size = size }, joint = joint } },
  fix = { talus.fix { region = "beam", on = "left" } },
  loads = { talus.point_load { at = {7.9, 1}, force = {0, -5*u.kN} } },
  probes = { tip = {7.9, 0.5} }, time = { mode = "static" },
}
sim:run()
print(string.format("BENCH | %d | %d | tip deflection %.2g %%", #sim.blocks, sim.totals.steps,
                    100*math.abs(sim.probes.tip.uy/-2.845853e-4 - 1)))
