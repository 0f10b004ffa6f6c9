-- Values for the parameters of a study: talus.range, talus.log_range, and the points of a Latin hypercube.
local object = require "talus.object"
local places = require "talus.places"
local get, given = object.get, object.given

local ranges = {}

-- 0.1 + 2*0.1 is 0.30000000000000004: nobody wants that in a folder's name.
local function rounded(value)
  return tonumber(("%.12g"):format(value))
end

local function check(call, from, to, count)
  for name, value in pairs { from = from, to = to } do
    if type(value) ~= "number" or value ~= value or math.abs(value) == math.huge then
      places.expected({ place = places.here(), path = call .. ": " .. name }, "a finite number", value)
    end
  end
  if math.type(count) ~= "integer" or count < 2 or count > 100000 then
    places.expected({ place = places.here(), path = call .. ": count" }, "an integer in [2, 100000]", count)
  end
end

-- `count` values from `from` to `to`, evenly spaced.
function ranges.range(from, to, count)
  check("range", from, to, count)
  local values = {}
  for i = 0, count - 1 do values[i + 1] = rounded(from + (to - from)*i/(count - 1)) end
  return values
end

-- The same, each a fixed factor from the one before.
function ranges.log_range(from, to, count)
  check("log_range", from, to, count)
  for name, value in pairs { from = from, to = to } do
    if value <= 0 then places.expected({ place = places.here(), path = "log_range: " .. name }, "a number > 0", value) end
  end
  local values = {}
  for i = 0, count - 1 do values[i + 1] = rounded(from*(to/from)^(i/(count - 1))) end
  return values
end

-- splitmix64, as in engine/geometry/random.h; math.random would depend on what the study has drawn before.
local function generator(state)
  return function()
    state = state + 0x9e3779b97f4a7c15
    local z = state
    z = (z ~ (z >> 30))*0xbf58476d1ce4e5b9
    z = (z ~ (z >> 27))*0x94d049bb133111eb
    return ((z ~ (z >> 31)) >> 11)*2.0^-53
  end
end

local function permutation(n, random)
  local list = {}
  for i = 1, n do list[i] = i end
  for i = n, 2, -1 do
    local k = 1 + math.floor(random()*i)
    list[i], list[k] = list[k], list[i]
  end
  return list
end

local function set_of(sample, field)
  local names, known = {}, {}
  for _, range in ipairs(given(sample, "ranges")) do known[range.name] = true end
  for _, name in ipairs(given(sample, field) or {}) do
    if not known[name] then
      places.expected({ place = object.place(sample), path = "latin_hypercube." .. field }, "names of its ranges", name)
    end
    names[name] = true
  end
  return names
end

-- The points of a talus.latin_hypercube: a list of tables name -> value.
function ranges.points(sample)
  local n, random = get(sample, "n"), generator(get(sample, "seed"))
  local log, whole = set_of(sample, "log"), set_of(sample, "whole")
  local points = {}
  for i = 1, n do points[i] = {} end
  for _, range in ipairs(given(sample, "ranges")) do
    local low, high = range.value[1], range.value[2]
    if log[range.name] and low <= 0 then
      places.fail(object.place(sample), ("latin_hypercube.ranges.%s: expected low > 0, as it is in log, got %g"):format(range.name, low))
    end
    local cells = permutation(n, random)
    for i = 1, n do
      local share = (cells[i] - 1 + random())/n
      local top = whole[range.name] and high + 1 or high  -- each whole number has the part of the range up to the next
      local value = log[range.name] and low*(top/low)^share or low + (top - low)*share
      if whole[range.name] then value = math.min(high, math.floor(value)) end
      points[i][range.name] = whole[range.name] and value or tonumber(("%.6g"):format(value))
    end
  end
  return points
end

return ranges
