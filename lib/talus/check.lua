-- talus.check: each call prints one line (PASS or FAIL, name, value, expected), and keeps it for run.json.
-- Any FAIL makes the exit status of the program 1.
local native = require "talus.native"
local places = require "talus.places"

local check = {}

local function text_of(value)
  if type(value) == "number" then return ("%.7g"):format(value) end
  return native.describe(value)
end

local function report(name, value, expected, pass)
  if type(name) ~= "string" then
    places.expected({ place = places.here(), path = "check: name" }, "a text", name)
  end
  print(("%s  %s  %s  expected %s"):format(pass and "PASS" or "FAIL", name, value, expected))
  native.add_check(name, value, expected, pass)
  return pass
end

-- A bound must be a number; a value that is none is a failed check, not a mistake of the scene.
local function need_number(what, value)
  if type(value) ~= "number" or value ~= value then
    places.expected({ place = places.here(), path = "check: " .. what }, "a number", value)
  end
end

local function is_number(value)
  return type(value) == "number"
end

local function tolerance_of(expected, options)
  local where = { place = places.here(), path = "check.near: tolerance" }
  if type(options) ~= "table" then places.expected(where, "{ rel = …, abs = … }", options) end
  for key, value in pairs(options) do
    if key ~= "rel" and key ~= "abs" then places.expected(where, "{ rel = …, abs = … }", key) end
    need_number(key, value)
  end
  if not options.rel and not options.abs then places.expected(where, "rel, abs or both", nil) end
  return math.max((options.rel or 0)*math.abs(expected), options.abs or 0)
end

function check.near(name, value, expected, options)
  need_number("expected", expected)
  local tolerance = tolerance_of(expected, options)
  local pass = is_number(value) and math.abs(value - expected) <= tolerance
  local bound = ("%.7g ± %.3g"):format(expected, tolerance)
  if is_number(value) and expected ~= 0 then
    bound = ("%s (off by %.3g %%)"):format(bound, 100*(value/expected - 1))
  end
  return report(name, text_of(value), bound, pass)
end

function check.below(name, value, bound)
  need_number("bound", bound)
  return report(name, text_of(value), "< " .. text_of(bound), is_number(value) and value < bound)
end

function check.above(name, value, bound)
  need_number("bound", bound)
  return report(name, text_of(value), "> " .. text_of(bound), is_number(value) and value > bound)
end

function check.between(name, value, low, high)
  need_number("low", low)
  need_number("high", high)
  return report(name, text_of(value), ("in [%s, %s]"):format(text_of(low), text_of(high)),
    is_number(value) and value >= low and value <= high)
end

function check.equal(name, value, expected)
  return report(name, text_of(value), text_of(expected), value == expected)
end

function check.truth(name, value)
  return report(name, text_of(value), "true", value == true)
end

return check
