-- The paper's cantilever bonded from about 1340 triangles: deflection and stress against 2D elasticity.
-- Run: scripts/run examples/02_cantilever.lua -p size=0.12      (0.2 s CPU)
-- Teaches: meshing a region, exact bonds, fixed edges, point loads, static mode, checks.
-- Picture: docs/pictures/02_cantilever.svg (displacements × 800)
-- Source: Ning, Yang, An & Ma (2011), Fig. 1 and Table 1; reference values from quadratic elements, converged.
local talus = require "talus"
local u = talus.units

local size = talus.param("size", 0.12, "triangle edge, m")
local rock = talus.material { name = "rock", density = 2500, young = 35*u.GPa, poisson = 0.3, plane = "stress" }
local bond = talus.joint { name = "bond", friction = 70*u.deg, cohesion = 30*u.MPa, tension = 15*u.MPa }

local sim = talus.simulation {
  regions = { talus.region { name = "beam", outline = talus.rect(0, 0, 8, 1), material = rock,
                             mesh = { size = size }, joint = bond } },
  fix    = { talus.fix { region = "beam", on = talus.line(0, 0, 0, 1) } },
  loads  = { talus.point_load { at = {7.9, 1}, force = {0, -5*u.kN} } },
  probes = { tip = {7.9, 0.5}, top = {4, 1}, axis = {4, 0.5} },
  time   = { mode = "static" },
  output = { dir = "out/cantilever", picture = { field = "sxx", scale = 800 } },
}
sim:run()
talus.check.near("tip deflection", sim.probes.tip.uy, -2.845853e-4, { rel = 0.016 })
talus.check.near("sigma x at (4, 1)", sim.probes.top.sxx, 1.17e5, { rel = 0.022 })
talus.check.near("tau at (4, 0.5)", sim.probes.axis.sxy, -7499.997, { rel = 0.04 })
