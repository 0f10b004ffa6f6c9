-- 8. Penalty p/E from 1 to 1e6: error falls with slope −1 ± 0.05 to the mesh's own error or round-off; with the default (exact) bonds
-- the spread over coefficients × 1 to × 100 stays below the mesh's own error and falls with refinement at rate ≥ 1.8.
-- Springs: a pulled bar of ten blocks, whose mesh is exact, so that only round-off is left; u = PL/E. Exact bonds: the cantilever of
-- Ning et al. (2011) against 2D elasticity (quadratic elements, converged), v(7.9, 0.5) = −2.845853e-4 m. (6 s CPU)
local talus = require "talus"
local young = 35e9
local rock = talus.material { name = "rock", density = 2500, young = young, poisson = 0.3 }

local load = 100   -- Pa: loads act on edges as they are, so that strain itself is an error of this order
local function bar(p)
  local cuts = {}
  for i = 1, 9 do cuts[i] = talus.trace { points = { {i, -1}, {i, 2} }, bonded = true } end
  local sim = talus.simulation {
    regions = { talus.region { name = "bar", outline = talus.rect(0, 0, 10, 1), material = rock, cuts = cuts,
      joint = talus.joint { name = "spring", bond = "spring", tension = 1e12, cohesion = 1e12, stiffness = { per = "contact", times_young = p } } } },
    fix = { talus.fix { region = "bar", on = "left", y = false, x = true }, talus.fix { region = "bar", on = talus.point(0, 0), x = false, y = true } },
    loads = { talus.edge_load { region = "bar", on = "right", traction = {load, 0} } },
    probes = { a = {0.5, 0.5}, b = {9.5, 0.5} }, time = { mode = "static" },
  }
  sim:run()
  return math.abs((sim.probes.b.ux - sim.probes.a.ux)/(9*load/young) - 1)
end
local before
for exponent = 0, 6 do
  local error = bar(10^exponent)
  if before then
    talus.check.near(string.format("bar, springs of 1e%d E: slope of the error", exponent), math.log(error/before, 10), -1, { abs = 0.05 })
  end
  before = error
end

local tip = -2.845853e-4
local function cantilever(size, penalty)
  local sim = talus.simulation {
    regions = { talus.region { name = "beam", outline = talus.rect(0, 0, 8, 1), material = rock, mesh = { size = size },
      joint = talus.joint { name = "bond", tension = 15e6, cohesion = 30e6, penalty = penalty } } },
    fix = { talus.fix { region = "beam", on = talus.line(0, 0, 0, 1) } },
    loads = { talus.point_load { at = {7.9, 1}, force = {0, -5e3} } },
    probes = { tip = {7.9, 0.5} }, time = { mode = "static" },
  }
  sim:run()
  return math.abs(sim.probes.tip.uy/tip - 1), #sim.blocks
end
local spreads, counts = {}, {}
for i, size in ipairs { 0.12, 0.03 } do
  local errors = {}
  for _, factor in ipairs { 1, 3, 10, 30, 100 } do errors[#errors + 1], counts[i] = cantilever(size, 1.1*factor) end
  local low, high = math.min(table.unpack(errors)), math.max(table.unpack(errors))
  spreads[i] = high - low
  talus.check.below(string.format("cantilever, size %g: spread of the tip over penalty × 1 to × 100, over the mesh's own error", size), spreads[i]/high, 1)
end
talus.check.above("cantilever: rate of the spread under refinement", 2*math.log(spreads[1]/spreads[2])/math.log(counts[2]/counts[1]), 1.8)
