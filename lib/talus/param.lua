-- talus.param: a number, text or truth that the command line may set with -p name=value.
local native = require "talus.native"
local places = require "talus.places"

local readers = {}

function readers.number(text)
  local value = tonumber(text)
  return value and value == value and math.abs(value) < math.huge and value or nil
end

function readers.boolean(text)
  if text == "true" then return true elseif text == "false" then return false end
end

function readers.string(text)
  return text
end

local expected = { number = "a number", boolean = "true or false" }

return function(name, default, meaning)
  local place = places.here()
  if type(name) ~= "string" or not name:match("^[%a_][%w_]*$") then
    places.expected({ place = place, path = "param name" }, "a name of letters, digits and _", name)
  end
  local read = readers[type(default)]
  if not read then
    local where = { place = place, path = ("param %s: default"):format(name) }
    places.expected(where, "a number, a text, true or false", default)
  end
  local text = native.parameter(name, ("= %s%s"):format(default, meaning and ("  (%s)"):format(meaning) or ""), type(default))
  if text == nil then return default end
  local value = read(text)
  if value == nil then
    places.expected({ place = place, path = "-p " .. name }, expected[type(default)], text)
  end
  return value
end
