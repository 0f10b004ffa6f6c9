-- What editors should know of a scene, from the schema: `talus --annotations`, kept in lib/meta/talus.lua.
local native = require "talus.native"
local schema = require "talus.schema"
local types = require "talus.types"
local units = require "talus.units"

local header = [[
---@meta talus
-- Annotations for the Lua language server, written by `talus --annotations`; do not edit.
]]

local function one_line(text)
  return (tostring(text):gsub("%s+", " "))
end

-- A type of the schema in the language server's words.
local words = { number = "number", integer = "integer", boolean = "boolean", string = "string", ["function"] = "function", point = "number[]",
  vector = "number[]", triple = "number[]", polyline = "number[][]|table", histories = "table", history = "number|number[][]|fun(t: number): number",
  order = '1|2|"rigid"|fun(x: number, y: number): integer|string', outline = "table", place = "number[]|number[][]|string|table",
  region = "string|talus.region", size = "number|talus.grade|fun(x: number, y: number): number", on = "string|string[]|table" }

local function type_text(spec)
  if spec.type == "list" then return ("(%s)[]|table"):format(type_text(spec.of)) end
  if spec.type == "map" then return ("table<string, %s>"):format(type_text(spec.of)) end
  if spec.type == "object" then
    local kinds = {}
    for i, kind in ipairs(spec.kinds) do kinds[i] = "talus." .. kind end
    return table.concat(kinds, "|") .. (spec.inline and "|table" or "")
  end
  local parts = {}
  if spec.type == "enum" then
    for i, value in ipairs(spec.values) do parts[i] = type(value) == "string" and ("%q"):format(value) or tostring(value) end
  elseif spec.type == "any" then
    for i, of in ipairs(spec.of) do parts[i] = type_text(of) end
  end
  return #parts > 0 and table.concat(parts, "|") or words[spec.type] or "any"
end

local function field_line(field)
  local range = types.range_text(field)
  local notes = {}
  for _, note in ipairs { field.unit or false, range or false, one_line(field.doc) } do
    if note then notes[#notes + 1] = note end
  end
  if field.positional then return ("---@field [integer] any %s"):format(one_line(field.doc)) end
  return ("---@field %s%s %s %s"):format(field.name, field.required and "" or "?", type_text(field), table.concat(notes, "; "))
end

-- Tables of functions that calls stand in: "talus.laws.weibull" needs talus.laws.
local function tables_of(call, seen, lines)
  local name = call:match("^(.*)%.[%w_]+$")
  if not name or seen[name] then return end
  tables_of(name, seen, lines)
  seen[name] = true
  lines[#lines + 1] = name == "talus" and "local talus = {}\n" or name .. " = {}\n"
end

local function kind_lines(kind, seen, lines)
  local entry = schema.kinds[kind]
  lines[#lines + 1] = ("---@class talus.%s"):format(kind)
  for _, field in ipairs(entry.fields) do lines[#lines + 1] = field_line(field) end
  lines[#lines + 1] = ""
  local call = entry.call:match("^talus%.[%w_.]+")
  if not call or seen[call] then return end
  seen[call] = true
  tables_of(call, seen, lines)
  lines[#lines + 1] = "---" .. one_line(entry.doc)
  lines[#lines + 1] = ("---@param fields talus.%s"):format(kind)
  lines[#lines + 1] = "---@return " .. (entry.returns or "talus." .. (kind == "simulation" and "run" or kind))
  lines[#lines + 1] = ("function %s(fields) end\n"):format(call)
end

local methods = { step = "table?", run = "table", steps = "fun(): table?", stop = false, output = false, log = false, save = "userdata", restore = false,
  hash = "string", explain = "string", material = "talus.material", joint = "talus.joint", fix = "talus.fix", load = "table",
  region = "talus.region", plot = false, table = false }

local function run_lines(lines)
  local fields = native.fields()
  for view, name in pairs { blocks = "block", joints = "joint_state", contacts = "contact_state", probes = "probe_state" } do
    fields[view].name = name
  end
  for _, view in ipairs { "blocks", "joints", "contacts", "probes" } do
    lines[#lines + 1] = ("---@class talus.%s"):format(fields[view].name)
    for _, field in ipairs(fields[view]) do
      lines[#lines + 1] = ("---@field %s any %s; %s"):format(field.name, field.unit, one_line(field.meaning))
    end
    lines[#lines + 1] = ""
  end
  lines[#lines + 1] = "---@class talus.run"
  for _, field in ipairs { "time number s", "dt number s, of the last step", "finished boolean", "last table", "energy table<string, number> J/m",
      "totals table", "state table", "blocks table<integer, talus.block>", "joints table<integer, talus.joint_state>",
      "contacts table<integer, talus.contact_state>", "probes table<string, talus.probe_state>", "cracks table", "fragments table", "reactions table",
      "charges table", "highest table?", "strained table?", "collapsed boolean" } do
    lines[#lines + 1] = "---@field " .. field
  end
  lines[#lines + 1] = "local run = {}\n"
  local names = {}
  for name in pairs(methods) do names[#names + 1] = name end
  table.sort(names)
  for _, name in ipairs(names) do
    if methods[name] then lines[#lines + 1] = "---@return " .. methods[name] end
    lines[#lines + 1] = ("function run:%s(...) end\n"):format(name)
  end
end

return function()
  local lines, seen = { header }, {}
  lines[#lines + 1] = "---@class talus"
  tables_of("talus.units", seen, lines)
  for _, kind in ipairs(schema.order) do kind_lines(kind, seen, lines) end
  run_lines(lines)
  lines[#lines + 1] = "---Factors to SI: 35*talus.units.GPa."
  lines[#lines + 1] = "talus.units = {"
  for _, unit in ipairs(units.list) do
    lines[#lines + 1] = ("  %s = %.17g,  -- %s"):format(unit[1], unit[2], unit[3])
  end
  lines[#lines + 1] = "}\n"
  lines[#lines + 1] = "---A parameter of the scene, from the command line with -p name=value.\n---@generic T\n---@param name string\n---@param default T"
    .. "\n---@param meaning? string\n---@return T\nfunction talus.param(name, default, meaning) end\n"
  lines[#lines + 1] = "return talus"
  return table.concat(lines, "\n") .. "\n"
end
