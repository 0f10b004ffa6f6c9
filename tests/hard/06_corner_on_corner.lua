-- 6. Corner dropped on corner, offset 0, ±1e-12 L, ±1e-9 L: penetration < 1e-3 L, mirrored runs mirror to 1e-10, no lock-up.
-- Lock-up: a step cut, more than 10 iterations, or a hammer that hangs in the air at the end (1e-3 is added: it falls off).
-- Source: mirror symmetry. Ours: faces that are parallel were chosen between by rounding, and mirrored runs of triangles and acute corners differed by 1e-4. (1 s CPU)
local talus = require "talus"
local tools = require "tools"
local g = tools.g
local rock = talus.material { name = "rock", density = 2500, young = 10e9, poisson = 0.2 }
-- Half a corner's angle; squares, or triangles cut off at the same height.
local function corners(offset, half, square)
  local s, deepest = square and math.sqrt(2)/2 or 1, 0
  local w = s*math.tan(half)
  local function body(x, y, up)  -- with a corner at (x, y)
    return talus.polygon(square and { {x, y}, {x + up*w, y + up*s}, {x, y + 2*up*s}, {x - up*w, y + up*s} } or { {x, y}, {x + up*w, y + up*s}, {x - up*w, y + up*s} })
  end
  local sim = talus.simulation {
    gravity = {0, -g}, contact = talus.joint { name = "contact", friction = 0.5 },
    regions = {
      talus.region { name = "anvil", outline = body(0, 0, -1), material = rock, held = true },
      talus.region { name = "hammer", outline = body(offset, 0.1, 1), material = rock } },
    time = { mode = "dynamic", t_end = 0.6, dt = 1e-3 },
  }
  local seen = tools.watch(sim, function()
    for _, c in ipairs(sim.contacts) do
      if c.normal_force > 0 then deepest = math.max(deepest, -c.gap) end
    end
  end)
  return sim.blocks[2], deepest, seen, sim
end
for name, shape in pairs { squares = { math.rad(45), true }, triangles = { math.rad(45), false }, acute = { math.rad(10), false } } do
  for _, offset in ipairs { 0, 1e-13, 1e-12, 1e-9, 1e-7, 1e-3 } do
    local label = string.format("corner on corner, %s, offset %g: ", name, offset)
    local right, deep, seen, sim = corners(offset, table.unpack(shape))
    talus.check.below(label .. "penetration, m", deep, 1e-3)
    talus.check.near(label .. "time reached, s", sim.time, 0.6, { rel = 1e-9 })
    talus.check.equal(label .. "cut steps", seen.cut_steps, 0)
    talus.check.below(label .. "most iterations of a step", seen.most_iterations, 10.5)
    if offset > 0 then
      local left = corners(-offset, table.unpack(shape))
      talus.check.below(label .. "mirrored runs differ by, m",
                        math.max(math.abs(right.ux + left.ux), math.abs(right.uy - left.uy), math.abs(right.rotation + left.rotation)), 1e-10)
    end
  end
end

-- Put on the other's corner, faces in line, in automatic steps: by the velocities that the first begins with, none, neither corner comes on to a face.
for _, case in ipairs { { 0, 0 }, { 0, 1e-6 }, { 1e-6, 0 }, { 1e-4, 0 }, { 0, 1e-4 } } do
  local offset, high = table.unpack(case)
  local sim = talus.simulation { gravity = {0, -g}, contact = talus.joint { name = "contact", friction = 0.5 }, output = { vtk = false, picture = false },
    regions = { talus.region { name = "anvil", outline = { {0, 0}, {-1, -1}, {0, -2}, {1, -1} }, material = rock, held = true },
                talus.region { name = "hammer", outline = { {offset, high}, {offset + 1, high + 1}, {offset, high + 2}, {offset - 1, high + 1} }, material = rock } },
    time = { t_end = 0.5 } }
  local deep = 0
  for _ in sim:steps() do
    local tip = sim.blocks[2].vertices[1]
    deep = math.max(deep, -(tip[2] + math.abs(tip[1]))/math.sqrt(2))
  end
  talus.check.below(string.format("put on the corner, %g beside it and %g above: tip under the faces, over the root of the area", offset, high), deep/math.sqrt(2), 1e-3)
end
