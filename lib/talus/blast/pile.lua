-- The muck pile: its profile, how far it has gone, how much looser it lies.
local object = require "talus.object"
local places = require "talus.places"
local choice = require "talus.blast.choice"
local get, given = object.get, object.given

local function area_of(points)
  local twice = 0
  for i, p in ipairs(points) do
    local q = points[i % #points + 1]
    twice = twice + p[1]*q[2] - q[1]*p[2]
  end
  return twice/2
end

-- Area of the part of a polygon with sign·(x − line) > 0: exact, also where the cut leaves several parts.
local function area_beyond(points, line, sign)
  local kept = {}
  for i, p in ipairs(points) do
    local q = points[i % #points + 1]
    local dp, dq = sign*(p[1] - line), sign*(q[1] - line)
    if dp >= 0 then kept[#kept + 1] = p end
    if dp*dq < 0 then
      local t = dp/(dp - dq)
      kept[#kept + 1] = { p[1] + t*(q[1] - p[1]), p[2] + t*(q[2] - p[2]) }
    end
  end
  return #kept > 2 and area_of(kept) or 0
end

-- Raises `tops`, heights at the middles of cells, to the polygon's upper side.
local function raise(tops, points, cells)
  for i, p in ipairs(points) do
    local q = points[i % #points + 1]
    local a, b = p, q
    if a[1] > b[1] then a, b = b, a end
    local first = math.max(1, math.ceil((a[1] - cells.from)/cells.width + 0.5))
    local last = math.min(cells.count, math.floor((b[1] - cells.from)/cells.width + 0.5))
    for k = first, last do
      local x = cells.from + (k - 0.5)*cells.width
      local y = b[1] > a[1] and a[2] + (b[2] - a[2])*(x - a[1])/(b[1] - a[1]) or math.max(a[2], b[2])
      if not tops[k] or y > tops[k] then tops[k] = y end
    end
  end
end

-- The chosen blocks and the others, with what is summed over the chosen ones.
local function gather(sim, options, names)
  local of, area, moved = sim.blocks:field "region", sim.blocks:field "area", sim.blocks:field "displacement"
  local vertices, centroid = sim.blocks:field "vertices", sim.blocks:field "centroid"
  local sum = { chosen = {}, others = {}, solid = 0, shift = { 0, 0 }, low = math.huge, left = math.huge, right = -math.huge }
  for b = 1, #of do
    local inside = names[of[b]] and math.sqrt(moved[b][1]^2 + moved[b][2]^2) >= get(options, "moved")
      and (not given(options, "where") or choice.holds(options, sim.blocks[b]))
    if inside then
      sum.chosen[#sum.chosen + 1] = { points = vertices[b], block = b, x = centroid[b][1] }
      sum.solid = sum.solid + area[b]
      for i = 1, 2 do sum.shift[i] = sum.shift[i] + area[b]*moved[b][i] end
      for _, p in ipairs(vertices[b]) do
        sum.left, sum.right, sum.low = math.min(sum.left, p[1]), math.max(sum.right, p[1]), math.min(sum.low, p[2])
      end
    else
      sum.others[#sum.others + 1] = vertices[b]
    end
  end
  for i = 1, 2 do sum.shift[i] = sum.shift[i]/sum.solid end
  return sum
end

local function profile_of(sum, options)
  local spacing = get(options, "spacing") or (sum.right - sum.left)/400
  local cells = { from = sum.left, count = math.max(1, math.ceil((sum.right - sum.left)/spacing - 1e-9)), width = spacing }
  local tops, below, ground = {}, {}, given(options, "ground")
  for _, block in ipairs(sum.chosen) do raise(tops, block.points, cells) end
  if not ground then for _, points in ipairs(sum.others) do raise(below, points, cells) end end
  local pile = { x = {}, top = {}, ground = {}, bulk = 0, height = 0 }
  for k = 1, cells.count do
    local x = cells.from + (k - 0.5)*cells.width
    local base = below[k] or sum.low
    if type(ground) == "function" then
      base = ground(x)
      if type(base) ~= "number" then
        places.expected({ place = object.place(options), path = "pile.ground" }, ("a number (m) at x = %g"):format(x), base)
      end
    elseif ground then
      base = ground
    end
    local top = math.max(tops[k] or base, base)
    pile.x[k], pile.top[k], pile.ground[k] = x, top, base
    pile.bulk = pile.bulk + (top - base)*cells.width
    if top - base > pile.height then pile.height, pile.crest, pile.crest_cell = top - base, x, k end
  end
  return pile, cells
end

-- The end of what goes on from the crest without a gap.
local function toe_of(pile, cells, direction)
  local k = pile.crest_cell
  while pile.x[k + direction] and pile.top[k + direction] > pile.ground[k + direction] do k = k + direction end
  return pile.x[k] + direction*cells.width/2
end

-- The outlines' end in the direction of the throw.
local function front(outlines, direction)
  local far = -math.huge
  for _, points in ipairs(outlines) do
    for _, p in ipairs(points) do far = math.max(far, direction*p[1]) end
  end
  return direction*far
end

local function write(sim, name, pile, outlines, line)
  sim:table(name, { { "x [m]", pile.x }, { "top [m]", pile.top }, { "ground [m]", pile.ground } })
  local low, high = math.huge, -math.huge
  local series = { { name = "pile", x = pile.x, y = pile.top }, { name = "ground", x = pile.x, y = pile.ground } }
  local start = { name = "at the start", x = {}, y = {}, dashed = true }
  for _, points in ipairs(outlines) do
    for k = 0, #points do
      local p = points[k % #points + 1]
      start.x[#start.x + 1], start.y[#start.y + 1] = p[1], p[2]
      low, high = math.min(low, p[2]), math.max(high, p[2])
    end
    start.x[#start.x + 1], start.y[#start.y + 1] = 0/0, 0/0  -- from one outline to the next
  end
  series[#series + 1] = start
  series[#series + 1] = { name = "line", x = { line, line }, y = { low, high } }
  sim:plot(name, { title = "Muck pile", x_label = "x", x_unit = "m", y_label = "y", y_unit = "m", equal = true, series })
end

return function(sim, fields)
  local options = choice.options("pile", sim, fields)
  local names = choice.regions(sim, options)
  local sum = gather(sim, options, names)
  if #sum.chosen == 0 then return { x = {}, top = {}, ground = {}, solid = 0, bulk = 0, height = 0 } end
  local pile, cells = profile_of(sum, options)
  local outlines = choice.outlines(sim, names)
  local direction = given(options, "direction") or (sum.shift[1] < 0 and -1 or 1)
  local face = given(options, "face") or front(outlines, direction)
  local line, beyond = given(options, "line") or face, 0
  for _, block in ipairs(sum.chosen) do
    beyond = beyond + area_beyond(block.points, line, direction)
    local distance = direction*(block.x - face)
    if not pile.farthest or distance > pile.farthest.distance then
      pile.farthest = { block = block.block, x = block.x, distance = distance }
    end
  end
  pile.solid, pile.swell, pile.shift, pile.cast = sum.solid, pile.bulk/sum.solid, sum.shift, beyond/sum.solid
  if pile.height > 0 then
    pile.toe = toe_of(pile, cells, direction)
    pile.throw = direction*(pile.toe - face)
  end
  pile.highest, pile.crest_cell = sim.highest, nil
  if given(options, "file") then write(sim, given(options, "file"), pile, outlines, line) end
  return pile
end
