-- 4. Column of 50 blocks, H/B = 50, E 55 GPa, static start: 1e5 steps upright, top drift < 1e-6 H; tilted by
-- atan(B/H)(1 ± 0.5 %) it falls / stands.
-- Source: a column on its edge, tan(lean) = B/H.
-- Run: scripts/run tests/hard/04_column.lua -p full=true     (quick: 2000 steps upright)
local talus = require "talus"
local tools = require "tools"
local g = tools.g
local full = talus.param("full", false, "1e5 steps upright")
local rock = talus.material { name = "rock", density = 2500, young = 55e9, poisson = 0.2 }
local function column(lean, time)
  local blocks = {}
  for i = 1, 50 do blocks[i] = talus.rect(0, i - 1, 1, i) end
  return talus.simulation {
    gravity = {-g*math.sin(lean), -g*math.cos(lean)}, contact = talus.joint { name = "contact", friction = 0.6 },
    regions = { talus.region { name = "floor", outline = talus.rect(-2, -1, 3, 0), material = rock, held = true },
                talus.region { name = "column", blocks = blocks, material = rock } },
    time = time,
  }
end
local steps = full and 1e5 or 2000
local upright = column(0, { mode = "dynamic", t_end = steps*1e-3, dt = 1e-3, start = "settled" })
upright:step()
local x, y = upright.blocks[51].ux, upright.blocks[51].uy
local seen = tools.watch(upright)
tools.cost("column upright", seen, 50)
talus.check.above("column upright: steps", seen.steps, steps - 1.5)
talus.check.below("column upright: drift of the top over height",
                  math.max(math.abs(upright.blocks[51].ux - x), math.abs(upright.blocks[51].uy - y))/50, 1e-6)
for _, part in ipairs { 0.995, 1.005 } do
  local sim = column(math.atan(1/50)*part, { mode = "dynamic", t_end = 10, dt = 5e-3, start = "settled" })
  sim:run()
  local top = -sim.blocks[51].ux/50
  local label = string.format("column at %g of its lean: top over height", part)
  if part < 1 then talus.check.below(label, top, 1e-4) else talus.check.above(label, top, 1e-2) end
end
