-- 21. 1 and 2 threads, two runs, and resume from a saved state: bit-identical state hash after 1000 steps of a collapsing pile.
-- A pile of 72 blocks collapses on a rough floor in 1000 steps. A second run, one that goes back to a state in memory and
-- one that goes on from a file end in the same state to the last bit; the hash of the state tells. No source: the answer
-- is the run itself. Threads and a restart of the program: tests/spec/saving.cases runs this scene for them.
local talus = require "talus"
local u = talus.units
local check = talus.check
local file = talus.param("file", "build/restart.state", "where the state is saved")
local once = talus.param("once", false, "runs the pile once and gives its hash, for tests/spec/saving.cases")
local steps = 1000

-- Tilted blocks of four sizes in a leaning stack, thrown sideways, with a push that the script changes on the way.
local function pile(backwards)
  local rock = talus.material { name = "rock", density = 2500, young = 1*u.GPa, poisson = 0.25 }
  local regions = { talus.region { name = "floor", outline = talus.rect(-20, -1, 30, 0), material = rock, held = true } }
  for row = 0, 11 do
    for column = 0, 5 do
      local size = 0.5 + 0.1*((3*row + column) % 4)
      local x, y, c, s = column*1.0 + 0.12*row, 0.1 + row*0.95, math.cos(0.06*(column - 2)), math.sin(0.06*(column - 2))
      local corners = {}
      for i, p in ipairs { {0, 0}, {size, 0}, {size, size}, {0, size} } do
        corners[i] = { x + c*p[1] - s*p[2], y + s*p[1] + c*p[2] }
      end
      regions[#regions + 1] = talus.region { name = ("block %d %d"):format(row, column), outline = talus.polygon(corners),
        material = rock, order = row % 3 == 0 and "rigid" or 1, velocity = {0.1*row, 0} }
    end
  end
  if backwards then
    for i = 1, #regions//2 do regions[i], regions[#regions + 1 - i] = regions[#regions + 1 - i], regions[i] end
  end
  return talus.simulation {
    gravity = {0, -9.81}, contact = talus.joint { name = "rough", friction = 30*u.deg }, regions = regions,
    loads = { talus.point_load { name = "push", region = "block 11 0", at = {1.5, 10.8}, force = {0, 0} } },
    on_step = function(sim)
      sim.state.steps = (sim.state.steps or 0) + 1
      if sim.state.steps == 40 then sim:load("push").force = {2*u.kN, 0} end
      if sim.state.steps == steps/2 + 100 then sim:material("rock").young = 1.2*u.GPa end
    end,
    time = { mode = "dynamic", t_end = 100, dt_max = 1e-3 },
  }
end

local names = { "kinetic", "strain", "contact", "gravity", "total", "external", "friction", "numerical", "unexplained", "scale" }

-- The energies as they are now: sim.energy itself follows the run.
local function ledger(sim)
  local terms = {}
  for i, name in ipairs(names) do terms[i] = sim.energy[name] end
  return terms
end

-- Half of the run. Its hash, and the energies at its start and after every 50 steps of it.
local function advance(sim)
  local rows = { ledger(sim) }
  for i = 1, steps/2 do
    sim:step()
    if i % 50 == 0 then rows[#rows + 1] = ledger(sim) end
  end
  return sim:hash(), rows
end

if once then
  local sim = pile()
  advance(sim)
  sim:log("the pile ends in %s", (advance(sim)))
  return
end

local function check_ledger(name, reached, expected)
  local different = 0
  for k, row in ipairs(expected) do
    for i, value in ipairs(row) do
      if reached[k][i] ~= value then different = different + 1 end
    end
  end
  check.equal(("%s: of %d energies, other in a bit"):format(name, #expected*#names), different, 0)
end

local one, two = pile(), pile()
local start = one:hash()
local half = advance(one)
local memory = one:save(file)
local done, course = advance(one)
local time = one.time
check.truth("the state has changed", start ~= half and half ~= done)
check.above("closed contacts at the end", one.last.closed_contacts, 30)

check.equal("second run, half-way", (advance(two)), half)
check.equal("second run, done", (advance(two)), done)

one:restore(memory)
check.equal("back in memory", one:hash(), half)
check.equal("Young's modulus, changed since, as it was", one:material("rock").young, 1*u.GPa)
check.equal("sim.state as it was", one.state.steps, steps/2)
local again, rows = advance(one)
check.equal("from memory", again, done)
check.equal("time", one.time, time)
check_ledger("from memory", rows, course)

local fresh = pile()
fresh:restore(file)
again, rows = advance(fresh)
check.equal("from the file", again, done)
check_ledger("from the file", rows, course)

-- Numbered the other way round every sum is rounded differently, which may not show before an iteration that barely
-- converges makes one of the two cut a step.
local forwards, backwards = pile(), pile(true)
for _ = 1, 300 do
  forwards:step()
  backwards:step()
end
local difference = 0
for i, block in ipairs(forwards.blocks) do
  local other = backwards.blocks[#backwards.blocks + 1 - i]
  difference = math.max(difference, math.abs(block.ux - other.ux), math.abs(block.uy - other.uy))
end
check.above("numbered backwards: closed contacts", forwards.last.closed_contacts, 5)
check.below("numbered backwards: difference of places, m", difference, 1e-10)

-- Walls under sudden gravity: what the last solution needed tells where the next one begins, and is part of the state.
local function wall()
  local brick = talus.material { name = "brick", density = 2500, young = 1*u.GPa, poisson = 0.25 }
  return talus.simulation {
    gravity = {0, -9.81}, contact = talus.joint { name = "bed", friction = math.atan(0.6) },
    regions = { talus.region { name = "slab", outline = talus.rect(-2, -1, 23, 0), material = brick, held = true },
                talus.region { name = "wall", material = brick,
                               blocks = talus.running_bond { at = {0, 0}, courses = 20, per_course = 20, length = 1, height = 0.5 } } },
    time = { t_end = 1, dt = 0.05, start = "rest" },
  }
end
local function run(sim, count)
  for _ = 1, count do sim:step() end
  return sim:hash()
end
for saved = 2, 5 do
  local whole, part = wall(), wall()
  run(whole, saved)
  local before = whole.totals.splittings
  local ended = run(whole, 3)
  check.above(("wall: iterations of the splitting after step %d"):format(saved), whole.totals.splittings - before, 0)
  run(part, saved)
  part:save(file)
  local other = wall()
  other:restore(file)
  check.equal(("wall: from step %d on, from the file"):format(saved), run(other, 3), ended)
end

-- A static run that is saved within a jump of its loads, where time stands still.
local function torn()
  local rock = talus.material { name = "rock", density = 2500, young = 1*u.GPa, poisson = 0.2 }
  return talus.simulation {
    gravity = {0, -9.81}, contact = talus.joint { name = "rough", friction = 30*u.deg },
    regions = { talus.region { name = "floor", outline = talus.rect(-1, -1, 11, 0), material = rock, held = true },
                talus.region { name = "bar", outline = talus.rect(0, 0, 10, 0.5), material = rock, mesh = { kind = "cross", nx = 20, ny = 1 },
                               joint = talus.joint { name = "bond", friction = 30*u.deg, tension = 0.02*u.MPa, cohesion = 0.02*u.MPa } } },
    fix = { talus.fix { region = "bar", on = "left", x = true },
            talus.fix { region = "bar", on = "right", x = true, displacement = { function(t) return t <= 1 and 0 or 0.5*u.mm end, 0 } } },
    time = { mode = "static", t_end = 2, steps = 4 },
  }
end
local within, inside = torn(), 0
for _ in within:steps() do
  if within.time > 1 and within.time < 1.001 then
    local state = within:save()
    inside = inside + 1
    local once = (within:step() and within:hash())
    within:restore(state)
    if within:step() and within:hash() ~= once then check.truth("within a jump of loads, again to the bit", false) end
  end
end
check.above("steps gone back to within a jump of loads", inside, 3)
check.equal("a static run with steps gone back to ends as one without", within:hash(), (function() local sim = torn() sim:run() return sim:hash() end)())

-- One that is saved between a change of the rock and the load step that it comes over.
local function softened()
  local rock = talus.material { name = "rock", density = 2500, young = 1*u.GPa, poisson = 0.2 }
  local sim = talus.simulation {
    gravity = {0, -9.81}, contact = talus.joint { name = "rough", friction = 30*u.deg },
    regions = { talus.region { name = "floor", outline = talus.rect(-1, -1, 4, 0), material = rock, held = true },
                talus.region { name = "block", outline = talus.rect(0, 0, 3, 3), material = rock, mesh = { size = 1 } } },
    time = { mode = "static", t_end = 2, steps = 2 },
  }
  sim:step()
  rock.young, rock.density = 0.5*u.GPa, 3000
  return sim
end
local soft = softened()
local state = soft:save()
soft:step()
local whole, put_in = soft:hash(), soft.energy.external
check.below("what the change of the rock put in, J/m", put_in, -5)
soft:restore(state)
soft:step()
check.equal("a static run that goes back to a change of its rock goes on as before", soft:hash(), whole)
