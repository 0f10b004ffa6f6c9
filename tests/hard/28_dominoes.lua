-- 28. Twenty dominoes (0.08 × 1 m) of which the first is pushed: all fall, the speed along the row stays bounded by the fall of one, at most
-- 5 % of the steps are cut, and no step gains 1e-6 of the energy at the start.
-- Source: energy. Ours: leaning on each other corner on face, stick and slip of the row alternate and steps are cut. (full: 20; quick: 8)
local talus = require "talus"
local tools = require "tools"
local g = tools.g
local full = talus.param("full", false, "20 dominoes instead of 8")
local n, young = full and 20 or 8, 10e9
local rock = talus.material { name = "rock", density = 2500, young = young, poisson = 0.2 }
local blocks = {}
for i = 1, n do blocks[i] = talus.rect(0.3*i, 0, 0.3*i + 0.08, 1) end
local sim = talus.simulation {
  gravity = {0, -g}, contact = talus.joint { name = "contact", friction = math.rad(30) },
  regions = { talus.region { name = "floor", outline = talus.rect(-20, -1, 20, 0), material = rock, held = true },
              talus.region { name = "dominoes", blocks = blocks, material = rock } },
  time = { mode = "dynamic", t_end = 0.15*n + 1, dt = 1e-3 },
}
sim.blocks[2].velocity, sim.blocks[2].spin = {0.5, 0}, -1
local gain, fastest = tools.gains(sim), 0
local seen = tools.watch(sim, function()
  gain()
  fastest = math.max(fastest, tools.fastest(sim))
end)
tools.cost("dominoes", seen, n)
talus.check.below("dominoes: rotation of the last, rad", sim.blocks[n + 1].rotation, -1)
talus.check.below("dominoes: largest speed over root of 2gH", fastest/math.sqrt(2*g*1), 1.05)
talus.check.below("dominoes: part of the steps that were cut", seen.cut_steps/seen.steps, 0.05)
talus.check.below("dominoes: largest gain of energy in a step over kinetic + stored", gain(), 1e-6)
