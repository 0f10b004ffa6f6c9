-- Meshes of Gmsh as ready blocks and boundary lines, by the names of their physical groups.
local native = require "talus.native"
local object = require "talus.object"
local places = require "talus.places"

-- A table of what the file has, in which an unknown name is answered with the nearest.
local function named(file, what, contents)
  return setmetatable(contents, {
    __index = function(_, name)
      local names = {}
      for known in pairs(contents) do names[#names + 1] = known end
      table.sort(names)
      places.fail(places.here(), ("gmsh: %s: there is no physical %s %q%s"):format(file, what, tostring(name),
        #names == 0 and "; it has none" or native.suggestion(tostring(name), names)))
    end,
  })
end

local function count(groups)
  local sum = 0
  for _, list in pairs(groups) do sum = sum + #list end
  return sum
end

local function gmsh(file, given)
  local fields = { file = file }
  if given ~= nil and (type(given) ~= "table" or getmetatable(given) ~= nil) then
    places.expected({ place = places.here(), path = "gmsh: options" }, "a table of fields", given)
  end
  for key, value in pairs(given or {}) do fields[key] = value end
  local options = object.new("gmsh", fields)
  local scale = object.get(options, "scale")
  local mesh = native.read_gmsh(object.given(options, "file"), scale)
  local blocks, curves, names = {}, {}, {}
  for name in pairs(mesh.surfaces) do names[#names + 1] = name end
  table.sort(names)
  for _, name in ipairs(names) do table.move(mesh.surfaces[name], 1, #mesh.surfaces[name], #blocks + 1, blocks) end
  for name, runs in pairs(mesh.curves) do
    curves[name] = {}
    for i, ends in ipairs(runs) do curves[name][i] = object.new("line", { from = ends[1], to = ends[2] }, object.place(options)) end
  end
  native.note(("%s: %d elements in %d groups, %d boundary lines; lengths times %g%s"):format(file, #blocks, #names, count(curves),
    scale, mesh.curved > 0 and ("; %d elements of second order taken by their corners"):format(mesh.curved) or ""))
  mesh.surfaces[""] = nil
  return { blocks = blocks, surfaces = named(file, "surface", mesh.surfaces), curves = named(file, "curve", curves) }
end

return gmsh
