-- Constructors of points, lines and outlines.
local object = require "talus.object"

local shapes = {}

local function outline(shape, points)
  return object.wrap("outline", { points = points, name = object.given(shape, "name") }, object.place(shape))
end

function shapes.point(x, y)
  return object.new("point", { at = { x, y } })
end

function shapes.line(x1, y1, x2, y2)
  return object.new("line", { from = { x1, y1 }, to = { x2, y2 } })
end

function shapes.segment(from, to)
  return object.new("line", { from = from, to = to })
end

function shapes.polygon(fields)
  return object.new("outline", fields, nil, "polygon")
end

function shapes.rect(x1, y1, x2, y2, name)
  local shape = object.new("rect", { from = { x1, y1 }, to = { x2, y2 }, name = name })
  local left, right = math.min(x1, x2), math.max(x1, x2)
  local bottom, top = math.min(y1, y2), math.max(y1, y2)
  return outline(shape, { { left, bottom }, { right, bottom }, { right, top }, { left, top } })
end

function shapes.circle(fields)
  local shape = object.new("circle", fields)
  local at, radius, sides = shape.at, shape.radius, shape.sides
  local points = {}
  for i = 1, sides do
    local angle = 2*math.pi*(i - 1)/sides
    points[i] = { at[1] + radius*math.cos(angle), at[2] + radius*math.sin(angle) }
  end
  return outline(shape, points)
end

local function brick(x1, y1, x2, y2)
  return { { x1, y1 }, { x2, y1 }, { x2, y2 }, { x1, y2 } }
end

-- Joints between bricks are computed once a course, so that neighbours share their corners exactly.
function shapes.running_bond(fields)
  local wall = object.new("running_bond", fields)
  local at, n, length, height = wall.at, wall.per_course, wall.length, wall.height
  local bricks = {}
  for course = 1, wall.courses do
    local cuts = { at[1] }
    local shift = course % 2 == 0 and 0.5 or 1
    for i = 1, n do cuts[#cuts + 1] = at[1] + (i - 1 + shift)*length end
    if shift == 0.5 then cuts[#cuts + 1] = at[1] + n*length end
    local bottom, top = at[2] + (course - 1)*height, at[2] + course*height
    for i = 1, #cuts - 1 do bricks[#bricks + 1] = brick(cuts[i], bottom, cuts[i + 1], top) end
  end
  return bricks
end

return shapes
