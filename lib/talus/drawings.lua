-- Traces and outlines from files of surveys and drawing programs.
local native = require "talus.native"
local object = require "talus.object"
local places = require "talus.places"

local drawings = {}

-- The options of a call, checked as fields of `kind`.
local function options_of(kind, file, given)
  local fields = { file = file }
  if given ~= nil and (type(given) ~= "table" or getmetatable(given) ~= nil) then
    places.expected({ place = places.here(), path = kind .. ": options" }, "a table of fields", given)
  end
  for key, value in pairs(given or {}) do fields[key] = value end
  return object.new(kind, fields)
end

-- The file's lines on the wanted layers, in metres; what was done goes into the notes of the next simulation.
local function read(kind, options, layers, noun)
  local file = object.given(options, "file")
  local chord = kind ~= "traces_from_csv" and object.get(options, "chord") or 0
  local drawing = native.read_drawing(kind, file, chord)
  local scale = object.given(options, "scale") or drawing.unit
  local wanted, kept, named = {}, {}, {}
  for _, layer in ipairs(layers or {}) do wanted[layer:lower()] = layer end
  local present, names = {}, {}
  for _, line in ipairs(drawing.lines) do
    local layer = line.layer:lower()
    if not present[layer] then names[#names + 1] = line.layer end
    present[layer] = true
    if not layers or wanted[layer] then kept[#kept + 1] = line end
    for _, point in ipairs(line.points) do point[1], point[2] = scale*point[1], scale*point[2] end
  end
  for _, layer in ipairs(layers or {}) do named[#named + 1] = layer end
  for _, entry in ipairs(kind == "traces_from_dxf" and object.given(options, "joints_by_layer") or {}) do named[#named + 1] = entry.name end
  for _, layer in ipairs(named) do
    if not present[layer:lower()] then
      places.fail(object.place(options), ("%s: %s: expected lines on layer %q, got none%s"):format(kind, file, layer,
        native.suggestion(layer, names)))
    end
  end
  if #kept == 0 then
    places.fail(object.place(options), ("%s: %s: expected lines, got none%s"):format(kind, file,
      drawing.skipped and " but " .. drawing.skipped or ""))
  end
  local unit = object.given(options, "scale") and ("lengths times %g, as `scale` says"):format(scale)
    or drawing.unit_name ~= "" and ("lengths in %s, times %g"):format(drawing.unit_name, scale)
    or "lengths taken for metres"
  native.note(("%s: %d of %d %s read, %s%s"):format(file, #kept, #drawing.lines, noun, unit,
    drawing.skipped and "; not read: " .. drawing.skipped or ""))
  return kept
end

local function trace_of(line, options, joint)
  local points = line.points
  if line.closed then points[#points + 1] = { points[1][1], points[1][2] } end
  local name = line.layer ~= "" and line.layer or nil
  return object.wrap("trace", { points = points, joint = joint, bonded = object.given(options, "bonded"), name = name,
    drawn = true }, object.place(options))
end

function drawings.traces_from_csv(file, given)
  local options = options_of("traces_from_csv", file, given)
  local traces = {}
  for i, line in ipairs(read("traces_from_csv", options, nil, "traces")) do
    traces[i] = trace_of(line, options, object.given(options, "joint"))
  end
  return traces
end

function drawings.traces_from_dxf(file, given)
  local options = options_of("traces_from_dxf", file, given)
  local joints, layers = {}, object.given(options, "layers")
  for _, entry in ipairs(object.given(options, "joints_by_layer") or {}) do joints[entry.name:lower()] = entry.value end
  local traces = {}
  for i, line in ipairs(read("traces_from_dxf", options, layers, "traces")) do
    traces[i] = trace_of(line, options, joints[line.layer:lower()] or object.given(options, "joint"))
  end
  return traces
end

function drawings.outlines_from_dxf(file, given)
  local options = options_of("outlines_from_dxf", file, given)
  local layer = object.given(options, "layer")
  local outlines = {}
  for i, line in ipairs(read("outlines_from_dxf", options, layer and { layer }, "lines")) do
    if not line.closed then
      places.fail(object.place(options), ("outlines_from_dxf: %s:%d: expected a closed line, got one that is open"):format(
        file, line.line))
    end
    outlines[i] = object.wrap("outline", { points = line.points, name = line.layer }, object.place(options))
  end
  return outlines
end

function drawings.outline_from_dxf(file, given)
  local outlines = drawings.outlines_from_dxf(file, given)
  if #outlines ~= 1 then
    places.fail(places.here(), ("outline_from_dxf: %s: expected one closed line, got %d: choose a layer"):format(file,
      #outlines))
  end
  return outlines[1]
end

return drawings
