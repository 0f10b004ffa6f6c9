-- A pile of 72 blocks collapses on a rough floor, 320 steps: a second run, one that goes back to a state in memory and
-- one that goes on from a file end in the same state to the last bit. No source: the answer is the run itself.
local talus = require "talus"
local u = talus.units
local check = talus.check
local rock = talus.material { name = "rock", density = 2500, young = 1*u.GPa, poisson = 0.25 }
local half, steps = 160, 320

-- Tilted blocks of four sizes in a leaning stack, thrown sideways, with a push that the script changes on the way.
local function pile(number)
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
  return talus.simulation {
    gravity = {0, -9.81}, contact = talus.joint { name = "rough", friction = 30*u.deg }, regions = regions,
    loads = { talus.point_load { name = "push", region = "block 11 0", at = {1.5, 10.8}, force = {0, 0} } },
    on_step = function(sim)
      sim.state.steps = (sim.state.steps or 0) + 1
      if sim.state.steps == 40 then sim:load("push").force = {2*u.kN, 0} end
      if sim.state.steps == 200 then sim:material("rock").young = 1.2*u.GPa end
    end,
    time = { mode = "dynamic", t_end = 100, dt_max = 2e-3 },
  }
end

local function advance(sim, count)
  for _ = 1, count do sim:step() end
  return sim:hash()
end

local file = "/tmp/rs/x.state"
rock.young = 1*u.GPa
local one = pile()
local at_half = advance(one, half)
local memory = one:save(file)
local reference, time = advance(one, steps - half), one.time
check.above("closed contacts at the end", one.last.closed_contacts, 60)
print(one.totals.seconds, time, one.totals.steps, one.totals.cuts)

one:restore(memory)
check.equal("back in memory", one:hash(), at_half)
check.equal("modulus again as it was", one:material("rock").young, 1*u.GPa)
check.equal("from memory", advance(one, steps - half), reference)
one:restore(file)
check.equal("from the file", advance(one, steps - half), reference)
