-- One object -> the flat table that the engine reads: references are 1-based indices, choices are plain words,
-- defaults are filled in. `links` resolves references (assemble.lua).
local object = require "talus.object"
local places = require "talus.places"
local profile = require "talus.profile"
local laws = require "talus.fracture_laws"
local get, given = object.get, object.given

local flatten = {}

-- The named fields, as given or by default.
function flatten.fields(self, names)
  local flat = { place = object.place(self) }
  for _, name in ipairs(names) do flat[name] = get(self, name) end
  return flat
end

function flatten.material(material, name)
  local flat = flatten.fields(material, { "density", "young", "poisson", "plane" })
  flat.name = name
  return flat
end

-- A joint that stands for contacts or bonds of rock with Young's modulus `young`.
function flatten.joint(joint, name, chosen, young)
  local flat = { place = object.place(joint), name = name }
  for _, field in ipairs { "friction", "cohesion", "tension", "bond", "penalty", "shear_ratio", "restitution" } do
    flat[field] = profile.joint_value(joint, field, chosen)
  end
  laws.flatten(joint, flat)
  local stiffness = profile.joint_value(joint, "stiffness", chosen)
  if type(stiffness) == "number" then
    flat.stiffness_kind, flat.stiffness = "length", stiffness
  else
    flat.stiffness_kind = get(stiffness, "per")
    flat.stiffness = given(stiffness, "value") or given(stiffness, "times_young")*young
  end
  return flat
end

local function box_of(region)
  local low, high = { math.huge, math.huge }, { -math.huge, -math.huge }
  local outlines = given(region, "blocks") or { given(region, "outline") }
  for _, outline in ipairs(outlines) do
    for _, point in ipairs(given(outline, "points")) do
      for i = 1, 2 do
        low[i], high[i] = math.min(low[i], point[i]), math.max(high[i], point[i])
      end
    end
  end
  return low, high
end

local function side_of(region, side)
  local low, high = box_of(region)
  local left_bottom, right_bottom, right_top, left_top = low, { high[1], low[2] }, high, { low[1], high[2] }
  local ends = {
    left = { left_bottom, left_top }, right = { right_bottom, right_top },
    bottom = { left_bottom, right_bottom }, top = { left_top, right_top },
  }
  return { kind = "line", from = ends[side][1], to = ends[side][2] }
end

-- `on` of a fixity or load as a list of { kind, from, to }.
local function targets(self, links)
  local on = given(self, "on")
  if not on then return { { kind = "region" } } end
  local list = {}
  for i, one in ipairs(on) do
    local kind = object.kind(one)
    if kind == "line" then
      list[i] = { kind = "line", from = one.from, to = one.to }
    elseif kind == "point" then
      list[i] = { kind = "point", from = one.at }
    else
      list[i] = side_of(links.region(given(self, "region"), self), one)
    end
  end
  return list
end

-- The following return a list: one entry for each line or side that the object acts on.
function flatten.fix(fix, name, links)
  local list = {}
  local x, y = given(fix, "x"), given(fix, "y")
  if x == nil then x = y ~= true end
  if y == nil then y = given(fix, "x") ~= true end
  for i, on in ipairs(targets(fix, links)) do
    local flat = flatten.fields(fix, { "displacement", "velocity", "spin" })
    flat.name, flat.region, flat.on = name, links.region_index(given(fix, "region"), fix), on
    flat.x, flat.y = x, y
    list[i] = flat
  end
  return list
end

function flatten.point_load(load, name, links)
  local flat = flatten.fields(load, { "at", "force" })
  flat.name = name
  flat.region = links.region_index(given(load, "region"), load)
  return { flat }
end

local function on_edges(load, name, links)
  local list = {}
  for i, on in ipairs(targets(load, links)) do
    local region = links.region_index(given(load, "region"), load)
    list[i] = { place = object.place(load), name = name, region = region, on = on }
  end
  return list
end

function flatten.edge_load(load, name, links)
  local list = on_edges(load, name, links)
  for _, flat in ipairs(list) do flat.traction = given(load, "traction") end
  return list
end

function flatten.pressure(load, name, links)
  local list = on_edges(load, name, links)
  for _, flat in ipairs(list) do flat.pressure = given(load, "value") end
  return list
end

function flatten.viscous(boundary, links)
  return on_edges(boundary, nil, links)
end

-- Adds the source to a list, once for each place: `named` has lists of { hole = index } or { points = … }, as the traces
-- of a drawing's layer have one name.
local function flatten_source(source, far, region, named, list)
  local at, size = given(source, "at"), given(source, "size")
  local reach = given(source, "reach") or math.max((far - size)/0.3, size)
  if type(at) == "string" and not named[at] then
    places.expected({ place = object.place(source), path = "grade.at" },
      ("the name of a hole or trace of region %q"):format(region), at)
  end
  for _, place in ipairs(type(at) == "string" and named[at] or { at }) do
    list[#list + 1] = { size = size, reach = reach, points = place.points, closed = place.closed, hole = place.hole }
  end
end

local function flatten_mesh(mesh, region, named)
  local flat = flatten.fields(mesh, { "kind", "nx", "ny", "seed" })
  local size = given(mesh, "size")
  if type(size) == "number" then
    flat.size = size
  elseif type(size) == "function" then
    flat.size_law = size
  elseif size then
    local far = given(size, "far")
    flat.grade = { far = far, sources = {} }
    for _, source in ipairs(given(size, "sources")) do
      flatten_source(source, far, region, named, flat.grade.sources)
    end
  end
  return flat
end

-- Of persistence, trace_length and gap two give the third (rules.joint_set); the engine takes the first two.
local function jointed_part(set)
  local persistence, length, gap = given(set, "persistence"), given(set, "trace_length"), given(set, "gap")
  if gap and length then return length/(length + gap), length end
  if gap then return persistence, gap*persistence/(1 - persistence) end
  return persistence or 1, length
end

local function flatten_joint_set(set)
  local entry = flatten.fields(set, { "dip", "spacing", "spacing_scatter", "dip_scatter", "trace_length_scatter",
    "gap_scatter", "through", "seed", "bonded" })
  entry.persistence, entry.trace_length = jointed_part(set)
  return entry
end

local function flatten_cuts(flat, region, joint_index)
  flat.traces, flat.joint_sets = {}, {}
  for _, cut in ipairs(given(region, "cuts") or {}) do
    local list, entry
    if object.kind(cut) == "trace" then
      list, entry = flat.traces, flatten.fields(cut, { "points", "bonded" })
      entry.drawn = given(cut, "drawn")
    else
      list = flat.joint_sets
      entry = flatten_joint_set(cut)
    end
    local joint = given(cut, "joint")
    entry.property = joint and joint_index(joint) or flat.joint
    list[#list + 1] = entry
  end
end

local function flatten_stress(stress)
  return { value = { get(stress, "sxx"), get(stress, "syy"), get(stress, "sxy") },
           gradient_x = get(stress, "gradient_x"), gradient_y = get(stress, "gradient_y") }
end

local order_names = { [1] = "first", [2] = "second", rigid = "rigid" }

-- `joint_index(joint)` is the index of a property for this region; `default_joint` that of a region without one.
function flatten.region(region, name, material_index, joint_index, default_joint)
  local flat = flatten.fields(region, { "held", "velocity", "spin", "spin_centre", "body_force", "slivers",
    "sliver_part" })
  flat.name, flat.material = name, material_index
  flat.joint = joint_index(given(region, "joint") or default_joint)
  local order = get(region, "order")
  if type(order) == "function" then flat.order_law = order else flat.order = order_names[order] end
  flat.outlines, flat.holes = {}, {}
  for i, outline in ipairs(given(region, "blocks") or { given(region, "outline") }) do
    flat.outlines[i] = given(outline, "points")
  end
  local named = {}
  local function add_name(name, place)
    named[name] = named[name] or {}
    table.insert(named[name], place)
  end
  for _, cut in ipairs(given(region, "cuts") or {}) do
    local name = object.kind(cut) == "trace" and given(cut, "name")
    if name then add_name(name, { points = given(cut, "points") }) end
  end
  for i, outline in ipairs(given(region, "holes") or {}) do
    local hole = given(outline, "name") or ("hole %d"):format(i)
    add_name(hole, { hole = i })
    flat.holes[i] = { place = object.place(outline), name = hole, outline = given(outline, "points") }
  end
  if get(region, "bonded") then flat.mesh = { place = object.place(region), kind = "given" } end
  if given(region, "mesh") then flat.mesh = flatten_mesh(given(region, "mesh"), name, named) end
  flatten_cuts(flat, region, joint_index)
  if given(region, "stress") then flat.stress = flatten_stress(given(region, "stress")) end
  return flat
end

return flatten
