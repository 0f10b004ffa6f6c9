-- Sizes of fragments: the curve of what passes, and the two usual laws through it.
-- Rosin and Rammler (1933); Ouchterlony (2005), "The Swebrec function: linking fragmentation by blasting and crushing".
local object = require "talus.object"
local fit = require "talus.fit"
local choice = require "talus.blast.choice"
local places = require "talus.places"
local get, given = object.get, object.given

local fragmentation = {}

-- Pieces { size, weight } -> sizes from small to large, each once, and the part of all weight in pieces up to that size.
local function curve(pieces)
  table.sort(pieces, function(a, b) return a.size < b.size end)
  local sizes, shares, total = {}, {}, 0
  for _, piece in ipairs(pieces) do
    total = total + piece.weight
    if sizes[#sizes] ~= piece.size then sizes[#sizes + 1] = piece.size end
    shares[#sizes] = (shares[#sizes] or 0) + piece.weight
  end
  local passing, below = {}, 0
  for i = 1, #sizes do
    below = below + shares[i]
    passing[i] = below/total
  end
  return sizes, passing, total
end

-- The size below which the part `part` of the weight lies, straight in ln x between sizes.
local function percentile(sizes, passing, part)
  for i = 1, #sizes do
    if passing[i] >= part then
      if i == 1 then return sizes[1] end
      local between = (part - passing[i - 1])/(passing[i] - passing[i - 1])
      return sizes[i - 1]*(sizes[i]/sizes[i - 1])^between
    end
  end
  return sizes[#sizes]
end

function fragmentation.rosin_rammler(x, law)
  return 1 - math.exp(-math.log(2)*(x/law.x50)^law.n)
end

function fragmentation.swebrec(x, law)
  if x >= law.xmax then return 1 end
  return 1/(1 + (math.log(law.xmax/x)/math.log(law.xmax/law.x50))^law.b)
end

-- Both laws through the curve, each size with the weight of its own pieces. Their parameters are searched as logarithms.
local function fit_laws(found)
  local points, before = {}, 0
  for i, x in ipairs(found.sizes) do
    points[i] = { x = x, y = found.passing[i], weight = found.passing[i] - before }
    before = found.passing[i]
  end
  local function rosin_rammler(p) return { x50 = math.exp(p[1]), n = math.exp(p[2]) } end
  local p, residual = fit.least_squares(function(q, x) return fragmentation.rosin_rammler(x, rosin_rammler(q)) end,
    { math.log(found.x50), 0 }, points)
  found.rosin_rammler = rosin_rammler(p)
  found.rosin_rammler.residual = residual
  -- x50 below xmax: searched as ln ln(xmax/x50).
  local xmax = found.sizes[#found.sizes]
  local function swebrec(q) return { x50 = xmax*math.exp(-math.exp(q[1])), xmax = xmax, b = math.exp(q[2]) } end
  local near = math.max(math.log(xmax/found.x50), 1e-3)
  p, residual = fit.least_squares(function(q, x) return fragmentation.swebrec(x, swebrec(q)) end,
    { math.log(near), math.log(2) }, points)
  found.swebrec = swebrec(p)
  found.swebrec.residual = residual
end

local function distribution(pieces)
  local found = { count = #pieces }
  if #pieces == 0 then
    found.sizes, found.passing, found.area = {}, {}, 0
    return found
  end
  found.sizes, found.passing, found.area = curve(pieces)
  for _, per_cent in ipairs { 20, 50, 80 } do
    found["x" .. per_cent] = percentile(found.sizes, found.passing, per_cent/100)
  end
  if #found.sizes >= 3 then fit_laws(found) end
  return found
end

function fragmentation.of_sizes(fields)
  local given_sizes = object.new("distribution", fields)
  local sizes, weights = given(given_sizes, "sizes"), given(given_sizes, "weights")
  if weights and #weights ~= #sizes then
    places.fail(object.place(given_sizes), ("distribution.weights: expected %d, one for each size, got %d"):format(#sizes, #weights))
  end
  local pieces = {}
  for i, size in ipairs(sizes) do pieces[i] = { size = size, weight = weights and weights[i] or math.pi/4*size^2 } end
  return distribution(pieces)
end

local function equivalent(area) return math.sqrt(4*area/math.pi) end

-- The median size of single blocks, by area: nothing finer can come out of the mesh.
local function mesh_floor(sim, names)
  local of, area, blocks = sim.blocks:field "region", sim.blocks:field "area", {}
  for b = 1, #of do
    if names[of[b]] then blocks[#blocks + 1] = { size = equivalent(area[b]), weight = area[b] } end
  end
  if #blocks == 0 then return nil end
  local sizes, passing = curve(blocks)
  return percentile(sizes, passing, 0.5)
end

local function law_line(name, law, of, sizes)
  local xs, ys = {}, {}
  local from, to = sizes[1]/1.5, sizes[#sizes]*1.2
  for k = 0, 120 do
    xs[k + 1] = from*(to/from)^(k/120)
    ys[k + 1] = 100*of(xs[k + 1], law)
  end
  return { name = name, x = xs, y = ys, dashed = true }
end

local function scaled(values, factor)
  local list = {}
  for i, value in ipairs(values) do list[i] = factor*value end
  return list
end

local function write(sim, name, found)
  local columns = { { "size [m]", found.sizes }, { "passing", found.passing } }
  local series = { { name = "fragments", x = found.sizes, y = scaled(found.passing, 100), markers = true } }
  for _, law in ipairs { { "Rosin–Rammler", "rosin_rammler" }, { "Swebrec", "swebrec" } } do
    local fitted = found[law[2]]
    if fitted then
      local values = {}
      for i, x in ipairs(found.sizes) do values[i] = fragmentation[law[2]](x, fitted) end
      columns[#columns + 1] = { law[2], values }
      series[#series + 1] = law_line(law[1], fitted, fragmentation[law[2]], found.sizes)
    end
  end
  if found.floor then series[#series + 1] = { name = "median block: the mesh's floor", x = { found.floor, found.floor }, y = { 0, 100 } } end
  sim:table(name, columns)
  sim:plot(name, { title = "Fragment sizes, by area", x_label = "x", x_unit = "m", y_label = "P", y_unit = "%", log_x = true, series })
end

function fragmentation.of_run(sim, fields)
  local options = choice.options("fragmentation", sim, fields)
  local names, pieces, alone = choice.regions(sim, options), {}, 0
  for _, fragment in ipairs(sim.fragments) do
    local counts = false
    if names[fragment.region] then
      if given(options, "where") then counts = choice.holds(options, fragment) else counts = not fragment.held end
    end
    if counts then
      pieces[#pieces + 1] = { size = fragment.size, weight = fragment.area }
      if fragment.blocks == 1 then alone = alone + fragment.area end
    end
  end
  local found = distribution(pieces)
  found.floor = mesh_floor(sim, names)
  found.single = found.area > 0 and alone/found.area or 0
  if get(options, "file") and #pieces > 0 then write(sim, get(options, "file"), found) end
  return found
end

return fragmentation
