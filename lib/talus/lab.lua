-- Laboratory tests of bonded rock, each one call: compression between smooth plates, with or without pressure at the sides, and the
-- splitting of a flattened disc. talus.calibrate is made of them.
local object = require "talus.object"
local places = require "talus.places"
local results = require "talus.results"
local simulation = require "talus.simulation"
local get, given = object.get, object.given

local lab = {}

local function smooth() return object.new("joint", { name = "smooth", friction = 0 }) end

local function plate(name, outline, material, more)
  local fields = { name = name, outline = outline, material = material }
  for key, value in pairs(more) do fields[key] = value end
  return object.new("region", fields)
end

local function box(x1, y1, x2, y2) return { {x1, y1}, {x2, y1}, {x2, y2}, {x1, y2} } end

-- The rock between a held plate below and one above that comes down by `way` (m) from the time `from` to 1. Ends where the load has
-- fallen to `keep` of its highest. Calls `record(load, down)` (N/m, m) after each step.
local function press(options, body, plates, way, from, keep, loads, record)
  local material, most = given(options, "material"), 0
  local function load(sim) return -sim.reactions.press[2] end
  local sim = simulation {
    title = given(options, "title"),
    regions = { body, plate("upper plate", plates.upper, material, { order = "rigid" }),
                plate("lower plate", plates.lower, material, { held = true }) },
    contact = smooth(), loads = loads,
    fix = { object.new("fix", { name = "press", region = "upper plate",
                                displacement = { 0, { {0, 0}, {from, 0}, {1, -way} } } }) },
    time = { mode = "static", steps = get(options, "steps") },
    output = given(options, "output"),
    on_step = function(sim)
      most = math.max(most, load(sim))
      record(load(sim), math.max(0, sim.time - from)/(1 - from)*way)
    end,
    stop = function(sim) return sim.time > from and load(sim) < keep*most end,
  }
  sim:run()
  return sim
end

-- Strength of a joint's Mohr–Coulomb line in compression under the pressure p (Pa): 2 c tan(45° + φ/2) + p tan²(45° + φ/2).
local function line_strength(joint, p)
  local t = math.tan(math.pi/4 + get(joint, "friction")/2)
  return 2*(given(joint, "cohesion") or 0)*t + p*t^2
end

-- The slope through the points below half of the strength, of what is above the start.
local function modulus(curve, strength, start)
  local xy, xx = 0, 0
  for i, strain in ipairs(curve.strain) do
    local rise = curve.stress[i] - start
    if strain > 0 and rise < (strength - start)/2 then xy, xx = xy + strain*rise, xx + strain^2 end
  end
  return xx > 0 and xy/xx or nil
end

function lab.compression(fields)
  local options = object.new("compression", fields)
  local material, joint, size = given(options, "material"), given(options, "joint"), given(options, "size")
  local width = get(options, "width") or 10*size
  local height, pressure = given(options, "height") or 2*width, get(options, "pressure")
  local way = get(options, "strain") or 1.5*math.max(line_strength(joint, pressure), 1e-6*given(material, "young"))/given(material, "young")
  local steps = get(options, "steps")
  local from = pressure > 0 and math.ceil(0.1*steps)/steps or 0  -- at the end of a load step
  local body = object.new("region", { name = "specimen", outline = box(-width/2, 0, width/2, height), material = material, joint = joint,
                                      mesh = { size = size } })
  local curve = { strain = {0}, stress = {0}, strength = 0, width = width, height = height }
  local start, loads = 0, nil
  if pressure > 0 then
    loads = { object.new("pressure", { region = "specimen", on = {"left", "right"}, value = { {0, 0}, {from, pressure} } }) }
  end
  curve.sim = press(options, body, { upper = box(-0.7*width, height, 0.7*width, height + 0.1*width),
                                     lower = box(-0.7*width, -0.1*width, 0.7*width, 0) },
                    way*height, from, get(options, "keep"), loads, function(load, down)
    local stress = load/width
    if down <= 1e-9*way*height then start = stress end
    curve.stress[#curve.stress + 1], curve.strain[#curve.strain + 1] = stress, down/height
    curve.strength = math.max(curve.strength, stress)
  end)
  curve.young = modulus(curve, curve.strength, start)
  curve.broke, curve.collapsed = curve.sim.totals.failures > 0, curve.sim.collapsed
  if given(options, "file") then
    results.check_name(given(options, "file"), "compression.file")
    curve.sim:table(given(options, "file"), { { "strain", curve.strain }, { "stress [Pa]", curve.stress } })
    curve.sim:plot(given(options, "file"), { title = given(options, "title") or "Axial stress against strain", x_label = "ε", y_label = "σ",
                                             y_unit = "Pa", { x = curve.strain, y = curve.stress, markers = true } })
  end
  return curve
end

-- At the centre of a disc under pressure on arcs of half-angle a the tension is 2P/(πD)·(sin 2a / a - 1) (Hondros 1959).
local half_angle = 3.6*math.pi/180
local arc_factor = math.sin(2*half_angle)/half_angle - 1

local function disc_outline(radius, size)
  local points = {}
  local chords = math.max(6, math.ceil(radius*(math.pi - 2*half_angle)/size))
  for side = 0, 1 do
    for i = 0, chords do
      local a = side*math.pi + half_angle + (math.pi - 2*half_angle)*i/chords
      points[#points + 1] = { radius*math.sin(a), radius*math.cos(a) }
    end
  end
  return points
end

function lab.brazilian(fields)
  local options = object.new("brazilian", fields)
  local material, joint, size = given(options, "material"), given(options, "joint"), given(options, "size")
  local diameter = get(options, "diameter") or 20*size
  local radius = diameter/2
  local h, b = radius*math.cos(half_angle), radius*math.sin(half_angle)
  local expected = (given(joint, "tension") or line_strength(joint, 0))*math.pi*diameter/2
  if expected == 0 then
    places.fail(object.place(options), "brazilian.joint: expected tension or cohesion, from which the plate's way follows, got neither")
  end
  local body = object.new("region", { name = "disc", outline = disc_outline(radius, size), material = material, joint = joint,
                                      mesh = { size = size } })
  local found = { load = 0, last = 0, diameter = diameter }
  found.sim = press(options, body, { upper = box(-2*b, h, 2*b, h + 2*b), lower = box(-2*b, -h - 2*b, 2*b, -h) },
                    12*expected/given(material, "young"), 0, get(options, "keep"), nil, function(load)
    found.load, found.last = math.max(found.load, load), load
  end)
  found.strength = 2*found.load/(math.pi*diameter)*arc_factor
  found.broke = found.sim.totals.failures > 0
  found.fell = found.last < get(options, "keep")*found.load
  if found.broke and not found.fell then
    found.sim:log("brazilian: the load has not fallen from its peak to `keep` of it when the plate's way ends: the strength may be that of the halves")
  end
  return found
end

return lab
