-- The Lua face of Talus: local talus = require "talus"
local native = require "talus.native"
local object = require "talus.object"
local places = require "talus.places"
local shape_types = require "talus.shape_types"

local talus = {}

-- A table whose unknown keys are answered with the nearest known one.
local function closed(name, contents)
  return setmetatable({}, {
    __index = function(_, key)
      if contents[key] ~= nil then return contents[key] end
      local names = {}
      for known in pairs(contents) do names[#names + 1] = known end
      table.sort(names)
      local suggestion = native.suggestion(tostring(key), names)
      places.fail(places.here(), ("%s.%s: there is no such thing%s"):format(name, key, suggestion))
    end,
    __newindex = function(_, key)
      places.fail(places.here(), ("%s.%s cannot be set"):format(name, key))
    end,
    __pairs = function() return pairs(contents) end,
    __metatable = false,
  })
end

for _, kind in ipairs { "material", "joint", "trace", "joint_set", "fix", "point_load", "edge_load", "pressure",
    "viscous", "contact", "probe", "grade", "charge", "stemming" } do
  talus[kind] = function(fields) return object.new(kind, fields) end
end

local laws = { hoek_brown = require("talus.fracture_laws").hoek_brown }
for _, kind in ipairs { "softening", "slip_weakening", "barton_bandis", "weibull" } do
  laws[kind] = function(fields) return object.new(kind, fields) end
end

local damping = { velocity = function(fields) return object.new("velocity_damping", fields) end }
local venting = { orifice = function(fields) return object.new("orifice", fields) end }
local eos = {}
for _, kind in ipairs { "polytropic", "jwl" } do
  eos[kind] = function(fields) return object.new(kind, fields) end
end

-- Studies are not needed by scenes, which start faster without them.
function talus.study(fields) return require "talus.study"(fields) end
function talus.latin_hypercube(fields)
  require "talus.study.settings"
  return object.new("latin_hypercube", fields)
end
for _, name in ipairs { "range", "log_range" } do
  talus[name] = function(...) return require("talus.study.ranges")[name](...) end
end

function talus.region(fields)
  local region = object.new("region", fields)
  shape_types.try_size(region)
  return region
end

for name, shape in pairs(require "talus.shapes") do talus[name] = shape end
for name, reader in pairs(require "talus.drawings") do talus[name] = reader end
talus.gmsh = require "talus.gmsh"
talus.simulation = require "talus.simulation"
talus.param = require "talus.param"
talus.result = require "talus.result"
talus.units = closed("talus.units", require("talus.units").units)
talus.laws = closed("talus.laws", laws)
talus.damping = closed("talus.damping", damping)
talus.eos = closed("talus.eos", eos)
talus.venting = closed("talus.venting", venting)
talus.explosives = closed("talus.explosives", require("talus.explosives").known)
talus.blast = closed("talus.blast", require "talus.blast")
talus.lab = closed("talus.lab", { compression = require("talus.lab").compression, brazilian = require("talus.lab").brazilian })
talus.calibrate = require "talus.calibrate"
talus.refine = require "talus.refine"
talus.check = closed("talus.check", require "talus.check")
talus.profile = closed("talus.profile", require("talus.profile").presets)

return closed("talus", talus)
