-- 15. Jammed hopper, 1000 blocks: comes to rest (v < 1e-3 √(gL)); no speed above 1.05 √(2gH) on the way.
-- Stones of three to seven corners, L = 0.1 m, fall into a funnel of 60° whose outlet is too narrow for them (0.7 L).
-- Source: energy, half v² <= g H for a block by itself; H is the height of the highest block over the outlet.
-- Run: scripts/run tests/hard/15_hopper.lua -p full=true     (quick: 30 blocks)
local talus = require "talus"
local tools = require "tools"
local g = tools.g
local full = talus.param("full", false, "1000 blocks instead of 30")
local quick = not full
local rows = talus.param("rows", quick and 6 or 40, "layers of blocks at the start")
local columns = talus.param("columns", quick and 5 or 25, "blocks in a layer")
local t_end = talus.param("t_end", quick and 2 or 6, "s")
local dt = talus.param("dt", 0, "time step, s; 0: automatic")
local friction = talus.param("friction", 30, "degrees")
local young, L = 10e9, 0.1
local rock = talus.material { name = "rock", density = 2500, young = young, poisson = 0.2 }
local random = tools.random(15)

local pitch = 1.25*L
local half, outlet = columns*pitch/2 + 0.2*L, 0.35*L
local rise = (half - outlet)*math.tan(math.rad(60))
local bottom, top = 0, rise + rows*pitch + L
local stones = {}
for row = 1, rows do
  for column = 1, columns do
    local at = { (column - (columns + 1)/2)*pitch, rise + (row - 0.5)*pitch + 0.2*L }
    stones[#stones + 1] = tools.stone(random, at, (0.9 + 0.2*random())*L, 3 + math.floor(5*random()))
  end
end
local time = { mode = "dynamic", t_end = t_end }
if dt > 0 then time.dt = dt end
local sim = talus.simulation {
  gravity = {0, -g}, contact = talus.joint { name = "rough", friction = math.rad(friction) },
  regions = {
    talus.region { name = "hopper", material = rock, held = true, blocks = {
      { {-outlet, bottom}, {-half, rise}, {-half, top}, {-half - L, top}, {-half - L, bottom} },
      { {outlet, bottom}, {half + L, bottom}, {half + L, top}, {half, top}, {half, rise} } } },
    talus.region { name = "stones", blocks = stones, material = rock },
  },
  time = time, output = { every = 0.25, vtk = false, picture = "speed" },
}
local height = top - bottom
local gain, fastest = tools.gains(sim), 0
local seen = tools.watch(sim, function()
  fastest = math.max(fastest, tools.fastest(sim))
  gain()
end)
tools.cost("hopper", seen, #stones)
talus.check.near("hopper: time reached, s", sim.time, t_end, { rel = 1e-9 })
talus.check.below("hopper: largest speed on the way over root of 2gH", fastest/math.sqrt(2*g*height), 1.05)
talus.check.below("hopper: largest speed at the end over root of gL", tools.fastest(sim)/math.sqrt(g*L), 1e-3)
talus.check.below("hopper: largest gain of energy in a step over kinetic + stored", gain(), 1e-6)
