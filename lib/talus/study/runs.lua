-- From a study's parameters to its list of runs: each { name = folder's name, values = { name -> value } }.
local native = require "talus.native"
local object = require "talus.object"
local places = require "talus.places"
local ranges = require "talus.study.ranges"
local settings = require "talus.study.settings"
local types = require "talus.types"
local get, given = object.get, object.given

local most = 100000  -- runs

-- Names of all parameters, sorted; a name in two places is refused.
local function names_of(study)
  local found, names = {}, {}
  local function add(name, where)
    if not name:match("^[%a_][%w_]*$") then
      places.expected({ place = object.place(study), path = "study." .. where }, "names of parameters, of letters, digits and _", name)
    end
    if found[name] and found[name] ~= where then
      places.fail(object.place(study), ("study.%s: expected each parameter in one place, got %s in %s too"):format(where, name, found[name]))
    end
    if not found[name] then names[#names + 1] = name end
    found[name] = where
  end
  for _, entry in ipairs(given(study, "parameters") or {}) do add(entry.name, "parameters") end
  for _, case in ipairs(given(study, "cases") or {}) do
    for _, entry in ipairs(case) do add(entry.name, "cases") end
  end
  local sample = given(study, "sample")
  for _, entry in ipairs(sample and given(sample, "ranges") or {}) do add(entry.name, "sample") end
  if given(study, "seeds") then add(get(study, "seed_parameter"), "seeds") end
  table.sort(names)
  return names
end

-- The names as study.order has them; those that it does not name follow.
local function ordered(study, names)
  local known, list = {}, {}
  for _, name in ipairs(names) do known[name] = true end
  for _, name in ipairs(given(study, "order") or {}) do
    if not known[name] then
      places.fail(object.place(study), ("study.order: expected names of parameters, each once, got %q%s"):format(name,
        types.is_one_of(name, list) and " again" or native.suggestion(name, names)))
    end
    known[name] = nil
    list[#list + 1] = name
  end
  for _, name in ipairs(names) do
    if known[name] then list[#list + 1] = name end
  end
  return list
end

-- Sets of values of which every combination is a run: a list of { first = its first name, points }.
local function factors(study, order)
  local place_in_order, list = {}, {}
  for i, name in ipairs(order) do place_in_order[name] = i end
  local function add(points)
    local first = #order + 1
    for name in pairs(points[1] or {}) do first = math.min(first, place_in_order[name]) end
    list[#list + 1] = { first = first, points = points }
  end
  for _, entry in ipairs(given(study, "parameters") or {}) do
    local points = {}
    for i, value in ipairs(entry.value) do points[i] = { [entry.name] = value } end
    add(points)
  end
  if given(study, "cases") then
    local points = {}
    for i, case in ipairs(given(study, "cases")) do
      points[i] = {}
      for _, entry in ipairs(case) do points[i][entry.name] = entry.value end
    end
    add(points)
  end
  if given(study, "sample") then add(ranges.points(given(study, "sample"))) end
  local seeds = given(study, "seeds")
  if seeds then
    local points = {}
    for i = 1, math.type(seeds) and seeds or #seeds do
      points[i] = { [get(study, "seed_parameter")] = math.type(seeds) and i or seeds[i] }
    end
    add(points)
  end
  table.sort(list, function(a, b) return a.first < b.first end)
  return list
end

local function check_count(study, list)
  local count = 1
  for _, factor in ipairs(list) do
    count = count*#factor.points
    if count > most then places.fail(object.place(study), ("study: expected at most %d runs, got more"):format(most)) end
  end
end

-- Every combination, the last factor fastest.
local function combinations(list)
  local all = { {} }
  for _, factor in ipairs(list) do
    local longer = {}
    for _, values in ipairs(all) do
      for _, point in ipairs(factor.points) do
        local joined = {}
        for name, value in pairs(values) do joined[name] = value end
        for name, value in pairs(point) do joined[name] = value end
        longer[#longer + 1] = joined
      end
    end
    all = longer
  end
  return all
end

-- FNV-1a, 32 bits: for names only.
local function digest(text)
  local hash = 0x811c9dc5
  for i = 1, #text do hash = ((hash ~ text:byte(i))*0x01000193) & 0xffffffff end
  return ("%08x"):format(hash)
end

-- "friction=20_size=0.1". What a file's name cannot have, or a name too long, is told apart by a digest.
local function folder_name(values, names)
  local parts, exact = {}, {}
  for _, name in ipairs(names) do
    if values[name] ~= nil then
      local text = settings.text(values[name])
      exact[#exact + 1] = name .. "=" .. text
      parts[#parts + 1] = name .. "=" .. text:gsub("[^%w.+-]", "-")
    end
  end
  local name, whole = table.concat(parts, "_"), table.concat(exact, "_")
  if #parts == 0 then return "run" end
  if name == whole and #name <= 120 then return name end
  return name:sub(1, 110) .. "_" .. digest(whole)
end

local function copy(values)
  local result = {}
  for name, value in pairs(values) do result[name] = value end
  return result
end

local function wanted(study, values)
  local where = given(study, "where")
  if not where then return true end
  local worked, answer = pcall(where, copy(values))
  if not worked then places.fail(object.place(study), "study.where: expected a function that works, got " .. tostring(answer)) end
  if type(answer) ~= "boolean" then
    places.expected({ place = object.place(study), path = "study.where" }, "true or false from it", answer)
  end
  return answer
end

-- The runs, and the names of the parameters in the order of the study.
return function(study)
  local names = names_of(study)
  local order = ordered(study, names)
  local list = factors(study, order)
  check_count(study, list)
  local runs, met = {}, {}
  for _, values in ipairs(combinations(list)) do
    if wanted(study, values) then
      local name = folder_name(values, names)
      if met[name] then places.fail(object.place(study), ("study: expected runs that differ, got %s twice"):format(name)) end
      met[name] = true
      runs[#runs + 1] = { name = name, values = values }
    end
  end
  if #runs == 0 then places.fail(object.place(study), "study.where: expected a run for which it is true, got none") end
  return runs, order
end
