-- sim:save and sim:restore. The engine keeps its own state; of the script's data only sim.state is kept, and the live
-- fields of the objects that the simulation uses, so that they show what the engine works with.
local native = require "talus.native"
local object = require "talus.object"
local places = require "talus.places"
local methods, saving = native.methods, native.saving

local users = setmetatable({}, { __mode = "k" })  -- simulation -> list of the objects it uses

-- Those of an assembly's changes, each once.
local function keep(sim, changes)
  local list, seen = {}, {}
  for _, change in ipairs(changes) do
    if not seen[change.object] then list[#list + 1], seen[change.object] = change.object, true end
  end
  users[sim] = list
end

local function state_of(sim)
  local objects, laws = {}, {}
  for i, self in ipairs(users[sim]) do objects[i] = object.freeze(self, laws) end
  return saving.save(sim, objects, laws)
end

-- For the program's --checkpoint: nothing, or why it could not be written.
function saving.checkpoint(sim, file)
  return saving.write(state_of(sim), file)
end

-- sim:save(), sim:save("file")
function methods.save(sim, file)
  if file ~= nil and (type(file) ~= "string" or file == "") then
    places.expected({ place = places.here(), path = "sim:save" }, "a file's name or nothing", file)
  end
  if file then saving.check_name(file) end
  local state = state_of(sim)
  local trouble = file and saving.write(state, file)
  if trouble then places.fail(places.here(), "sim:save: " .. trouble) end
  return state
end

-- sim:restore(state), sim:restore("file")
function methods.restore(sim, from)
  local saved, objects, laws = saving.open(sim, from)
  local place, changed = places.here(), {}
  for i, self in ipairs(users[sim]) do changed[i] = object.thaw(self, objects[i], laws, place) end
  for i, self in ipairs(users[sim]) do object.put(self, changed[i]) end
  saving.restore(sim, saved)
end

-- sim:hash()
methods.hash = saving.hash

return { keep = keep }
