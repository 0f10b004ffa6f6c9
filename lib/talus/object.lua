-- What constructors return: a value with a closed set of checked fields that remembers its line in the script.
-- Fields can be read, and set until a simulation uses the object; those marked `live` in the schema also
-- afterwards: the change takes effect with the next step of every simulation that uses it.
local native = require "talus.native"
local places = require "talus.places"
local types = require "talus.types"
local schema = require("talus.schema").kinds
local rules = require "talus.rules"

local object = {}

-- object -> { kind, values, place, path, bindings }; a binding: simulation -> function that passes the change on.
local records = setmetatable({}, { __mode = "k" })
local metatables = {}

-- As the script writes it; what is only written as a table keeps the word.
local function name_of(kind)
  local call = schema[kind].call
  return call ~= "" and call or "talus." .. kind
end

local function unknown_key(place, path, kind, key)
  local names = {}
  for _, field in ipairs(schema[kind].fields) do
    if not field.positional then names[#names + 1] = field.name end
  end
  local suggestion = native.suggestion(tostring(key), names)
  places.fail(place, ("%s.%s: there is no such field%s"):format(path,
    type(key) == "string" and key or native.describe(key), suggestion))
end

local function check_keys(kind, given, place, path)
  local unknown = {}
  local positional = schema[kind].positional
  for key in pairs(given) do
    local field = schema[kind].by_name[key]
    if not (field and not field.positional) and not (positional and math.type(key) == "integer") then
      unknown[#unknown + 1] = key
    end
  end
  table.sort(unknown, function(a, b) return tostring(a) < tostring(b) end)
  if math.type(unknown[1]) == "integer" then
    places.fail(place, ("%s: expected named fields, got %s without a name"):format(path,
      native.describe(given[unknown[1]])))
  elseif unknown[1] ~= nil then
    unknown_key(place, path, kind, unknown[1])
  end
end

local function positional_part(given)
  local list = {}
  for i = 1, #given do list[i] = given[i] end
  return #list > 0 and list or nil
end

local function check_fields(kind, given, place, path)
  local values = {}
  for _, field in ipairs(schema[kind].fields) do
    local where = { place = place, path = path .. "." .. field.name }
    local value = given[field.name]
    if field.positional then value = positional_part(given) end
    if value ~= nil then
      values[field.name] = types.check(value, field, where)
    elseif field.required then
      places.expected(where, types.expected(field), nil)
    end
  end
  return values
end

local function check_rules(kind, values, place, path)
  if not rules[kind] then return end
  rules[kind](values, function(field, expected, given)
    places.fail(place, ("%s%s: expected %s, got %s"):format(path, field and "." .. field or "", expected, given))
  end)
end

-- Wraps values that need no check.
function object.wrap(kind, values, place, path)
  local self = setmetatable({}, metatables[kind])
  records[self] = { kind = kind, values = values, place = place, path = path or kind,
                    bindings = setmetatable({}, { __mode = "k" }) }
  return self
end

-- Checks `given` by the schema of `kind`. `place` and `path` are those of the enclosing constructor for a plain
-- table inside of another.
function object.new(kind, given, place, path)
  place, path = place or places.here(), path or kind
  if given == package.loaded.talus then
    places.fail(place, ("%s: expected a dot, %s { … }, got a colon"):format(path, name_of(kind)))
  end
  if type(given) ~= "table" or getmetatable(given) ~= nil then
    places.expected({ place = place, path = path }, "a table of fields", given)
  end
  check_keys(kind, given, place, path)
  local values = check_fields(kind, given, place, path)
  check_rules(kind, values, place, path)
  return object.wrap(kind, values, place, path)
end

function object.kind(self)
  return records[self] and records[self].kind
end

function object.place(self)
  return records[self].place
end

-- A field as given, or nil.
function object.given(self, name)
  return records[self].values[name]
end

-- A field as given, or its default.
function object.get(self, name)
  local record = records[self]
  local value = record.values[name]
  if value == nil then value = schema[record.kind].by_name[name].default end
  return value
end

-- `refresh` is called after each change of a live field, as long as `simulation` lives.
function object.bind(self, simulation, refresh)
  local bindings = records[self].bindings
  bindings[simulation] = bindings[simulation] or {}
  table.insert(bindings[simulation], refresh)
end

local function copy(value)
  if type(value) ~= "table" or getmetatable(value) ~= nil then return value end
  local result = {}
  for key, element in pairs(value) do result[key] = copy(element) end
  return result
end

local function index(self, name)
  local record = records[self]
  if not schema[record.kind].by_name[name] then unknown_key(places.here(), record.path, record.kind, name) end
  return copy(object.get(self, name))
end

local function pass_on(record)
  for _, refreshers in pairs(record.bindings) do
    for _, refresh in ipairs(refreshers) do refresh() end
  end
end

-- Not of functions, which may answer otherwise than before.
local function same(a, b)
  if type(a) ~= "table" or type(b) ~= "table" then return a == b and type(a) ~= "function" end
  if object.kind(a) ~= object.kind(b) then return false end
  if records[a] then a, b = records[a].values, records[b].values end
  for key in pairs(b) do
    if a[key] == nil then return false end
  end
  for key, value in pairs(a) do
    if not same(value, b[key]) then return false end
  end
  return true
end

local function new_index(self, name, value)
  local record, place = records[self], places.here()
  local field = schema[record.kind].by_name[name]
  if not field then unknown_key(place, record.path, record.kind, name) end
  local where = { place = place, path = record.path .. "." .. name }
  if next(record.bindings) and not field.live then
    places.fail(place, where.path .. " cannot change any more: a simulation uses it")
  end
  local values = {}
  for key, old in pairs(record.values) do values[key] = old end
  values[name] = types.check(value, field, where)
  check_rules(record.kind, values, place, record.path)
  local before = record.values
  record.values = values
  if same(before[name], values[name]) then return end
  local passed, problem = pcall(pass_on, record)
  if not passed then
    record.values = before
    error(problem, 0)
  end
end

-- A value as plain data. Functions go into the list `laws`.
local function freeze(value, laws)
  if type(value) == "function" then
    laws[#laws + 1] = value
    return { law = #laws }
  end
  if type(value) ~= "table" then return value end
  local kind, fields = object.kind(value), {}
  for key, element in pairs(kind and records[value].values or value) do fields[key] = freeze(element, laws) end
  return { kind = kind, fields = fields }
end

-- What was frozen. Functions come from `laws`, or where there is no such list (a file) from `present`, the value now.
local function thaw(frozen, laws, present, where)
  if type(frozen) ~= "table" then return frozen end
  if frozen.law then
    local law = laws and laws[frozen.law] or present
    if type(law) == "function" then return law end
    places.expected(where, "a function, as when the state was saved", present)
  end
  local fields = {}
  local now = records[present] and records[present].values or type(present) == "table" and present or {}
  for key, element in pairs(frozen.fields) do fields[key] = thaw(element, laws, now[key], where) end
  return frozen.kind and object.wrap(frozen.kind, fields, where.place) or fields
end

-- The live fields of an object as plain data, for a saved state.
function object.freeze(self, laws)
  local fields = {}
  for name, value in pairs(records[self].values) do
    if schema[records[self].kind].by_name[name].live then fields[name] = freeze(value, laws) end
  end
  return fields
end

-- All values of the object with the live ones as frozen; `place` is the line that asks for it.
function object.thaw(self, frozen, laws, place)
  local record, values = records[self], {}
  for name, value in pairs(record.values) do
    if not schema[record.kind].by_name[name].live then values[name] = value end
  end
  for name, value in pairs(frozen) do
    values[name] = thaw(value, laws, record.values[name], { place = place, path = record.path .. "." .. name })
  end
  return values
end

-- Takes values that thaw has made; every simulation that uses the object follows.
function object.put(self, values)
  local before = records[self].values
  records[self].values = values
  if not same(before, values) then pass_on(records[self]) end
end

for kind in pairs(schema) do
  metatables[kind] = { __index = index, __newindex = new_index, __name = name_of(kind), __metatable = kind }
end

-- An object of one of spec.kinds; where spec.inline is set a plain table will do for the first of them.
types.object = {}

function types.object.expected(spec)
  local words = {}
  for i, kind in ipairs(spec.kinds) do words[i] = name_of(kind) end
  local text = table.concat(words, ", ", 1, #words - 1) .. (#words > 1 and " or " or "") .. words[#words]
  return spec.inline and ("a table of %s fields"):format(spec.kinds[1]) or "a " .. text
end

function types.object.accepts(value, spec)
  for _, kind in ipairs(spec.kinds) do
    if object.kind(value) == kind then return true end
  end
  return spec.inline and type(value) == "table" and getmetatable(value) == nil and #value == 0
end

function types.object.check(value, spec, where)
  if not types.object.accepts(value, spec) then places.expected(where, types.object.expected(spec), value) end
  if object.kind(value) then return value end
  return object.new(spec.kinds[1], value, where.place, where.path)
end

return object
