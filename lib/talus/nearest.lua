-- The nearest of many points in the plane: a tree that halves them by x, then y, and so on (Bentley 1975).
local function build(points, order, first, last, axis)
  if first > last then return nil end
  local part = table.move(order, first, last, 1, {})
  table.sort(part, function(a, b)
    if points[a][axis] ~= points[b][axis] then return points[a][axis] < points[b][axis] end
    return a < b
  end)
  table.move(part, 1, #part, first, order)
  local middle = (first + last)//2
  return { id = order[middle], x = points[order[middle]][1], y = points[order[middle]][2],
           below = build(points, order, first, middle - 1, 3 - axis), above = build(points, order, middle + 1, last, 3 - axis) }
end

local function search(node, x, y, by_x, best, id)
  while node do
    local dx, dy = x - node.x, y - node.y
    local d = dx*dx + dy*dy
    if d < best then best, id = d, node.id end
    local off = by_x and dx or dy
    by_x = not by_x
    local near, far = node.below, node.above
    if off > 0 then near, far = far, near end
    best, id = search(near, x, y, by_x, best, id)
    if off*off >= best then return best, id end
    node = far
  end
  return best, id
end

-- points: list of {x, y}. Returns function(x, y): the number of the nearest.
return function(points)
  local order = {}
  for i = 1, #points do order[i] = i end
  local root = build(points, order, 1, #points, 1)
  return function(x, y)
    local _, id = search(root, x, y, true, math.huge, nil)
    return id
  end
end
