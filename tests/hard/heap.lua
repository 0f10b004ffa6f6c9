-- A heap: stones dropped on a rough slab in a column come to rest in a pile.
-- Source: energy (no step may gain 1e-6 of kinetic + stored) and rest: no block above 1e-3 of root(gL) at the end.
-- Run: scripts/run tests/hard/heap.lua -p full=true     (quick: 20 stones; shape: stones, triangles, squares, needles)
local talus = require "talus"
local tools = require "tools"
local g = tools.g
local full = talus.param("full", false, "300 stones instead of 20")
local quick = not full
local shape = talus.param("shape", "", "stones, triangles, squares or needles; empty: those that gained energy once")
local seed = talus.param("seed", 7, "of the sizes, with a shape")
local rows = talus.param("rows", quick and 5 or 30, "layers at the start")
local columns = talus.param("columns", quick and 4 or 10, "in a layer")
local t_end = talus.param("t_end", quick and 2 or 6, "s")
local dt = talus.param("dt", 0, "time step, s; 0: automatic")
local friction = talus.param("friction", 30, "degrees")
local young, L = 10e9, 0.1
local rock = talus.material { name = "rock", density = 2500, young = young, poisson = 0.2 }

local function heap_of(shape, seed)
  local random = tools.random(seed)
  local pitch = 1.2*L
  local stones = {}
  for row = 1, rows do
    for column = 1, columns do
      local at = { (column - (columns + 1)/2 + 0.3*(row % 2))*pitch, (row - 0.4)*pitch }
      local size = (0.9 + 0.2*random())*L
      if shape == "squares" then
        stones[#stones + 1] = talus.rect(at[1] - L/2, at[2] - L/2, at[1] + L/2, at[2] + L/2)
      else
        local corners = shape == "triangles" and 3 or shape == "needles" and 4 or 3 + math.floor(5*random())
        stones[#stones + 1] = tools.stone(random, at, size, corners, shape == "needles" and 0.08 or 1)
      end
    end
  end
  return stones
end

local function check_heap(shape, seed)
  local stones = heap_of(shape, seed)
  local name = "heap of " .. shape .. (seed == 7 and "" or ", seed " .. seed)
  local time = { mode = "dynamic", t_end = t_end }
  if dt > 0 then time.dt = dt end
  local sim = talus.simulation {
    gravity = {0, -g}, contact = talus.joint { name = "rough", friction = math.rad(friction) },
    regions = { talus.region { name = "slab", material = rock, held = true, outline = talus.rect(-20, -1, 20, 0) },
                talus.region { name = "stones", blocks = stones, material = rock } },
    time = time, output = { every = 0.25, vtk = false, picture = "speed" },
  }
  local gain = tools.gains(sim)
  local seen = tools.watch(sim, gain)
  tools.cost(name, seen, #stones)
  talus.check.near(name .. ": time reached, s", sim.time, t_end, { rel = 1e-9 })
  talus.check.below(name .. ": part of the steps that were cut", seen.cut_steps/seen.steps, 0.05)
  talus.check.below(name .. ": largest speed at the end over root of gL", tools.fastest(sim)/math.sqrt(g*L), 1e-3)
  talus.check.below(name .. ": largest gain of energy in a step over kinetic + stored", gain(), 1e-6)
end

if shape ~= "" then
  check_heap(shape, seed)
else
  -- A step of another length lifted what had come to stand and went to and fro: full, 1.1 % with the second; quick, 120 %.
  check_heap("stones", 7)
  check_heap(full and "stones" or "triangles", full and 11 or 1)
end
