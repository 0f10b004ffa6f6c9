-- Field types that take shapes: outline, polyline, size, on, region.
local native = require "talus.native"
local object = require "talus.object"
local places = require "talus.places"
local types = require "talus.types"

local point = { type = "point", unit = "m" }

local function check_points(value, of_type, least, where)
  if type(value) ~= "table" or getmetatable(value) ~= nil then places.expected(where, of_type.expected(), value) end
  if #value < least then
    places.fail(where.place, ("%s: expected %d or more points, got %d"):format(where.path, least, #value))
  end
  return types.check(value, { type = "list", of = point }, where)
end

-- A talus.polygon, rect or circle, or a plain list of points; kept as an outline object.
types.outline = {}
function types.outline.expected()
  return "an outline (talus.rect, talus.circle, talus.polygon or a list of points)"
end
function types.outline.check(value, _, where)
  if object.kind(value) == "outline" then return value end
  return object.wrap("outline", { points = check_points(value, types.outline, 3, where) }, where.place)
end

-- Two or more points; kept as a list of points.
types.polyline = {}
function types.polyline.expected()
  return "a list of 2 or more points, or a talus.line"
end
function types.polyline.check(value, _, where)
  if object.kind(value) == "line" then return { value.from, value.to } end
  return check_points(value, types.polyline, 2, where)
end

-- A mesh size. A function is tried when its region is made, where the outline is known.
types.size = {}
local size_number = { type = "number", above = 0, unit = "m" }
function types.size.expected() return "a number > 0 (m), a talus.grade or a function of x and y" end
function types.size.check(value, _, where)
  if type(value) == "number" then return types.check(value, size_number, where) end
  if type(value) == "function" or object.kind(value) == "grade" then return value end
  places.expected(where, types.size.expected(), value)
end

-- Where a mesh is fine; kept as a name or as { points, closed }.
types.place = {}
function types.place.expected()
  return "the name of a hole or trace, a point, a talus.line, a list of points, a talus.trace or an outline"
end
function types.place.check(value, _, where)
  local kind = object.kind(value)
  if type(value) == "string" and value ~= "" then return value end
  if kind == "point" then return { points = { value.at } } end
  if kind == "outline" then return { points = object.given(value, "points"), closed = true } end
  if kind == "trace" then return { points = object.given(value, "points") } end
  if kind == "line" then return { points = { value.from, value.to } } end
  if type(value) ~= "table" or getmetatable(value) ~= nil then places.expected(where, types.place.expected(), value) end
  if type(value[1]) == "table" then return { points = check_points(value, types.place, 2, where) } end
  return { points = { types.check(value, point, where) } }
end

-- What a fixity or load acts on; kept as a list of lines, points and names of sides.
types.on = {}
local sides = { type = "enum", values = { "left", "right", "top", "bottom" } }
function types.on.expected(spec)
  local point_text = spec.points and "a talus.point " or ""
  return ("a talus.line, %sor sides of the region (%s)"):format(point_text, types.expected(sides))
end
local function check_one_on(value, spec, where)
  local kind = object.kind(value)
  if kind == "line" or kind == "point" and spec.points then return value end
  if type(value) == "string" then return types.check(value, sides, where) end
  places.expected(where, types.on.expected(spec), value)
end
function types.on.check(value, spec, where)
  if type(value) ~= "table" or object.kind(value) then return { check_one_on(value, spec, where) } end
  if #value == 0 then places.expected(where, types.on.expected(spec), value) end
  local kept = {}
  for i, one in ipairs(value) do kept[i] = check_one_on(one, spec, places.inside(where, ("[%d]"):format(i))) end
  return kept
end

-- A region by name or itself; resolved when the simulation is put together.
types.region = {}
function types.region.expected() return "a region's name or a talus.region" end
function types.region.check(value, _, where)
  if object.kind(value) == "region" or type(value) == "string" then return value end
  places.expected(where, types.region.expected(), value)
end

-- Tries a size function at the region's first corner.
local function try_size(region)
  local mesh, outline = object.given(region, "mesh"), object.given(region, "outline")
  local size = mesh and object.given(mesh, "size")
  if type(size) ~= "function" then return end
  local corner = object.given(outline, "points")[1]
  local problem = native.try_law(size, { "x", "y" }, corner)
  if problem then places.fail(object.place(region), "region.mesh.size: " .. problem) end
end

return { try_size = try_size }
