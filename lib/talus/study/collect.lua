-- What a study takes from a finished run: a path in run.json, a value of its history, or what a function makes of it.
local native = require "talus.native"
local object = require "talus.object"
local csv = require "talus.study.csv"
local json = require "talus.study.json"
local get, given = object.get, object.given

local function fail(text, ...)
  error(text:format(...), 0)
end

local function keys_of(t)
  local names = {}
  for key in pairs(t) do names[#names + 1] = tostring(key) end
  table.sort(names)
  return names
end

-- The value at "energy.kinetic" or "checks[1].value". A key may have dots in it: the longest that is there is taken.
local function at_path(root, path)
  local value, rest = root, path
  while rest ~= "" do
    local index, after = rest:match("^%[(%d+)%]%.?(.*)$")
    local found
    if type(value) ~= "table" then fail("%s: %q is in something that has no parts", path, rest) end
    if index then
      found, rest = value[tonumber(index)], after
    else
      local key = rest
      while key and value[key] == nil do key = key:match("^(.*)[.%[]") end
      if not key then fail("run.json has no %s%s", path, native.suggestion(rest:match("^[^.%[]*"), keys_of(value))) end
      found, rest = value[key], rest:sub(#key + 1):gsub("^%.", "")
    end
    if found == nil then fail("run.json has no %s", path) end
    value = found
  end
  return value
end

-- Columns of a table, by name; an unknown one is answered with the nearest.
local function table_view(text, file)
  local columns, values, names = csv(text), {}, {}
  for i, column in ipairs(columns) do values[column.name], names[i] = column.values, column.name end
  local units = {}
  for _, column in ipairs(columns) do units[column.name] = column.unit end
  return setmetatable({}, {
    __index = function(_, name)
      local found = values[name]
      if not found then fail("%s has no column %s%s", file, tostring(name), native.suggestion(tostring(name), names)) end
      return found
    end,
    __pairs = function() return pairs(values) end,
    __metatable = false,
  }), units
end

local run_methods = {}
local lazy = {}  -- field of a run -> how it is read

local function read(run, name)
  local text = run.read(run.prefix .. name)
  if not text then fail("the run wrote no %s%s", run.prefix, name) end
  return text
end

function lazy.json(run)
  local text = read(run, "run.json")
  local worked, value = pcall(json, text)
  if not worked then fail("run.json cannot be read: %s", value) end
  return value
end

function lazy.history(run)
  local view, units = table_view(read(run, "history.csv"), "history.csv")
  run.units = units
  return view
end

-- A table that sim:table or a measure has written into the run's folder, by its name without .csv.
function run_methods.table(run, name)
  if type(name) ~= "string" or not name:match("^[%w_-]+$") then fail("run:table: expected a table's name without .csv") end
  return (table_view(read(run, name .. ".csv"), name .. ".csv"))
end

local function new_run(read_file, name, parameters, number)
  local run = { read = read_file, name = name, parameters = parameters, prefix = number > 1 and ("%d/"):format(number) or "" }
  return setmetatable(run, { __index = function(self, key)
    if lazy[key] then
      local value = lazy[key](self)
      rawset(self, key, value)
      return value
    end
    return run_methods[key]
  end })
end

-- The second, third, … simulation of a scene that makes several.
function run_methods.simulation(run, number)
  if math.type(number) ~= "integer" or number < 1 then fail("run:simulation: expected a number from 1 on") end
  run.others = run.others or {}
  run.others[number] = run.others[number] or new_run(run.read, run.name, run.parameters, number)
  return run.others[number]
end

local takes = {}
function takes.last(values) return values[#values] end
function takes.first(values) return values[1] end

local function fold(better)
  return function(values)
    local best = values[1]
    for _, value in ipairs(values) do
      if better(value, best) then best = value end
    end
    return best
  end
end
takes.max = fold(function(a, b) return a > b end)
takes.min = fold(function(a, b) return a < b end)
takes.largest = fold(function(a, b) return math.abs(a) > math.abs(b) end)
function takes.mean(values)
  local sum = 0
  for _, value in ipairs(values) do sum = sum + value end
  return sum/#values
end

-- Straight between the rows; outside of them there is no value.
local function at_time(times, values, t)
  local slack = 1e-9*math.max(math.abs(t), math.abs(times[#times] or 0))
  for i = 1, #times do
    if math.abs(times[i] - t) <= slack then return values[i] end
    if i > 1 and times[i - 1] < t and t < times[i] then
      return values[i - 1] + (values[i] - values[i - 1])*(t - times[i - 1])/(times[i] - times[i - 1])
    end
  end
  fail("its history, from %g s to %g s, has no t = %g s", times[1] or 0, times[#times] or 0, t)
end

local function value_of(spec, run)
  local source = run:simulation(get(spec, "simulation"))
  if given(spec, "run") then
    local value = at_path(source.json, given(spec, "run"))
    if type(value) ~= "table" or value.unit == nil then return value end
    return value.value, value.unit  -- a talus.result
  end
  if given(spec, "value") then return given(spec, "value")(source) end
  local name = given(spec, "history")
  local values = source.history[name]
  if #values == 0 then fail("history.csv has no row") end
  local at = given(spec, "at")
  return at and at_time(source.history.time, values, at) or takes[get(spec, "take")](values), source.units[name]
end

-- Values and units of all columns, each nil where there is none, and what went wrong first.
return function(columns, read_file, name, parameters)
  local run = new_run(read_file, name, parameters, 1)
  local values, units, problem = {}, {}, nil
  for i, column in ipairs(columns) do
    local worked, value, unit = pcall(value_of, column.value, run)
    local kind = type(value)
    if not worked then
      problem = problem or ("%s: %s"):format(column.name, tostring(value))
    elseif kind == "number" or kind == "string" or kind == "boolean" then
      values[i], units[i] = value, unit ~= "" and unit or nil
    else
      problem = problem or ("%s: expected a number, a text, true or false, got %s"):format(column.name, native.describe(value))
    end
  end
  return values, units, problem
end
