-- The paper's cantilever: its own numbers with its own choices, and 2D elasticity with exact bonds.
local talus = require "talus"
local u = talus.units
local rock = talus.material { name = "rock", density = 2500, young = 35*u.GPa, poisson = 0.3, plane = "stress" }
local xs = { 1, 2, 3, 4, 5, 6, 7, 7.9 }

local function run(mesh, joint)
  local probes = {}
  for i, x in ipairs(xs) do
    probes["a" .. i] = {x, 0.5}
    probes["t" .. i] = {x, 1}
  end
  local sim = talus.simulation {
    regions = { talus.region { name = "beam", outline = talus.rect(0, 0, 8, 1), material = rock, mesh = mesh, joint = joint } },
    fix = { talus.fix { region = "beam", on = talus.line(0, 0, 0, 1) } },
    loads = { talus.point_load { at = {7.9, 1}, force = {0, -5*u.kN} } },
    probes = probes, time = { mode = "static" },
  }
  sim:run()
  return sim
end

-- Ning et al. (2011), Table 1; the mesh and stiffness that give it: shared facts, section 1.
local paper = run({ kind = "cross", nx = 67, ny = 5 },
                  talus.joint { name = "paper", friction = 70*u.deg, cohesion = 30*u.MPa, tension = 15*u.MPa, bond = "spring",
                                stiffness = { per = "contact", value = 90*35*u.GPa }, shear_ratio = 1/2.5 })
local printed_s = { 2.020, 1.739, 1.424, 1.144, 0.863, 0.548, 0.272 }
local printed_f = { .007, .025, .054, .091, .135, .184, .236, .285 }
for i = 1, 7 do
  talus.check.near("paper sigma x at " .. xs[i], paper.probes["t" .. i].raw_sxx, printed_s[i]*1e5, { rel = 0.005 })
end
for i = 1, 8 do
  talus.check.near("paper deflection, mm, at " .. xs[i], -paper.probes["a" .. i].uy*1e3, printed_f[i], { abs = 0.0005 })
end

local elastic_s = { 2.069918e5, 1.77e5, 1.47e5, 1.17e5, 8.700005e4, 5.699389e4, 2.734290e4 }
local elastic_t = { -7526.165, -7499.98, -7499.996, -7499.997, -7499.998, -7499.99, -7516.864 }
local bond = talus.joint { name = "bond", friction = 70*u.deg, cohesion = 30*u.MPa, tension = 15*u.MPa }
local exact = run({ size = 0.12 }, bond)
talus.check.near("elasticity: tip deflection", exact.probes.a8.uy, -2.845853e-4, { rel = 0.016 })
for i = 1, 7 do
  talus.check.near("elasticity: sigma x at " .. xs[i], exact.probes["t" .. i].sxx, elastic_s[i], { rel = 0.022 })
  talus.check.near("elasticity: tau at " .. xs[i], exact.probes["a" .. i].sxy, elastic_t[i], { rel = 0.04 })
end

-- Rate under refinement, on similar meshes: errors against elasticity fall as h^1.8 or faster.
local function tip_error(nx, ny)
  return math.abs(run({ kind = "cross", nx = nx, ny = ny }, bond).probes.a8.uy / -2.845853e-4 - 1)
end
local coarse, fine = tip_error(32, 4), tip_error(64, 8)
talus.check.above("rate of the tip deflection under refinement", math.log(coarse/fine, 2), 1.8)
