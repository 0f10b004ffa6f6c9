-- 17. 10 to 1e5 blocks: time per step grows with exponent ≤ 1.05 flying, ≤ 1.4 at rest with the factor kept, ≤ 1.6 refactoring
-- (bare CHOLMOD: 1.36 solve, 1.54 factor). Exponents between the two largest sizes and over the whole range.
-- At rest: walls of bricks that stand, in whose steps nothing is solved. Refactoring: the same walls, each brick in motion and every step solved with factors (solver = "factor");
-- the time is that of a step over its factorisations, whose number is not the solver's growth.
-- Source: operation counts of nested dissection. Run: scripts/run tests/hard/17_growth.lua -p full=true
-- Full only.
local talus = require "talus"
local full = talus.param("full", false, "up to 1e5 flying and 1e4 at rest; otherwise 1e4 and 900")
local g = 9.81
local rock = talus.material { name = "rock", density = 2600, young = 1e9, poisson = 0.25 }
local joint = talus.joint { name = "bed", friction = math.rad(30) }

local function seconds(sim, steps)
  local cpu, factorisations = os.clock(), sim.totals.factorisations
  for _ = 1, steps do sim:step() end
  return (os.clock() - cpu)/steps, (sim.totals.factorisations - factorisations)/steps
end
local function flying(n)
  local blocks = {}
  for i = 1, n do
    for j = 1, n do blocks[#blocks + 1] = talus.rect(1.5*i, 1.5*j, 1.5*i + 1, 1.5*j + 1) end
  end
  return talus.simulation { gravity = {0, -g}, contact = joint,
    regions = { talus.region { name = "blocks", blocks = blocks, material = rock, velocity = {1, 0} } },
    time = { mode = "dynamic", t_end = 100, dt = 1e-3 } }, #blocks
end
local function wall(n, solver)
  local sim = talus.simulation { gravity = {0, -g}, contact = joint,
    regions = { talus.region { name = "slab", outline = talus.rect(-1, -1, n + 2, 0), material = rock, held = true },
                talus.region { name = "wall", material = rock,
                  blocks = talus.running_bond { at = {0, 0}, courses = n, per_course = n, length = 1, height = 0.5 } } },
    time = { mode = "dynamic", t_end = 100, dt = 1e-3, start = "settled" }, numerics = { solver = solver } }
  return sim, #sim.blocks
end
local function shaken(n)
  local sim, count = wall(n, "factor")
  sim:step()
  for i = 2, count do sim.blocks[i].velocity = { 1e-3*math.sin(i), 1e-3*math.cos(3*i) } end
  return sim, count
end
-- The sizes by turns, the least time of three: what else the machine does at times is not the growth.
local function growth(name, make, sizes, steps, bound)
  local sims, counts, times = {}, {}, {}
  for i, n in ipairs(sizes) do
    sims[i], counts[i] = make(n)
    sims[i]:step()
    times[i] = math.huge
  end
  for _ = 1, 3 do
    for i, sim in ipairs(sims) do
      local time, factorisations = seconds(sim, steps[i])
      if make == shaken then time = time/factorisations end
      times[i] = math.min(times[i], time)
      print(string.format("COST  %s  %d blocks, %.3g ms %s", name, counts[i], 1e3*time, make == shaken and string.format("a factorisation, %.2f a step", factorisations) or "a step"))
    end
  end
  for _, sim in ipairs(sims) do sim:stop() end
  local last = #sizes
  local function exponent(a, b) return math.log(times[b]/times[a])/math.log(counts[b]/counts[a]) end
  talus.check.below(name .. ": exponent between the two largest", exponent(last - 1, last), bound)
  print(string.format("COST  %s  exponent over the whole range %.3g", name, exponent(1, last)))
end
-- The search looks for neighbours anew every few steps: in as many steps of the two largest as often. Where the system counts CPU time by ticks of some
-- milliseconds each measurement takes many of them.
growth("flying", flying, full and { 4, 10, 32, 100, 316 } or { 10, 32, 100 }, full and { 2000, 1000, 200, 48, 48 } or { 100, 30, 10 }, 1.05)
growth("at rest", wall, full and { 4, 10, 20, 40, 70, 100 } or { 10, 20, 30 }, full and { 4000, 2000, 1000, 400, 200, 100 } or { 1000, 400, 200 }, 1.4)
growth("refactoring", shaken, full and { 10, 20, 40, 70 } or { 10, 20, 30 }, full and { 20, 10, 5, 3 } or { 20, 10, 5 }, 1.6)
