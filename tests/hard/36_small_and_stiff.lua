-- 36. Small and stiff blocks, which are pressed in by less than places are rounded to: stacks and a block in a V of 1 m to 1 mm at up to 200 GPa bear their
-- weight as exactly as large ones, and a column leaning by 1.005 of its limit falls, by 0.995 stands. Source: statics. Ours: gaps of 1e-12 of a block were
-- taken from places, and rest allowed what their rounding is worth: up to 0.5 % of the weight; columns of millimetres stood at 1.5 of the limit. (1 s CPU)
local talus = require "talus"
local g = 9.81

local function lowest(sim, count)
  local sum = 0
  for _, c in ipairs(sim.contacts) do
    if c.block_i <= count or c.block_j <= count then sum = sum + c.normal_force end
  end
  return sum
end

for _, L in ipairs { 1, 1e-2, 1e-3 } do
  for _, E in ipairs { 10e9, 200e9 } do
    local rock = talus.material { name = "rock", density = 2500, young = E, poisson = 0.2 }
    local label = string.format("L %g m, E %g GPa: ", L, E/1e9)
    local stack = {}
    for k = 1, 10 do stack[k] = talus.rect(0, (k - 1)*L, L, k*L) end
    for _, time in ipairs { { mode = "static" }, { mode = "dynamic", t_end = math.sqrt(L), dt = 1e-3*math.sqrt(L), start = "settled" } } do
      local sim = talus.simulation { gravity = {0, -g}, time = time, regions = {
        talus.region { name = "floor", outline = talus.rect(-2*L, -L, 3*L, 0), material = rock, held = true },
        talus.region { name = "stack", blocks = stack, material = rock } } }
      sim:run()
      talus.check.near(label .. "stack, " .. (time.start or time.mode) .. ": floor's reaction over the weight", lowest(sim, 1)/(10*2500*g*L^2), 1, { abs = 1e-8 })
    end

    local slope, half = math.sqrt(3), 0.4*L
    local sim = talus.simulation { gravity = {0, -g}, contact = talus.joint { name = "smooth", friction = 0 },
      time = { mode = "dynamic", t_end = 4*math.sqrt(L), dt = 1e-3*math.sqrt(L) }, regions = {
        talus.region { name = "V", outline = { {-3*L, -L}, {3*L, -L}, {3*L, 3*slope*L}, {0, 0}, {-3*L, 3*slope*L} }, material = rock, held = true },
        talus.region { name = "wedge", outline = { {0, 0.1*L}, {half, 0.1*L + slope*half}, {-half, 0.1*L + slope*half} }, material = rock } } }
    sim:run()
    talus.check.near(label .. "wedge in a V: reaction over the weight", lowest(sim, 1)*0.5/(2500*g*slope*half^2), 1, { abs = 1e-4 })

    for _, part in ipairs { 0.995, 1.005 } do
      local lean, column, height = math.atan(1/20)*part, {}, 20
      for k = 1, height do column[k] = talus.rect(0, (k - 1)*L, L, k*L) end
      local standing = talus.simulation { gravity = { g*math.sin(lean), -g*math.cos(lean) }, contact = talus.joint { name = "rough", friction = math.rad(40) },
        time = { mode = "dynamic", t_end = 20*math.sqrt(L), start = "settled" }, regions = {
          talus.region { name = "floor", outline = talus.rect(-2*L, -L, 3*L, 0), material = rock, held = true },
          talus.region { name = "column", blocks = column, material = rock } } }
      standing:run()
      local top = standing.blocks[height + 1]
      local moved = math.abs(top.ux)/(height*L)
      if part < 1 then
        talus.check.below(label .. "column, leaning by 0.995 of the limit: drift of the top over the height", moved, 1e-3)
      else
        talus.check.above(label .. "column, leaning by 1.005 of the limit: way of the top over the height", moved, 0.05)
      end
    end
  end
end
