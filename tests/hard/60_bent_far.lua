-- Ours. Static runs of bonded bodies, whose bonds can fail, under their weight. A body that nothing touches was held so that it moved by no more than a hundredth of the scene's height in a solve, by a hold of nothing:
-- a cantilever of 10 m by 0.5 m of 10 GPa, which sags by 6 cm, ended with "no equilibrium", as 11 of 60 random beams did. And all of its weight came in the first increment: past the load of
-- the first crack by any factor, and where it bends far with 3 to 10 % of its work unexplained.
-- Source: the same beam of bonds that cannot fail; the same weight as a body force that a table raises; the ledger, each term integrated on its own; theory, § 9. (2 s CPU)
-- Run: scripts/run tests/hard/60_bent_far.lua -p full=true    (softer and stiffer beams and 60 random ones, 20 s of CPU; otherwise the 11 that ended)
local talus = require "talus"
local tools = require "tools"
local full = talus.param("full", false, "all 60 random beams, not only the 11 that ended")

local function off(sim) return math.abs(sim.energy.unexplained)/sim.energy.scale end

-- 10 m by 0.5 m, held at the left. `strength`: Pa, of its bonds, or nil: they cannot fail. `beside`: something else is there, 9 m below.
local function cantilever(young, strength, beside, weight)
  local rock = talus.material { name = "rock", density = 1000, young = young, poisson = 0 }
  local bond = strength and talus.joint { name = "bond", friction = 0.5, cohesion = strength, tension = strength }
  local regions = { talus.region { name = "beam", outline = talus.rect(0, 0, 10, 0.5), material = rock, order = 2, mesh = { kind = "cross", nx = 40, ny = 2 }, joint = bond,
                                   body_force = weight and { 0, weight } } }
  if beside then
    regions[2] = talus.region { name = "floor", outline = talus.rect(-5, -9, 12, -8.5), material = rock, held = true }
    regions[3] = talus.region { name = "block", outline = talus.rect(0, -8.5, 1, -8), material = rock }
  end
  return talus.simulation { gravity = { 0, weight and 0 or -10 }, contact = talus.joint { friction = 0.5 }, regions = regions, fix = { talus.fix { region = "beam", on = talus.line(0, 0, 0, 0.5) } },
    probes = { tip = { at = {10, 0.25}, region = "beam" } }, time = { mode = "static", t_end = 1, steps = 1 } }
end

for _, young in ipairs(full and { 1e11, 1e10, 1e9, 1e8 } or { 1e10, 1e9 }) do
  local elastic = cantilever(young)
  elastic:run()
  for _, beside in ipairs { false, true } do
    local sim = cantilever(young, 1e12, beside)
    sim:run()
    local label = string.format("cantilever of %g GPa that could break, %s: ", young/1e9, beside and "beside a block" or "alone")
    talus.check.near(label .. "its sag over that of one that cannot", sim.probes.tip.uy/elastic.probes.tip.uy, 1, { rel = 1e-6 })
    talus.check.below(label .. "unexplained", off(sim), 1e-2)
    if not beside and young >= 1e9 then talus.check.below(label .. "factorisations", sim.totals.factorisations, 6) end
  end
end

-- The load at which the first bond fails, by the sag there: of a weight that comes with the start, and of one that a table raises.
local function first_crack(sim)
  repeat sim:step() until sim.totals.failures > 0 or sim.finished
  return sim.probes.tip.uy
end
for _, young in ipairs(full and { 1e9, 1e10 } or { 1e9 }) do
  local sim = cantilever(young, 2e6)
  local label = string.format("cantilever of %g GPa and 2 MPa: ", young/1e9)
  talus.check.near(label .. "sag with the first crack, over that under a weight that a table raises", first_crack(sim)/first_crack(cantilever(young, 2e6, false, {{0, 0}, {1, -1e4}})), 1, { rel = 1e-2 })
  local most = off(sim)
  repeat sim:step() most = math.max(most, off(sim)) until sim.finished
  talus.check.below(label .. "unexplained, most of all load steps", most, 1e-2)
end

-- Held at one end or both, on ledges, or between two; under its weight, a load on top, or both.
local function random_beam(seed)
  local random = tools.random(7919*seed + 13)
  local young = 10^(8 + 2.5*random())
  local rock = talus.material { name = "rock", density = 2500, young = young, poisson = 0.3*random() }
  local L, h = 1 + 5*random(), 0.3 + 0.7*random()
  local g = random() < 0.7 and tools.g or 0
  local bending = 2500*tools.g*L*L/h
  local strength = bending*10^(-0.5 + 1.5*random())
  local bond = talus.joint { name = "bond", friction = 0.3 + 0.5*random(), tension = strength, cohesion = strength*(1 + 2*random()), residual = { friction = 0.2 + 0.4*random() } }
  local kind = ({ "triangles", "voronoi", "cross" })[1 + math.floor(3*random())]
  local mesh = kind == "cross" and { kind = kind, nx = math.ceil(2*L/h), ny = 2 } or { kind = kind, size = h/(1 + 2*random()) }
  local regions = { talus.region { name = "body", outline = talus.rect(0, 0, L, h), mesh = mesh, order = random() < 0.5 and 1 or 2, material = rock, joint = bond } }
  local function held(x0, y0, x1, y1) regions[#regions + 1] = talus.region { name = "held " .. #regions, outline = talus.rect(x0, y0, x1, y1), material = rock, held = true } end
  local fix, how = {}, math.floor(4*random())
  if how < 2 then fix[1] = talus.fix { region = "body", on = talus.line(0, 0, 0, h) } end
  if how == 1 then fix[2] = talus.fix { region = "body", on = talus.line(L, 0, L, h) } end
  if how == 2 then
    held(-1, -1, 0.2*L, 0)
    held(0.8*L, -1, L + 1, 0)
  elseif how == 3 then
    held(-1, -1, 0.4*L, 0)
    held(-1, h, 0.4*L, h + 1)
  end
  local loads, loaded = {}, random() < 0.5
  if g == 0 or loaded then
    local p = -5*bending*h*h/L/L*random()
    loads[1] = talus.edge_load { region = "body", on = "top", traction = { 0, random() < 0.5 and p or { {0, 0}, {1, p} } } }
  end
  return talus.simulation { gravity = { 0, -g }, contact = talus.joint { friction = 0.2 + 0.4*random() }, regions = regions, fix = fix, loads = loads,
    time = { mode = "static", steps = 1 + math.floor(10*random()), t_end = 1 } }
end
local seeds = { 1, 17, 19, 23, 26, 29, 35, 42, 45, 51, 53 }
if full then
  for seed = 1, 60 do seeds[seed] = seed end
end
local most, failures = 0, 0
for _, seed in ipairs(seeds) do
  local sim = random_beam(seed)
  repeat sim:step() most = math.max(most, off(sim)) until sim.finished
  failures = failures + sim.totals.failures
  print(string.format("COST  beam %d: %d blocks, %d load steps, %d bonds failed, %d factorisations", seed, #sim.blocks, sim.totals.steps, sim.totals.failures, sim.totals.factorisations))
end
talus.check.below("random beams: unexplained, most of all load steps", most, 1e-2)
talus.check.above("random beams: bonds that failed", failures, 10)
