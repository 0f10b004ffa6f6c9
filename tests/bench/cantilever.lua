-- The paper's cantilever: tip deflection against 2D elasticity (quadratic elements, converged to 0.007 %).
local talus = require "talus"
local u = talus.units
local size = talus.param("size", 0.12, "edge length of the mesh, m")
local order = talus.param("order", 1, "of the blocks")
local bond = talus.param("bond", "exact", "exact or spring (40E at each end of an edge)")
local penalty = talus.param("penalty", 1.1, "of exact bonds, as multiple of the least that is stable")
local rock = talus.material { name = "rock", density = 2500, young = 35*u.GPa, poisson = 0.3, plane = "stress" }
local joint = talus.joint { name = "bond", bond = bond, shear_ratio = bond == "spring" and 1/2.5 or nil, penalty = penalty,
                            stiffness = bond == "spring" and { per = "contact", value = 40*35*u.GPa } or nil }
local sim = talus.simulation {
  regions = { talus.region { name = "beam", outline = talus.rect(0, 0, 8, 1), material = rock, mesh = { size = size }, joint = joint,
                             order = order } },
  fix = { talus.fix { region = "beam", on = "left" } },
  loads = { talus.point_load { at = {7.9, 1}, force = {0, -5*u.kN} } },
  probes = { tip = {7.9, 0.5} }, time = { mode = "static" },
}
sim:run()
local seconds, solves = sim.totals.seconds, sim.totals.factorisations
print(("BENCH %d %.6g"):format(#sim.blocks, math.abs(sim.probes.tip.uy/-2.845853e-4 - 1)))
print(("SOLVE %d %.6g %.6g"):format(#sim.blocks, seconds.assembly/solves, seconds["open-close and solve"]/solves))
