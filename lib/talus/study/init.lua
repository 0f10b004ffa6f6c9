-- talus.study: checks it, and hands the program the list of its runs and how to collect from one.
local native = require "talus.native"
local object = require "talus.object"
local places = require "talus.places"
local settings = require "talus.study.settings"
local runs_of = require "talus.study.runs"
local collect = require "talus.study.collect"
local get, given = object.get, object.given

local taken = { run = true, status = true, message = true, wall = true, cpu = true }  -- columns of every table

local function columns_of(study, parameters)
  local columns = {}
  for _, entry in ipairs(given(study, "collect") or {}) do
    local clash = taken[entry.name] and "a column that every table has"
    for _, name in ipairs(parameters) do clash = clash or name == entry.name and "a parameter" end
    if clash then
      places.fail(object.place(study), ("study.collect.%s: expected a name of its own, got that of %s"):format(entry.name, clash))
    end
    columns[#columns + 1] = entry
  end
  return columns
end

local function flat_columns(columns)
  local list = {}
  for i, column in ipairs(columns) do
    list[i] = { name = column.name, unit = given(column.value, "unit") or "", label = given(column.value, "label") or column.name:gsub("_", " "),
                log = get(column.value, "log") }
  end
  return list
end

local function flat_runs(runs, parameters)
  local list = {}
  for i, run in ipairs(runs) do
    local values = {}
    for _, name in ipairs(parameters) do
      local value = run.values[name]
      if value ~= nil then
        values[#values + 1] = { name = name, text = settings.text(value), kind = type(value),
                                number = type(value) == "number" and value or nil }
      end
    end
    list[i] = { name = run.name, values = values }
  end
  return list
end

local function flat_slurm(study)
  local slurm = given(study, "slurm")
  if not slurm then return { cpus = 1 } end
  local flat = { extra = {} }
  for _, name in ipairs { "time", "memory", "cpus", "partition", "account", "at_once" } do flat[name] = get(slurm, name) end
  for i, option in ipairs(given(slurm, "extra") or {}) do flat.extra[i] = { text = option } end
  return flat
end

return function(fields)
  local study = object.new("study", fields)
  local runs, parameters = runs_of(study)
  local columns = columns_of(study, parameters)
  local values, names = {}, {}
  for i, run in ipairs(runs) do values[i] = run.values end
  for i, name in ipairs(parameters) do names[i] = { name = name } end
  local place = object.place(study)
  native.study {
    place = place, scene = given(study, "scene"), dir = given(study, "dir") or "", title = given(study, "title") or "",
    seed_parameter = given(study, "seeds") and get(study, "seed_parameter") or "", time_limit = given(study, "time_limit"),
    parameters = names, runs = flat_runs(runs, parameters), columns = flat_columns(columns), slurm = flat_slurm(study),
    collect = function(run, read_file) return collect(columns, read_file, runs[run].name, values[run]) end,
  }
end
