-- Field types of studies: setting, settings, interval, collected.
local object = require "talus.object"
local places = require "talus.places"
local types = require "talus.types"

local function is_list(value)
  return type(value) == "table" and getmetatable(value) == nil
end

-- What -p can set.
types.setting = {}
function types.setting.expected() return "a finite number, a text, true or false" end
function types.setting.check(value, _, where)
  local kind = type(value)
  local good = kind == "number" and value == value and math.abs(value) < math.huge or kind == "boolean"
    or kind == "string" and not value:find("[%c]")
  if not good then places.expected(where, types.setting.expected(), value) end
  return value
end

types.settings = {}
function types.settings.expected() return "a number, a text, true or false, or a list of these" end
function types.settings.check(value, _, where)
  if not is_list(value) then value = { value } end
  if #value == 0 then places.expected(where, types.settings.expected(), value) end
  return types.list.check(value, { of = { type = "setting" } }, where)
end

types.interval = {}
function types.interval.expected() return "{low, high} with low < high" end
function types.interval.check(value, _, where)
  if not is_list(value) or #value ~= 2 then places.expected(where, types.interval.expected(), value) end
  local low = types.number.check(value[1], {}, places.inside(where, "[1]"))
  local high = types.number.check(value[2], {}, places.inside(where, "[2]"))
  if low >= high then places.fail(where.place, ("%s: expected %s, got {%g, %g}"):format(where.path, types.interval.expected(), low, high)) end
  return { low, high }
end

-- A path, a function or a table of collect fields; kept as a collect object.
types.collected = {}
function types.collected.expected() return "a path in run.json, a table of collect fields, or a function of the run" end
function types.collected.check(value, _, where)
  if type(value) == "string" then return object.wrap("collect", { run = value }, where.place, where.path) end
  if type(value) == "function" then return object.wrap("collect", { value = value }, where.place, where.path) end
  if not is_list(value) or #value > 0 then places.expected(where, types.collected.expected(), value) end
  return object.new("collect", value, where.place, where.path)
end

local settings = {}

-- As -p reads it back: the shortest text that gives the same number.
function settings.text(value)
  if type(value) ~= "number" then return tostring(value) end
  if value == math.floor(value) and math.abs(value) < 1e15 then return ("%d"):format(value) end
  for digits = 6, 17 do
    local text = ("%." .. digits .. "g"):format(value)
    if tonumber(text) == value then return text end
  end
end

return settings
