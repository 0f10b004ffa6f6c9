-- What the scenes of the contact study share. Polygons are explicit and numbers come from a generator of our own, so that a
-- problem is the same on every machine.
local shapes = {}

shapes.g = 9.81

-- Park–Miller numbers in [0, 1).
function shapes.random(seed)
  local state = seed % 2147483646 + 1
  for _ = 1, 10 do state = (state*48271) % 2147483647 end
  return function()
    state = (state*48271) % 2147483647
    return (state - 1)/2147483646
  end
end

-- A convex polygon of `corners` corners at `at`, its size (mean diameter) `size`.
function shapes.stone(random, at, size, corners)
  local turn, points = 2*math.pi*random(), {}
  for k = 1, corners do
    local a = turn + 2*math.pi*(k - 1 + 0.6*(random() - 0.5))/corners
    points[k] = { at[1] + 0.5*size*math.cos(a), at[2] + 0.5*size*math.sin(a) }
  end
  return points
end

-- `rows` layers of `columns` stones of three to seven corners, `pitch` apart, the lowest at `bottom`.
function shapes.stones(random, rows, columns, size, pitch, bottom)
  local stones = {}
  for row = 1, rows do
    for column = 1, columns do
      local at = { (column - (columns + 1)/2 + 0.3*(row % 2))*pitch, bottom + (row - 0.5)*pitch }
      stones[#stones + 1] = shapes.stone(random, at, (0.9 + 0.2*random())*size, 3 + math.floor(5*random()))
    end
  end
  return stones
end

-- Courses of bricks h high between left(y) and right(y), touching all round; joints at random places about `length` apart.
function shapes.courses(random, count, h, length, left, right, slant)
  local bricks = {}
  for course = 0, count - 1 do
    local y0, y1 = course*h, (course + 1)*h
    local bottom, top = left(y0), left(y1)
    local edge, at = right(y0), left(y0) + (0.3 + 0.4*random() + 0.5*(course % 2))*length
    while true do
      local last = at > edge - 0.4*length
      local b = last and right(y0) or at
      local t = last and right(y1) or at + (slant or 0)*h*(random() - 0.5)
      bricks[#bricks + 1] = { {bottom, y0}, {b, y0}, {t, y1}, {top, y1} }
      if last then break end
      bottom, top, at = b, t, at + (0.8 + 0.4*random())*length
    end
  end
  return bricks
end

-- Runs to the given step.
function shapes.time(steps, dt)
  return { mode = "dynamic", t_end = 1e3*steps*dt, dt = dt, max_steps = steps }
end

return shapes
