-- Many heaps of which one moves: 100 of about 1000 bricks, each piled up and at rest under its weight; one bursts, then all do.
-- With sleeping, a step in which one moves costs at most 3 % of one in which all do, in at most 4 GB. What sleeps keeps
-- places and forces to the bit, and takes them on when it is hit. Source: cost that follows what changed.
-- Limit: memory=4GB
-- Run: scripts/run tests/hard/heaps_100.lua -p full=true     (quick: 20 heaps of 48, and the bound is 12 %: what every step costs whatever moves is a part of that)
local talus = require "talus"
local full = talus.param("full", false, "100 heaps of 988 bricks instead of 20 of 48")
local heaps = talus.param("heaps", full and 100 or 20, "number of heaps")
local courses = talus.param("courses", full and 25 or 5, "of a heap")
local steps = talus.param("steps", full and 10 or 20, "measured, each time")
local g = 9.81
local rock = talus.material { name = "rock", density = 2600, young = 10e9, poisson = 0.2 }
local wide = talus.param("wide", full and 39 or 9, "bricks in a course")
local pitch, bricks = 2*(wide + 2), {}
for heap = 1, heaps do
  for _, brick in ipairs(talus.running_bond { at = {heap*pitch - wide/2, 0}, courses = courses, per_course = wide, length = 1, height = 0.5 }) do
    bricks[#bricks + 1] = brick
  end
end
local per_heap = #bricks//heaps
local sim = talus.simulation {
  gravity = {0, -g}, contact = talus.joint { name = "rough", friction = math.rad(35) },
  regions = { talus.region { name = "slab", material = rock, held = true, outline = talus.rect(0, -1, (heaps + 1)*pitch, 0) },
              talus.region { name = "bricks", blocks = bricks, material = rock } },
  time = { mode = "dynamic", t_end = 10, dt = 1e-3, start = "settled" },
  numerics = { sleeping = true },
}
-- Block 1 is the slab. Each brick of a heap flies off from the middle of its foot, at a speed that grows with its place.
local function burst(heap)
  for i = 2 + (heap - 1)*per_heap, 1 + heap*per_heap do
    local block = sim.blocks[i]
    local at = block.centroid
    block.velocity = { 0.2*(at[1] - heap*pitch), 0.2*(at[2] + 1) }
  end
end
local function cost()
  local cpu = os.clock()
  for _ = 1, steps do sim:step() end
  return (os.clock() - cpu)/steps
end
local function places(from, to)
  local list = {}
  for i = from, to do
    local block = sim.blocks[i]
    local at = block.displacement
    list[#list + 1] = string.format("%a %a %a", at[1], at[2], block.sxx)
  end
  return table.concat(list, " ")
end
for _ = 1, 20 do sim:step() end
local asleep = sim.totals.islands.asleep
sim:step()
talus.check.equal("heaps: asleep before one moves", sim.totals.islands.asleep - asleep, heaps)
local others = places(2 + per_heap, #sim.blocks)
burst(1)
sim:step()
sim:step()
asleep = sim.totals.islands.asleep
local one = cost()
talus.check.equal("heaps: asleep while one moves", (sim.totals.islands.asleep - asleep)/steps, heaps - 1)
talus.check.truth("heaps: those asleep lie where they lay, to the bit", places(2 + per_heap, #sim.blocks) == others)
for heap = 1, heaps do burst(heap) end
sim:step()
sim:step()
local all = cost()
print(string.format("COST  heaps, one moving of %d  %d blocks, %.3g ms a step; all moving %.3g ms: %.2f %%, %.0f s CPU", heaps,
  #sim.blocks - 1, 1e3*one, 1e3*all, 100*one/all, os.clock()))
talus.check.below("heaps: a step with one moving over one with all, by CPU", one/all, full and 0.03 or 0.12)
