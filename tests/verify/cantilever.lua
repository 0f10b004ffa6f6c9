-- The paper's cantilever (8 m x 1 m, 5 kN at x = 7.9 m): its own numbers with its own choices (Ning et al. 2011, Table 1), and
-- 2D elasticity (quadratic finite elements, converged to the digits given) with exact bonds.
local talus = require "talus"
local u = talus.units
local rock = talus.material { name = "rock", density = 2500, young = 35*u.GPa, poisson = 0.3, plane = "stress" }
local xs = { 1, 2, 3, 4, 5, 6, 7, 7.9 }

local function run(mesh, joint, numerics)
  local probes = {}
  for i, x in ipairs(xs) do
    probes["a" .. i] = {x, 0.5}
    probes["t" .. i] = {x, 1}
  end
  local sim = talus.simulation {
    regions = { talus.region { name = "beam", outline = talus.rect(0, 0, 8, 1), material = rock, mesh = mesh, joint = joint } },
    fix = { talus.fix { region = "beam", on = talus.line(0, 0, 0, 1) } },
    loads = { talus.point_load { at = {7.9, 1}, force = {0, -5*u.kN} } },
    probes = probes, time = { mode = "static" }, numerics = numerics,
  }
  sim:run()
  return sim
end

-- Ning et al. (2011), Table 1; the mesh and stiffness that give it: shared facts, section 1.
local paper = run({ kind = "cross", nx = 67, ny = 5 },
                  talus.joint { name = "paper", friction = 70*u.deg, cohesion = 30*u.MPa, tension = 15*u.MPa,
                                stiffness = { per = "contact", times_young = 90 } }, talus.profile.ning2011)
local printed_s = { 2.020, 1.739, 1.424, 1.144, 0.863, 0.548, 0.272 }
local printed_f = { .007, .025, .054, .091, .135, .184, .236, .285 }
for i = 1, 7 do
  talus.check.near("paper sigma x at " .. xs[i], paper.probes["t" .. i].raw_sxx, printed_s[i]*1e5, { rel = 0.005 })
end
for i = 1, 8 do
  talus.check.near("paper deflection, mm, at " .. xs[i], -paper.probes["a" .. i].uy*1e3, printed_f[i], { abs = 0.0005 })
end

local tip, elastic_s = -2.845853e-4, { 2.069918e5, 1.77e5, 1.47e5, 1.17e5, 8.700005e4, 5.699389e4, 2.734290e4 }
local elastic_t = { -7526.165, -7499.98, -7499.996, -7499.997, -7499.998, -7499.99, -7516.864 }
local function bond(penalty)
  return talus.joint { name = "bond", friction = 70*u.deg, cohesion = 30*u.MPa, tension = 15*u.MPa, penalty = penalty }
end
local function tip_error(sim) return math.abs(sim.probes.a8.uy/tip - 1) end
-- Order in the mean size of the blocks, which goes with the root of their number.
local function rate(coarse, fine, blocks) return 2*math.log(coarse/fine)/math.log(blocks) end

-- Exact bonds on unstructured meshes; 0.12 is the one the bounds were set for, the others are like it.
local coarse
for _, size in ipairs { 0.12, 0.115, 0.125 } do
  local exact = run({ size = size }, bond())
  coarse = coarse or exact
  local label = string.format("elasticity, size %g: ", size)
  talus.check.near(label .. "tip deflection, m", exact.probes.a8.uy, tip, { rel = 0.016 })
  for i = 1, 7 do
    talus.check.near(label .. "sigma x at " .. xs[i], exact.probes["t" .. i].sxx, elastic_s[i], { rel = 0.022 })
    talus.check.near(label .. "tau at " .. xs[i], exact.probes["a" .. i].sxy, elastic_t[i], { rel = 0.04 })
  end
end

-- Rates under refinement, over two halvings of unstructured meshes and one of similar ones.
local fine = run({ size = 0.03 }, bond())
talus.check.above("rate of the tip deflection, size 0.12 to 0.03", rate(tip_error(coarse), tip_error(fine), #fine.blocks/#coarse.blocks), 1.8)
talus.check.above("rate of the tip deflection, cross 64x8 to 128x16",
                  rate(tip_error(run({ kind = "cross", nx = 64, ny = 8 }, bond())),
                       tip_error(run({ kind = "cross", nx = 128, ny = 16 }, bond())), 4), 1.8)

-- The penalty coefficient times 100. Its limit is the conforming linear element, whose error the stiffer of the
-- two does not quite reach: the spread is held against that one.
local coarse_stiff, fine_stiff = run({ size = 0.12 }, bond(110)), run({ size = 0.03 }, bond(110))
local coarse_spread = math.abs(tip_error(coarse_stiff) - tip_error(coarse))
local fine_spread = math.abs(tip_error(fine_stiff) - tip_error(fine))
talus.check.below("penalty x 1 to x 100: spread of the tip deflection, size 0.12", coarse_spread, tip_error(coarse_stiff))
talus.check.below("penalty x 1 to x 100: spread of the tip deflection, size 0.03", fine_spread, tip_error(fine_stiff))
talus.check.above("penalty x 1 to x 100: rate of the spread", rate(coarse_spread, fine_spread, #fine.blocks/#coarse.blocks), 1.8)

-- 40E springs: their compliance h/(80E) per joint softens the beam while linear elements stiffen it. The two errors
-- cancel at one mesh; finer meshes have more joints, and the answer leaves the elastic one for good.
local function springs(size)
  return run({ size = size }, talus.joint { name = "springs", friction = 70*u.deg, cohesion = 30*u.MPa, tension = 15*u.MPa,
             bond = "spring", stiffness = { per = "contact", value = 40*35*u.GPa }, shear_ratio = 1/2.5 })
end
local soft, softer = tip_error(springs(0.12)), tip_error(springs(0.03))
talus.check.above("40E springs do not converge: tip error at size 0.03 against that at 0.12", softer/soft, 1)
