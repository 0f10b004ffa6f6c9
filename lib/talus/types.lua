-- What a field may hold. A type has `expected(spec)`, in words, for messages and the reference page, and
-- `check(value, spec, where)`, which returns the value as it is kept (tables are copied) or fails.
local native = require "talus.native"
local places = require "talus.places"
local expected, inside = places.expected, places.inside

local types = {}

local function unit_text(spec)
  return spec.unit and (" (%s)"):format(spec.unit) or ""
end

function types.range_text(spec)
  local low, high = spec.above or spec.least, spec.below or spec.most
  if low and high then
    return ("in %s%.10g, %.10g%s"):format(spec.above and "(" or "[", low, high, spec.below and ")" or "]")
  elseif low then
    return ("%s %.10g"):format(spec.above and ">" or ">=", low)
  elseif high then
    return ("%s %.10g"):format(spec.below and "<" or "<=", high)
  end
end

local function is_finite(value)
  return type(value) == "number" and value == value and value > -math.huge and value < math.huge
end

local function in_range(value, spec)
  return not (spec.above and value <= spec.above or spec.least and value < spec.least
    or spec.below and value >= spec.below or spec.most and value > spec.most)
end

-- An angle out of its range that would lie in it if it were degrees: what to write instead.
local function degrees_hint(value, spec)
  if spec.unit ~= "rad" or math.abs(value) > 360 or not in_range(math.rad(value), spec) then return "" end
  return ("; in degrees? write %.10g*talus.units.deg"):format(value)
end

local function number_type(noun, plain_noun, convert)
  local of_type = {}
  function of_type.expected(spec)
    local range = types.range_text(spec)
    return (range and ("%s %s"):format(noun, range) or plain_noun) .. unit_text(spec)
  end
  function of_type.check(value, spec, where)
    if spec.gaps and value ~= value then return value end
    local kept = is_finite(value) and convert(value)
    if not kept then expected(where, of_type.expected(spec), value) end
    if not in_range(kept, spec) then
      places.fail(where.place, ("%s: expected %s, got %s%s"):format(where.path, of_type.expected(spec),
        native.describe(value), degrees_hint(kept, spec)))
    end
    return kept
  end
  return of_type
end

types.number = number_type("a number", "a finite number", function(value) return value + 0.0 end)
types.integer = number_type("an integer", "an integer", math.tointeger)

local function plain_type(name, words)
  return {
    expected = function() return words end,
    check = function(value, _, where)
      if type(value) ~= name or value == "" or name == "string" and value:find("\0", 1, true) then expected(where, words, value) end
      return value
    end,
  }
end

types.boolean = plain_type("boolean", "true or false")
types.string = plain_type("string", "a text")
types["function"] = plain_type("function", "a function")

function types.is_one_of(value, values)
  for _, known in ipairs(values) do
    if value == known then return true end
  end
  return false
end

-- One of a few words (or numbers): spec.values.
types.enum = {}
function types.enum.expected(spec)
  local words = {}
  for i, value in ipairs(spec.values) do words[i] = native.describe(value) end
  return table.concat(words, ", ", 1, #words - 1) .. (#words > 1 and " or " or "") .. words[#words]
end
function types.enum.check(value, spec, where)
  if types.is_one_of(value, spec.values) then return value end
  if type(value) == "string" then
    local words = {}
    for _, known in ipairs(spec.values) do words[#words + 1] = tostring(known) end
    local near = native.suggestion(value, words)
    if near:find("did you mean", 1, true) then
      local words_text = types.enum.expected(spec)
      places.fail(where.place, ("%s: expected %s, got %q%s"):format(where.path, words_text, value, near))
    end
  end
  expected(where, types.enum.expected(spec), value)
end

-- The order of blocks: one of spec.values, or a function of x and y that returns one.
types.order = {}
function types.order.expected(spec)
  return types.enum.expected(spec) .. ", or a function of x and y that returns one of them"
end
function types.order.check(value, spec, where)
  if type(value) == "function" or types.is_one_of(value, spec.values) then return value end
  expected(where, types.order.expected(spec), value)
end

-- A list of exactly `count` numbers.
local function tuple_type(words, count)
  local of_type = {}
  function of_type.expected(spec)
    return words .. unit_text(spec)
  end
  function of_type.check(value, spec, where)
    if type(value) ~= "table" or #value ~= count then expected(where, of_type.expected(spec), value) end
    for key in pairs(value) do
      if math.type(key) ~= "integer" then expected(where, of_type.expected(spec), value) end
    end
    local kept = {}
    for i = 1, count do
      kept[i] = types.number.check(value[i], { unit = spec.unit }, inside(where, ("[%d]"):format(i)))
    end
    return kept
  end
  return of_type
end

types.point = tuple_type("a point {x, y}", 2)
types.vector = tuple_type("a vector {x, y}", 2)
types.triple = tuple_type("{sxx, syy, sxy}", 3)

-- A list of things of one type: spec.of, at least spec.count of them. One alone stands for a list of one. Where
-- spec.nested is set, lists in it count as their elements.
local function flattened(value, where, within)
  within = within or {}
  if within[value] then places.fail(where.place, ("%s: expected lists of things, got a list that is in itself"):format(where.path)) end
  within[value] = true
  local flat = {}
  for _, element in ipairs(value) do
    local is_list = type(element) == "table" and getmetatable(element) == nil and (#element > 0 or not next(element))
    for _, one in ipairs(is_list and flattened(element, where, within) or { element }) do flat[#flat + 1] = one end
  end
  within[value] = nil
  return flat
end
types.list = {}
function types.list.expected(spec)
  local count = spec.count and (" of %d or more"):format(spec.count) or ""
  return ("a list%s, each element %s"):format(count, types.expected(spec.of))
end
function types.list.check(value, spec, where)
  local words = types.list.expected(spec)
  if type(value) == "table" and getmetatable(value) ~= nil then value = { value } end
  if type(value) ~= "table" or #value < (spec.count or 0) then expected(where, words, value) end
  for key in pairs(value) do
    if math.type(key) ~= "integer" or key < 1 or key > #value then
      local given = native.describe(key)
      places.fail(where.place, ("%s: expected %s, got the key %s in it"):format(where.path, words, given))
    end
  end
  for i = 1, #value do  -- { a, nil, b }: what follows would be lost
    if value[i] == nil then types.check(nil, spec.of, inside(where, ("[%d]"):format(i))) end
  end
  local kept = {}
  for i, element in ipairs(spec.nested and flattened(value, where) or value) do
    kept[i] = types.check(element, spec.of, inside(where, ("[%d]"):format(i)))
  end
  return kept
end

-- A number that may change with time: a constant, a list of {t, value}, or a function of t, tried at t = 0.
types.history = {}
function types.history.expected(spec)
  return "a number, a list of {t, value} or a function of t" .. unit_text(spec)
end
function types.history.check(value, spec, where)
  if type(value) == "number" then return types.number.check(value, spec, where) end
  if type(value) == "function" then
    local problem = native.try_law(value, { "t" }, { 0 })
    if problem then places.fail(where.place, ("%s: %s"):format(where.path, problem)) end
    return value
  end
  if type(value) ~= "table" or #value == 0 then expected(where, types.history.expected(spec), value) end
  local rows = {}
  for i, row in ipairs(value) do
    local at = inside(where, ("[%d]"):format(i))
    if type(row) ~= "table" or #row ~= 2 then expected(at, "{t, value}", row) end
    rows[i] = { types.number.check(row[1], { unit = "s" }, inside(at, "[1]")),
                types.number.check(row[2], spec, inside(at, "[2]")) }
    if i > 1 and rows[i][1] < rows[i - 1][1] then
      expected(inside(at, "[1]"), ("a time not before %g (s)"):format(rows[i - 1][1]), row[1])
    end
  end
  return rows
end

-- Two histories, along x and y.
types.histories = {}
function types.histories.expected(spec)
  return "{x, y}, each " .. types.history.expected(spec)
end
function types.histories.check(value, spec, where)
  if type(value) ~= "table" or #value ~= 2 then expected(where, types.histories.expected(spec), value) end
  return { types.history.check(value[1], spec, inside(where, "[1]")),
           types.history.check(value[2], spec, inside(where, "[2]")) }
end

-- A table with names as keys: spec.of for the values. Kept as a list of { name, value } sorted by name.
types.map = {}
function types.map.expected(spec)
  return "a table of name = " .. types.expected(spec.of)
end
function types.map.check(value, spec, where)
  if type(value) ~= "table" then expected(where, types.map.expected(spec), value) end
  local kept = {}
  for name, element in pairs(value) do
    if type(name) ~= "string" then expected(where, types.map.expected(spec), value) end
    kept[#kept + 1] = { name = name, value = types.check(element, spec.of, inside(where, "." .. name)) }
  end
  table.sort(kept, function(a, b) return a.name < b.name end)
  return kept
end

-- Any of several types: spec.of, tried by what their `accepts` says; the last is asked when none accepts.
types.any = {}
function types.any.expected(spec)
  local words = {}
  for i, of in ipairs(spec.of) do words[i] = types.expected(of) end
  return table.concat(words, ", or ")
end
function types.any.check(value, spec, where)
  for _, of in ipairs(spec.of) do
    if types.accepts(value, of) then return types.check(value, of, where) end
  end
  expected(where, types.any.expected(spec), value)
end

-- Whether a value is meant for this type, however wrong in detail: for types.any.
local lua_types = { number = "number", integer = "number", boolean = "boolean", string = "string", enum = "string",
  ["function"] = "function", point = "table", vector = "table", list = "table", map = "table" }
function types.accepts(value, spec)
  local of_type = types[spec.type]
  if of_type.accepts then return of_type.accepts(value, spec) end
  return type(value) == lua_types[spec.type]
end

function types.expected(spec)
  return types[spec.type].expected(spec)
end

function types.check(value, spec, where)
  return types[spec.type].check(value, spec, where)
end

return types
