-- What `require "talus"` gives in a plain lua5.4: talus.run. It runs in the host's own Lua, without the engine's library;
-- the Lua module (engine/module) loads it. A scene that is the program's script itself is handed to the engine.
local run, main, library, version = ...

local talus = { version = version }
local ran = false

local function reader(name)
  return assert(loadfile(("%s/talus/study/%s.lua"):format(library, name), "t"))()
end

local function describe(value)
  if type(value) == "string" then return ("%q"):format(value) end
  if type(value) == "number" or type(value) == "boolean" or value == nil then return tostring(value) end
  return "a " .. type(value)
end

local function expected(path, what, value)
  error(("talus.run: %s: expected %s, got %s"):format(path, what, describe(value)), 4)
end

-- { name = value, … } as { name, text, … }, in the order of the names.
local function list_of(parameters)
  local names, list = {}, {}
  for name, value in pairs(parameters) do
    if type(name) ~= "string" then expected("parameters", "name = value, …", name) end
    local kind = type(value)
    if kind ~= "number" and kind ~= "string" and kind ~= "boolean" then
      expected("parameters." .. name, "a number, a text, true or false", value)
    end
    names[#names + 1] = name
  end
  table.sort(names)
  for _, name in ipairs(names) do
    local value = parameters[name]
    list[#list + 1] = name
    list[#list + 1] = math.type(value) == "float" and ("%.17g"):format(value) or tostring(value)
  end
  return list
end

local known = { output = { "string", "a folder" }, on_step = { "function", "a function" },
                trust = { "boolean", "true or false" }, progress = { "boolean", "true or false" } }

local function check(scene, parameters, options)
  if type(scene) ~= "string" then expected("scene", "the name of a file", scene) end
  if type(parameters) ~= "table" then expected("parameters", "a table", parameters) end
  if type(options) ~= "table" then expected("options", "a table", options) end
  for name, value in pairs(options) do
    local wanted = known[name]
    if not wanted then expected("options", "output, on_step, progress or trust", name) end
    if type(value) ~= wanted[1] then expected("options." .. name, wanted[2], value) end
  end
end

-- Columns of history.csv by name; nil where the run wrote no results.
local function history_of(folder)
  local file = folder ~= "" and io.open(folder .. "/history.csv", "rb")
  if not file then return nil end
  local history = {}
  for _, column in ipairs(reader "csv"(file:read("a"))) do history[column.name] = column.values end
  file:close()
  return history
end

-- What run.json has of the first simulation, with its history; all of them are in `simulations`.
local function result_of(outcome)
  local simulations, json = {}, reader "json"
  for i, one in ipairs(outcome) do
    local simulation = json(one.report)
    simulation.folder = one.folder ~= "" and one.folder or nil
    simulation.history = history_of(one.folder)
    simulations[i] = simulation
  end
  local result = { status = outcome.status, simulations = simulations }
  for name, value in pairs(simulations[1] or {}) do result[name] = value end
  return result
end

-- talus.run(scene, parameters, options): the scene in an engine with a Lua of its own. An error is the engine's message.
function talus.run(scene, parameters, options)
  parameters, options = parameters or {}, options or {}
  check(scene, parameters, options)
  ran = true
  local list = list_of(parameters)
  local words = { ("talus.run(%q"):format(scene) }
  for i = 1, #list, 2 do words[#words + 1] = ("-p %s=%s"):format(list[i], list[i + 1]) end
  local outcome = run(scene, list, options.output, table.concat(words, " ") .. ")", options.trust, options.progress,
                      options.on_step)
  if outcome.status > 1 then error(outcome.message, 0) end  -- 1: a check failed, which `checks` tells
  return result_of(outcome)
end

-- The first use of what only scenes have (talus.param, talus.units, …) by the main script itself: it is a scene, and
-- `lua5.4 scene.lua …` does what `talus scene.lua …` does.
local function is_main_script()
  local caller = debug.getinfo(3, "S")
  return not ran and type(arg) == "table" and caller and caller.what == "main" and caller.source == "@" .. tostring(arg[0])
end

return setmetatable(talus, { __index = function(_, name)
  if not is_main_script() then
    error(("talus.%s: expected a scene, got a program of lua5.4: talus.run(\"scene.lua\") runs one, and so does lua5.4 scene.lua")
      :format(tostring(name)), 2)
  end
  io.stdout:flush()
  os.exit(main(table.move(arg, 0, #arg, 1, {})))
end })
