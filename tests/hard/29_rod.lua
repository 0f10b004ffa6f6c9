-- 29. A slender rod slides on its tip over a rough floor (friction coefficients up to 4, both ways): Painlevé's paradox, where rigid bodies have no
-- solution or two. At most 5 % of the steps cut, at most 10 iterations, no gain of 1e-6 of the energy at the start in a step, and it lies at the end.
-- Source: energy. Ours: at a coefficient of 4 every fifth step is cut. (0.5 s CPU)
local talus = require "talus"
local tools = require "tools"
local g = tools.g
local young, l, w, a = 10e9, 1, 0.04, math.rad(50)
local rock = talus.material { name = "rock", density = 2500, young = young, poisson = 0.2 }
local c, s = math.cos(a), math.sin(a)
for _, mu in ipairs { 0.5, 2, 4 } do
  for _, v in ipairs { 3, -3 } do
    local sim = talus.simulation {
      gravity = {0, -g}, contact = talus.joint { name = "rough", friction = math.atan(mu) },
      regions = { talus.region { name = "floor", outline = talus.rect(-20, -1, 20, 0), material = rock, held = true },
                  talus.region { name = "rod", outline = { {0, 0}, {l*c, l*s}, {l*c - w*s, l*s + w*c}, {-w*s, w*c} }, material = rock, velocity = {v, 0} } },
      time = { mode = "dynamic", t_end = 2, dt = 1e-3 },
    }
    local gain = tools.gains(sim)
    local seen = tools.watch(sim, gain)
    local label = string.format("rod, friction %g, %g m/s: ", mu, v)
    talus.check.below(label .. "part of the steps that were cut", seen.cut_steps/seen.steps, 0.05)
    talus.check.below(label .. "most iterations of a step", seen.most_iterations, 10.5)
    talus.check.below(label .. "largest gain of energy in a step over kinetic + stored", gain(), 1e-6)
    talus.check.below(label .. "height of its middle at the end, m", sim.blocks[2].centroid[2], 0.025)
  end
end
