-- talus.simulation, and the methods of a simulation that need no engine.
local native = require "talus.native"
local object = require "talus.object"
local places = require "talus.places"
local assemble = require "talus.assemble"
local saving = require "talus.saving"

local rosters = setmetatable({}, { __mode = "k" })  -- simulation -> rosters of its objects
local methods = native.methods

local function simulation(fields)
  local checked = object.new("simulation", fields)
  local assembly = assemble(checked)
  local sim = native.create(assembly.scene)
  rosters[sim] = assembly.rosters
  for _, change in ipairs(assembly.changes) do
    object.bind(change.object, sim, function()
      native.update(sim, change.list, change.index, change.flat(), object.kind(change.object))
    end)
  end
  for _, part in ipairs(assembly.settled) do object.bind(part, sim, function() end) end
  saving.keep(sim, assembly.changes)
  return sim
end

-- sim:material("rock"), sim:material(1): the object as the script made it, to be read and changed.
for _, word in ipairs { "material", "joint", "region", "fix", "load" } do
  methods[word] = function(sim, wanted)
    local roster = rosters[sim][word]
    if roster.list[wanted] then return roster.list[wanted] end
    local found
    for i, name in ipairs(roster.names) do
      if name == wanted then
        if found then
          places.fail(places.here(), ("sim:%s: expected a name that one %s has, got %s, which several have: give its number, in the order of the list")
            :format(word, word, native.describe(wanted)))
        end
        found = roster.list[i]
      end
    end
    if found then return found end
    places.fail(places.here(), ("sim:%s: there is no %s %s%s"):format(word, word, native.describe(wanted),
      native.suggestion(tostring(wanted), roster.names)))
  end
end

-- sim:explain(12), sim:explain(sim.joints[12]): why the bond has failed, or why not
methods.explain = native.explain

-- for status in sim:steps() do … end
function methods.steps(sim)
  return function() return sim:step() end
end

-- sim:log("%d blocks", #sim.blocks)
function methods.log(sim, format, ...)
  local formatted, text = pcall(string.format, format, ...)
  if not formatted then places.fail(places.here(), ("sim:log: %s"):format(text)) end
  print(("[t = %.6g s] %s"):format(sim.time, text))
end

return simulation
