-- 64. What flies off does not slow the scene: steps are bounded by how far blocks move past what they may meet in them, not by how far they move.
-- A stone that falls beside a wall for 5 s, a stack that falls as one, and a chip that is shot off at 100 m/s. Source: free flight, x = v t + g t²/2.
-- Ours: the stone took 38924 steps where the wall takes 16 (2.8 s for 0.01 s), a hopper that one stone slips out of 10228 for 624. (0.1 s CPU)
local talus = require "talus"
local tools = require "tools"
local rock = talus.material { density = 2500, young = 10e9, poisson = 0.2 }

local function run(extra, order, numerics)
  local bricks = {}
  for column = 0, 11 do
    for row = 0, 3 do bricks[#bricks + 1] = talus.rect(0.2*column, 0.1*row, 0.2*column + 0.1, 0.1*row + 0.1) end
  end
  local regions = { talus.region { name = "floor", outline = talus.rect(-1, -1, 3, 0), material = rock, held = true },
                    talus.region { name = "wall", blocks = bricks, material = rock } }
  if extra then
    extra.name, extra.material, extra.order = "stray", rock, order
    regions[#regions + 1] = talus.region(extra)
  end
  local sim = talus.simulation { gravity = {0, -tools.g}, contact = talus.joint { friction = 0.6 }, regions = regions, time = { t_end = 5 }, numerics = numerics }
  local cut = 0
  for status in sim:steps() do cut = cut + status.cuts end
  return sim, cut
end

local alone = run().totals.steps
local strays = {
  { "a stone that falls", { outline = talus.rect(4, 0, 4.1, 0.1) } },
  { "a stack that falls", { blocks = { talus.rect(4, 0, 4.1, 0.1), talus.rect(4, 0.1, 4.1, 0.2), talus.rect(4, 0.2, 4.1, 0.3) } } },
  { "a chip that is shot off", { outline = talus.polygon { {4, 1}, {4.05, 1}, {4, 1.05} }, velocity = {100, 30} } },
}
for _, case in ipairs(strays) do
  local name, stray = case[1], case[2]
  for _, order in ipairs { 1, 2, "rigid" } do
    local v = stray.velocity or {0, 0}
    local sim, cut = run(stray, order)
    local b = sim.blocks[#sim.blocks]
    local label = string.format("%s, order %s", name, order)
    talus.check.below(label .. ": steps over those without it", sim.totals.steps/alone, stray.blocks and 6 or 2.5)  -- its contacts come to no load at once
    talus.check.below(label .. ": cuts", cut, stray.blocks and 4 or 1)
    talus.check.near(label .. ": way across, m", b.ux, 5*v[1], { abs = 1e-6 })
    talus.check.near(label .. ": way up, m", b.uy, 5*v[2] - tools.g*12.5, { rel = 1e-9 })
    talus.check.below(label .. ": unexplained, of the scale", math.abs(sim.energy.unexplained)/sim.energy.scale, 1e-6)
    if v[2] > 0 then
      talus.check.near(label .. ": highest, m", sim.highest.rise, v[2]^2/2/tools.g, { rel = 1e-9 })
      talus.check.near(label .. ": when, s", sim.highest.time, v[2]/tools.g, { rel = 1e-9 })
    end
  end
end

-- Damped flight is no parabola: steps are bounded by all of the way. Source: v' = g - v/T.
local damped = run(strays[1][2], 1, { damping = talus.damping.velocity { rate = 1 } })
talus.check.near("a stone that falls in water, m", damped.blocks[#damped.blocks].uy, -tools.g*(5 - 1 + math.exp(-5)), { rel = 0.005 })
