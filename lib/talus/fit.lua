-- Least squares with few parameters: Levenberg's and Marquardt's way, slopes by differences.
local fit = {}

-- Solves the small symmetric system a·x = b by elimination with pivots. nil where it has no single solution.
local function solve(a, b)
  local n = #b
  for column = 1, n do
    local pivot = column
    for row = column + 1, n do
      if math.abs(a[row][column]) > math.abs(a[pivot][column]) then pivot = row end
    end
    if a[pivot][column] == 0 then return nil end
    a[column], a[pivot], b[column], b[pivot] = a[pivot], a[column], b[pivot], b[column]
    for row = column + 1, n do
      local factor = a[row][column]/a[column][column]
      for k = column, n do a[row][k] = a[row][k] - factor*a[column][k] end
      b[row] = b[row] - factor*b[column]
    end
  end
  for row = n, 1, -1 do
    for k = row + 1, n do b[row] = b[row] - a[row][k]*b[k] end
    b[row] = b[row]/a[row][row]
  end
  return b
end

local function sum_of_squares(model, p, points)
  local sum = 0
  for _, at in ipairs(points) do sum = sum + at.weight*(model(p, at.x) - at.y)^2 end
  return sum
end

-- The normal equations of one step, damped by `damping` of their diagonal.
local function step(model, p, points, damping)
  local n, difference = #p, 1e-6
  local matrix, right = {}, {}
  for i = 1, n do matrix[i], right[i] = {}, 0 end
  for i = 1, n do for j = 1, n do matrix[i][j] = 0 end end
  for _, at in ipairs(points) do
    local value, slopes = model(p, at.x), {}
    for i = 1, n do
      local moved = { table.unpack(p) }
      moved[i] = moved[i] + difference
      slopes[i] = (model(moved, at.x) - value)/difference
    end
    for i = 1, n do
      right[i] = right[i] + at.weight*slopes[i]*(at.y - value)
      for j = 1, n do matrix[i][j] = matrix[i][j] + at.weight*slopes[i]*slopes[j] end
    end
  end
  for i = 1, n do matrix[i][i] = matrix[i][i]*(1 + damping) + 1e-300 end
  return solve(matrix, right)
end

-- Parameters (of about unit size) of model(p, x) that come nearest to points { x, y, weight }, from `start`; and what is left,
-- as the root of the weighted mean square.
function fit.least_squares(model, start, points)
  local p, damping = { table.unpack(start) }, 1e-3
  local left, total = sum_of_squares(model, p, points), 0
  for _, at in ipairs(points) do total = total + at.weight end
  for _ = 1, 200 do
    local change = step(model, p, points, damping)
    if not change then break end
    local moved, size = {}, 0
    for i = 1, #p do
      moved[i] = p[i] + change[i]
      size = math.max(size, math.abs(change[i]))
    end
    local there = sum_of_squares(model, moved, points)
    if there <= left then
      p, left, damping = moved, there, damping/4
      if size < 1e-10 then break end
    else
      damping = damping*8
      if damping > 1e12 then break end
    end
  end
  return p, math.sqrt(left/total)
end

-- The straight line y = a + b·x: a, b, and the root mean square left. nil where all x are one.
function fit.line(xs, ys)
  local n, mx, my = #xs, 0, 0
  for i = 1, n do mx, my = mx + xs[i]/n, my + ys[i]/n end
  local xx, xy = 0, 0
  for i = 1, n do
    xx = xx + (xs[i] - mx)^2
    xy = xy + (xs[i] - mx)*(ys[i] - my)
  end
  if not (xx > 0) then return nil end
  local b, left = xy/xx, 0
  for i = 1, n do left = left + (ys[i] - my - b*(xs[i] - mx))^2 end
  return my - b*mx, b, math.sqrt(left/n)
end

return fit
