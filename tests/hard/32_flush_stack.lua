-- 32. Four bricks, three of them flush, are set down touching; gravity acts at once. Flush corners pass each other by nanometres to and
-- fro while the bricks swing against their springs. The unexplained rest stays below 1e-6, the top comes to where a settled start has it.
-- Source: energy. Ours: corners that coincided along the face but pressed deeper than rounding were two contacts, each with half the load,
-- until one of them went: the stack sank without end, 0.1 mm in a second. (0.6 s CPU)
local talus = require "talus"
local rock = talus.material { density = 2500, young = 10e9, poisson = 0.2 }
local function stack(order, time)
  local bricks = {}
  for i = 0, 3 do
    local x = i == 2 and 0.2 or 0
    bricks[i + 1] = talus.rect(x, i, x + 1, i + 1)
  end
  return talus.simulation {
    gravity = {0, -9.81}, contact = talus.joint { friction = 0.5 },
    regions = { talus.region { name = "floor", outline = talus.rect(-2, -1, 6, 0), material = rock, held = true },
                talus.region { name = "bricks", blocks = bricks, material = rock, order = order } },
    time = time,
  }
end
for _, order in ipairs { "rigid", 1 } do
  local settled = stack(order, { t_end = 1e-6, dt = 1e-6, start = "settled" })
  settled:run()
  for _, dt in ipairs { 1e-3, 1e-4, 1e-5 } do
    local sim, worst = stack(order, { t_end = 0.1, dt = dt }), 0
    for _ in sim:steps() do worst = math.max(worst, math.abs(sim.energy.unexplained/sim.energy.scale)) end
    local label = string.format("%s bricks, dt %g s: ", order == 1 and "deformable" or order, dt)
    talus.check.below(label .. "unexplained, of the work put in", worst, 1e-6)
    -- At the shorter steps the swing has not died down: by as much again it would lie deeper at the most.
    talus.check.near(label .. "place of the top over that of a settled start", sim.blocks[5].uy/settled.blocks[5].uy, 1, { abs = dt == 1e-3 and 0.01 or 1 })
  end
end
