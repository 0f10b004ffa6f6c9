-- 13. Long rest: stack of 10, 1e5 steps: drift after settling < 1e-9 L, kinetic energy < 1e-10 mgH.
-- Source: equilibrium. Run: scripts/run tests/hard/13_rest.lua -p full=true      (quick: 1e4 steps, 0.6 s CPU)
local talus = require "talus"
local tools = require "tools"
local g = tools.g
local full = talus.param("full", false, "1e5 steps")
local steps = full and 1e5 or 1e4
local rock = talus.material { name = "rock", density = 2500, young = 10e9, poisson = 0.2 }
local stones = {}
for i = 1, 10 do stones[i] = talus.rect(0, i - 1, 1, i) end
local rest = talus.simulation {
  gravity = {0, -g}, contact = talus.joint { name = "contact", friction = 0.5 },
  regions = { talus.region { name = "floor", outline = talus.rect(-2, -1, 3, 0), material = rock, held = true },
              talus.region { name = "stack", blocks = stones, material = rock } },
  time = { mode = "dynamic", t_end = steps*1e-3, dt = 1e-3, start = "settled" },
}
rest:step()
local places, drift = {}, 0
for i = 2, 11 do places[i] = rest.blocks[i].displacement end
local seen = tools.watch(rest)
tools.cost("stack of 10", seen, 10)
for i = 2, 11 do
  local now = rest.blocks[i].displacement
  drift = math.max(drift, math.abs(now[1] - places[i][1]), math.abs(now[2] - places[i][2]))
end
talus.check.above("stack at rest: steps", seen.steps, steps - 1.5)
talus.check.below("stack at rest: largest drift of a block, m", drift, 1e-9)
talus.check.below("stack at rest: kinetic energy over m g H", rest.energy.kinetic/(10*2500*g*10), 1e-10)
