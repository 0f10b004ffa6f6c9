-- Islands and sleep. Two walls on one slab, shaken, move to the last bit as each does alone. A stack that sleeps until a
-- thrown block wakes it ends as one that never slept, to the last bit, as does a run that goes on from a state saved while
-- the stack was asleep. No source: each run is the other's.
local talus = require "talus"
local check = talus.check
local rock = talus.material { name = "rock", density = 2500, young = 1e9, poisson = 0.25 }
local joint = talus.joint { name = "rough", friction = math.rad(35) }
-- The same slab in all: lengths are measured from the middle of the scene.
local function slab() return talus.region { name = "slab", outline = talus.rect(-20, -1, 20, 0), material = rock, held = true } end
local function wall(name, x)
  return talus.region { name = name, material = rock, velocity = {0.5, 0},
    blocks = talus.running_bond { at = {x, 0}, courses = 5, per_course = 4, length = 1, height = 0.5 } }
end
local function bits(sim, region)
  local list = {}
  for _, block in ipairs(sim.blocks) do
    if block.region == region then
      local at, v = block.displacement, block.velocity
      list[#list + 1] = string.format("%a %a %a %a %a", at[1], at[2], v[1], v[2], block.sxx)
    end
  end
  return table.concat(list, "\n")
end
local function run(regions)
  local sim = talus.simulation { gravity = {0, -9.81}, contact = joint, regions = regions,
    time = { mode = "dynamic", t_end = 0.1, dt = 1e-3 } }
  sim:run()
  return sim
end
local both = run { slab(), wall("left", -15), wall("right", 8) }
check.truth("left wall of two as alone, to the bit", bits(both, "left") == bits(run { slab(), wall("left", -15) }, "left"))
check.truth("right wall of two as alone, to the bit", bits(both, "right") == bits(run { slab(), wall("right", 8) }, "right"))
check.above("two walls: islands a step", both.totals.islands.by_sweeps + both.totals.islands.with_factor, 199)

-- A stack of six at rest, and a block that slides to it along the slab and pushes it.
local function pushed(sleeping, push)
  local stack = {}
  for k = 1, 6 do stack[k] = talus.rect(0, k - 1, 1, k) end
  local sim = talus.simulation { gravity = {0, -9.81}, contact = joint,
    regions = { slab(), talus.region { name = "stack", blocks = stack, material = rock },
                talus.region { name = "thrown", outline = talus.rect(-6, 0, -5, 1), material = rock, velocity = {14, 0} } },
    loads = { talus.point_load { name = "push", region = "stack", at = {1, 5.5}, force = { push or 0, 0 } } },
    time = { mode = "dynamic", t_end = 4, dt = 1e-3, start = "settled" }, numerics = { sleeping = sleeping } }
  return sim
end
-- Places, speeds and stresses after each 50 steps, and the contacts' forces by pair of corner and edge.
local function story(sim, from, to)
  local list = {}
  for step = from, to do
    sim:step()
    if step % 50 == 0 then
      list[#list + 1] = bits(sim, "stack") .. bits(sim, "thrown")
      local contacts = {}
      for _, c in ipairs(sim.contacts) do
        contacts[#contacts + 1] = string.format("%d %d %d %d %a %a %a", c.block_i, c.vertex, c.block_j, c.edge, c.normal_force, c.shear_force, c.slip)
      end
      table.sort(contacts)
      list[#list + 1] = table.concat(contacts, "\n")
      list[#list + 1] = string.format("%a %a %a", sim.energy.kinetic, sim.energy.friction, sim.energy.numerical)
    end
  end
  return table.concat(list, "\n")
end
local awake, asleep = pushed(false), pushed(true)
local never, slept = story(awake, 1, 2000), story(asleep, 1, 2000)
check.truth("a stack that slept and was woken: all as without sleep, to the bit", never == slept)
check.above("a stack that slept: steps asleep", asleep.totals.islands.asleep, 300)
check.above("a stack that was hit: it moved, m", math.abs(asleep.blocks[2].displacement[1]), 1e-4)
check.below("a stack that slept: unexplained energy over the largest", math.abs(asleep.energy.unexplained)/asleep.energy.scale, 0.01)

local first = pushed(true)
story(first, 1, 300)
local saved, groups = first:save(), first.totals.islands.asleep
local rest = story(first, 301, 1200)
local hash = first:hash()
first:restore(saved)
check.truth("saved while asleep: goes on as it did, to the bit", story(first, 301, 1200) == rest and first:hash() == hash)
local other = pushed(true)
other:restore(saved)
check.truth("restored into another run: the same, to the bit", story(other, 301, 1200) == rest and other:hash() == hash)
check.above("saved while asleep: groups had slept", groups, 50)

-- A change of a load wakes, with the same forces as if there had been no sleep.
local function loaded(sleeping)
  local sim = pushed(sleeping)
  for _ = 1, 20 do sim:step() end
  sim:load("push").force = {2e3, 0}
  for _ = 1, 30 do sim:step() end
  return bits(sim, "stack")
end
check.truth("a load that a script changes wakes, to the bit", loaded(true) == loaded(false))
local function rising(sleeping)
  local sim = pushed(sleeping, {{0, 0}, {0.02, 0}, {0.05, 2e3}})
  local slept = 0
  for step = 1, 60 do
    sim:step()
    if step == 15 then slept = sim.totals.islands.asleep end
  end
  return bits(sim, "stack"), slept
end
local with, slept_before = rising(true)
check.truth("a load with a history wakes, to the bit", with == rising(false))
check.above("before the load rises: asleep", slept_before, 5)

-- A step that begins as the last one did, in which nothing moved, takes its contacts and islands, and where forces are the same too its
-- answer. Whatever begins to act on what rests is felt in that step, as by a run that is restored and has no last step.
local function resting()
  local stack = {}
  for k = 1, 4 do stack[k] = talus.rect(0, k - 1, 1, k) end
  local rough = talus.joint { name = "rough", friction = math.rad(35) }
  local sim = talus.simulation {
    gravity = {0, -9.81}, contact = rough,
    regions = { slab(), talus.region { name = "stack", blocks = stack, material = rock }, talus.region { name = "bar", outline = talus.rect(3, 0, 6, 1), material = rock } },
    loads = { talus.point_load { name = "jack", region = "stack", at = {1, 3.5}, force = { {{0, 0}, {0.02, 0}, {0.03, 5e4}}, 0 } },
              talus.point_load { name = "push", region = "bar", at = {3, 0.5}, force = {3e4, 0} } },
    time = { mode = "dynamic", t_end = 4, dt = 1e-3, start = "settled" },
  }
  return sim, rough
end
local acts = {
  { "a load with a history", 20, function() end },
  { "a load that is set", 12, function(sim) sim:load("push").force = {6e4, 0} end },
  { "a velocity that is set", 12, function(sim) sim.blocks[3].velocity = {0.2, 0} end },
  { "friction that is lowered", 12, function(_, joint) joint.friction = math.rad(15) end },
  { "a material that gets softer", 12, function(sim) sim:region("bar").material.young = 1e8 end },
}
for _, act in ipairs(acts) do
  local name, steps, change = table.unpack(act)
  local went_on, joint = resting()
  for _ = 1, steps - 1 do went_on:step() end
  local at_rest = went_on.totals.steps_at_rest
  local fresh, its_joint = resting()
  fresh:restore(went_on:save())
  local before = bits(went_on, "stack") .. bits(went_on, "bar")
  for _, run_of in ipairs { { went_on, joint }, { fresh, its_joint } } do
    change(table.unpack(run_of))
    for _ = 1, 3 do run_of[1]:step() end
  end
  local after = bits(went_on, "stack") .. bits(went_on, "bar")
  check.truth(name .. " on what rests: as after a restart, to the bit", after == bits(fresh, "stack") .. bits(fresh, "bar"))
  check.truth(name .. " on what rests: it moves", after ~= before)
  check.above(name .. ": steps at rest before", at_rest, steps - 4)
end

-- Nor does what a failed bond leaves stay as it was where the script's law of it goes by the time: 40° on a slope of 20°, from 2 s on 5°.
local sim
local glue = talus.joint { name = "glue", friction = math.rad(40), cohesion = 200, tension = 20,
  reduction = function() return { friction = math.rad((sim and sim.time >= 2) and 5 or 40), cohesion = 0, tension = 0 } end }
local slope = math.rad(20)
sim = talus.simulation {
  gravity = {9.81*math.sin(slope), -9.81*math.cos(slope)}, contact = talus.joint { name = "bare", friction = math.rad(10) },
  regions = { talus.region { name = "halves", bonded = true, joint = glue, material = rock, blocks = { talus.rect(0, 0, 1, 1), talus.rect(0, -1, 1, 0) } } },
  fix = { talus.fix { region = "halves", on = "bottom" } },
  loads = { talus.point_load { region = "halves", at = {1, 0.2}, force = { { {0, 0}, {0.01, 2e4}, {0.012, 0} }, 0 } } },
  time = { mode = "dynamic", t_end = 3, dt = 1e-3 }, numerics = { damping = talus.damping.velocity { rate = 60 } },
}
for _ = 1, 1990 do sim:step() end
local stood, at_rest = sim.blocks[1].ux, sim.totals.steps_at_rest
sim:run()
check.above("friction that a law lowers with time on what rests: it slides, m", sim.blocks[1].ux - stood, 1e-2)
talus.check.above("friction that a law lowers with time: steps at rest before", at_rest, 100)
