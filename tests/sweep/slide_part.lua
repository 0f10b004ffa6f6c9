-- A turned box.
local part = {}

function part.turn(angle, x, y)
  local c, s = math.cos(math.rad(angle)), math.sin(math.rad(angle))
  return { c*x - s*y, s*x + c*y }
end

function part.box(angle, x0, y0, x1, y1)
  return { part.turn(angle, x0, y0), part.turn(angle, x1, y0), part.turn(angle, x1, y1), part.turn(angle, x0, y1) }
end

return part
