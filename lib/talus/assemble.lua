-- A checked talus.simulation -> the flat scene for the engine, and what has to be told to the engine when an
-- object is changed later. Each object gets one index, however often it is used; a joint whose stiffness goes
-- by Young's modulus gets one for each modulus.
local native = require "talus.native"
local object = require "talus.object"
local places = require "talus.places"
local flatten = require "talus.flatten"
local gas = require "talus.gas"
local profile = require "talus.profile"
local get, given = object.get, object.given

-- Named objects of one kind in order of first use: what sim:material(name) and its like look through.
local function new_roster(word)
  local roster = { word = word, list = {}, names = {}, index = {} }
  function roster.add(self)
    if roster.index[self] then return roster.names[roster.index[self]] end
    local name = given(self, "name") or ("%s %d"):format(word, #roster.list + 1)
    roster.list[#roster.list + 1] = self
    roster.names[#roster.names + 1] = name
    roster.index[self] = #roster.list
    return name
  end
  return roster
end

local function new_assembly(simulation)
  return {
    simulation = simulation,
    profile = profile.by_name[get(given(simulation, "numerics") or profile.presets.default, "profile")],
    rosters = { material = new_roster "material", joint = new_roster "joint", region = new_roster "region",
                fix = new_roster "fix", load = new_roster "load" },
    scene = { materials = {}, properties = {}, regions = {}, contact_rules = {}, fixities = {}, point_loads = {},
              edge_loads = {}, viscous = {}, probes = {} },
    properties = {},  -- joint -> { [young or false] = index }
    changes = {},     -- { object, list, index, flat = function() … end }
    settled = {},     -- objects that must stay as they are
  }
end

local function on_change(assembly, self, list, index, flat)
  table.insert(assembly.changes, { object = self, list = list, index = index, flat = flat })
end

local function material_index(assembly, material)
  local roster = assembly.rosters.material
  local index = roster.index[material]
  if index then return index end
  local name = roster.add(material)
  index = roster.index[material]
  local function flat() return flatten.material(material, name) end
  assembly.scene.materials[index] = flat()
  on_change(assembly, material, "materials", index, flat)
  return index
end

local function joint_index(assembly, joint, young)
  local stiffness = profile.joint_value(joint, "stiffness", assembly.profile)
  local key = type(stiffness) ~= "number" and given(stiffness, "times_young") and young or false
  local known = assembly.properties[joint] or {}
  assembly.properties[joint] = known
  if known[key] then return known[key] end
  local name = assembly.rosters.joint.add(joint)
  local function flat() return flatten.joint(joint, name, assembly.profile, young) end
  local index = #assembly.scene.properties + 1
  known[key] = index
  assembly.scene.properties[index] = flat()
  on_change(assembly, joint, "properties", index, flat)
  return index
end

local function young_of(region)
  return given(given(region, "material"), "young")
end

local function softest(regions)
  local young = math.huge
  for _, region in ipairs(regions) do young = math.min(young, young_of(region)) end
  return young
end

-- The region that `wanted`, a name or a region, stands for; `asker` is the object that names it.
local function find_region(assembly, wanted, asker)
  local roster = assembly.rosters.region
  if roster.index[wanted] then return wanted end
  if type(wanted) == "string" then
    for i, name in ipairs(roster.names) do
      if name == wanted then return roster.list[i] end
    end
  end
  local name = type(wanted) == "string" and wanted or given(wanted, "name") or "of this name"
  places.fail(object.place(asker), ("%s.region: the simulation has no region %q%s"):format(object.kind(asker),
    name, native.suggestion(name, roster.names)))
end

local function links_of(assembly)
  return {
    region = function(wanted, asker) return find_region(assembly, wanted, asker) end,
    region_index = function(wanted, asker)
      return wanted and assembly.rosters.region.index[find_region(assembly, wanted, asker)]
    end,
  }
end

local function check_new(region, roster, i)
  if roster.index[region] then
    places.fail(object.place(region),
      ("simulation.regions[%d]: expected another region, got the same twice"):format(i))
  end
  for k, name in ipairs(roster.names) do
    if name == given(region, "name") then
      places.fail(object.place(region),
        ("region.name: expected a name of its own, got %q, the name of region %d"):format(name, k))
    end
  end
end

local function add_regions(assembly, regions, contact)
  local roster = assembly.rosters.region
  for i, region in ipairs(regions) do
    check_new(region, roster, i)
    local name = roster.add(region)
    local material = material_index(assembly, given(region, "material"))
    local function property(joint) return joint_index(assembly, joint, young_of(region)) end
    assembly.scene.regions[i] = flatten.region(region, name, material, property, contact)
  end
end

local function add_contacts(assembly, rules)
  for i, rule in ipairs(rules) do
    local between = given(rule, "between")
    if #between ~= 2 then
      places.fail(object.place(rule), ("contact.between: expected two regions, got %d"):format(#between))
    end
    local a, b = find_region(assembly, between[1], rule), find_region(assembly, between[2], rule)
    local index = assembly.rosters.region.index
    assembly.scene.contact_rules[i] = { place = object.place(rule), region_a = index[a], region_b = index[b],
      property = joint_index(assembly, given(rule, "joint"), softest { a, b }) }
  end
end

local function add_entries(assembly, self, list_name, flatten_kind, name, links)
  local list = assembly.scene[list_name]
  for i, entry in ipairs(flatten_kind(self, name, links)) do
    list[#list + 1] = entry
    on_change(assembly, self, list_name, #list, function() return flatten_kind(self, name, links)[i] end)
  end
end

local load_lists = { point_load = "point_loads", edge_load = "edge_loads", pressure = "edge_loads" }

local function add_boundaries(assembly, links)
  for _, fix in ipairs(given(assembly.simulation, "fix") or {}) do
    add_entries(assembly, fix, "fixities", flatten.fix, assembly.rosters.fix.add(fix), links)
  end
  for _, load in ipairs(given(assembly.simulation, "loads") or {}) do
    local kind = object.kind(load)
    add_entries(assembly, load, load_lists[kind], flatten[kind], assembly.rosters.load.add(load), links)
  end
end

local function add_viscous(assembly, links)
  local list = assembly.scene.viscous
  for _, boundary in ipairs(given(assembly.simulation, "boundaries") or {}) do
    for _, entry in ipairs(flatten.viscous(boundary, links)) do list[#list + 1] = entry end
  end
end

local function add_charges(assembly, charges, regions, links)
  assembly.scene.charges = gas.flatten(charges, regions, links)
  for _, charge in ipairs(charges) do
    for _, part in ipairs(gas.parts(charge)) do table.insert(assembly.settled, part) end
  end
end

-- Names of columns.
local function check_printable(self, field, name)
  if name:find("%c") then
    places.fail(object.place(self), ("%s: expected a name without line ends and other control characters, got %q"):format(field, name))
  end
end

local function add_probes(assembly, links)
  local moving = {}
  for i, fix in ipairs(assembly.rosters.fix.list) do
    if given(fix, "displacement") or given(fix, "velocity") then moving[assembly.rosters.fix.names[i]] = true end
  end
  for i, entry in ipairs(given(assembly.simulation, "probes") or {}) do
    local probe = entry.value
    local is_object = object.kind(probe) == "probe"
    check_printable(assembly.simulation, "simulation.probes", entry.name)
    if moving[entry.name] then
      places.fail(object.place(assembly.simulation),
        ("simulation.probes: expected another name than %q, which a fix that moves has: both have columns of history.csv"):format(entry.name))
    end
    assembly.scene.probes[i] = {
      name = entry.name,
      place = is_object and object.place(probe) or object.place(assembly.simulation),
      at = is_object and probe.at or probe,
      region = is_object and links.region_index(given(probe, "region"), probe) or nil,
    }
  end
end

local function time_of(time)
  local flat = flatten.fields(time, { "mode", "t_end", "steps", "dt", "dt_min", "dt_max", "tolerance", "displacement_ratio",
    "max_steps" })
  flat.settled_start = get(time, "start") == "settled"
  return flat
end

local function numerics_of(numerics)
  local flat = { place = object.place(numerics) }
  local damping = given(numerics, "damping")
  if object.kind(damping) then flat.damping_rate = get(damping, "rate") else flat.damping = damping end
  for _, name in ipairs { "profile", "integrator", "theta", "dynamic_parameter", "contact_tolerance",
      "static_tolerance", "max_iterations", "threads", "islands",
      "sleeping", "solver", "recovery" } do
    flat[name] = profile.numerics_value(numerics, name)
  end
  return flat
end

local function picture_of(flat, picture)
  flat.picture = picture ~= false
  if type(picture) == "string" then
    flat.picture_field = picture
  elseif object.kind(picture) then
    flat.picture_field, flat.picture_scale = get(picture, "field"), get(picture, "scale")
  end
end

local function output_of(output, simulation)
  if not output then return { place = object.place(simulation) } end
  local flat = flatten.fields(output, { "dir", "every", "vtk", "error" })
  picture_of(flat, get(output, "picture"))
  return flat
end

-- The choice of fields is for the engine to know; laws go beside, as it calls them with blocks of the run.
local function fields_of(output)
  local fields = {}
  for i, entry in ipairs(output and given(output, "fields") or {}) do
    check_printable(output, "output.fields", entry.name)
    fields[i] = { name = entry.name, law = entry.value }
  end
  return fields
end

-- "scenes/slope.lua" -> "slope"
local function script_name(file)
  local name = file:match("[^/]*$"):gsub("%.lua$", "")
  return name ~= "" and name or nil
end

local function assemble(simulation)
  local assembly = new_assembly(simulation)
  local scene, links = assembly.scene, links_of(assembly)
  local regions = given(simulation, "regions")
  local place = object.place(simulation)
  local contact = given(simulation, "contact") or object.new("joint", { name = "contact" }, place)
  scene.file, scene.title = place.file, given(simulation, "title") or script_name(place.file)
  scene.gravity, scene.max_blocks = get(simulation, "gravity"), get(simulation, "max_blocks")
  add_regions(assembly, regions, contact)
  scene.contact = joint_index(assembly, contact, softest(regions))
  add_contacts(assembly, given(simulation, "contacts") or {})
  add_boundaries(assembly, links)
  add_viscous(assembly, links)
  if given(simulation, "charges") then add_charges(assembly, given(simulation, "charges"), regions, links) end
  add_probes(assembly, links)
  scene.time = time_of(given(simulation, "time"))
  scene.numerics = numerics_of(given(simulation, "numerics") or profile.presets.default)
  scene.output = output_of(given(simulation, "output"), simulation)
  scene.fields = fields_of(given(simulation, "output"))
  if given(simulation, "fracture") then
    scene.fracture = flatten.fields(given(simulation, "fracture"), { "order", "band", "overshoot", "path" })
  end
  for _, name in ipairs { "on_step", "on_fracture", "on_gas", "on_output", "stop" } do scene[name] = given(simulation, name) end
  return assembly
end

return assemble
