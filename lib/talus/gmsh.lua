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

-- The corners of the one closed line that `runs` make, counterclockwise, or nil.
local function loop_of(runs)
  if #runs < 3 then return nil end
  local meeting = {}  -- by place, the runs that end there
  local function at(point) return ("%a %a"):format(point[1], point[2]) end
  for r, ends in ipairs(runs) do
    for _, point in ipairs(ends) do
      meeting[at(point)] = meeting[at(point)] or {}
      table.insert(meeting[at(point)], r)
    end
  end
  local points, twice_area, run, from = {}, 0, 1, runs[1][1]
  repeat
    local ends = runs[run]
    local to = at(ends[1]) == at(from) and ends[2] or ends[1]
    local both = meeting[at(to)]
    if #both ~= 2 then return nil end
    points[#points + 1] = { from[1], from[2] }
    twice_area = twice_area + (from[1] - runs[1][1][1])*(to[2] - from[2]) - (from[2] - runs[1][1][2])*(to[1] - from[1])
    run, from = both[1] == run and both[2] or both[1], to
  until run == 1
  if #points < #runs then return nil end
  if twice_area > 0 then return points end
  local turned = {}
  for i, point in ipairs(points) do turned[#points + 1 - i] = point end
  return turned
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
  local blocks, curves, loops, names = {}, {}, {}, {}
  for name in pairs(mesh.surfaces) do names[#names + 1] = name end
  table.sort(names)
  for _, name in ipairs(names) do table.move(mesh.surfaces[name], 1, #mesh.surfaces[name], #blocks + 1, blocks) end
  for name, runs in pairs(mesh.curves) do
    curves[name] = {}
    for i, ends in ipairs(runs) do curves[name][i] = object.new("line", { from = ends[1], to = ends[2] }, object.place(options)) end
    local loop = loop_of(runs)
    if loop then loops[name] = object.wrap("outline", { points = loop, name = name }, object.place(options)) end
  end
  native.note(("%s: %d elements in %d groups, %d boundary lines; lengths times %g%s"):format(file, #blocks, #names, count(curves),
    scale, mesh.curved > 0 and ("; %d elements of second order taken by their corners"):format(mesh.curved) or ""))
  mesh.surfaces[""] = nil
  return { blocks = blocks, surfaces = named(file, "surface", mesh.surfaces), curves = named(file, "curve", curves),
           loops = named(file, "curve that closes", loops) }
end

return gmsh
