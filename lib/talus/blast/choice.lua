-- Which regions and blocks a measure is about.
local object = require "talus.object"
local places = require "talus.places"
local results = require "talus.results"
local given = object.given

local choice = {}

-- The checked options of a measure of `sim`.
function choice.options(kind, sim, fields)
  results.check_simulation(sim, "talus.blast." .. kind)
  local options = object.new(kind, fields or {})
  if given(options, "file") then results.check_name(given(options, "file"), kind .. ".file") end
  return options
end

local function name_in(sim, region)
  if type(region) == "string" then
    sim:region(region)  -- answers a name that there is not
    return region
  end
  local number = 1
  while true do
    local other = sim:region(number)
    if other == region then return given(region, "name") or ("region %d"):format(number) end
    number = number + 1
  end
end

-- { name = true } of the chosen regions.
function choice.regions(sim, options)
  local names, wanted = {}, given(options, "regions")
  if wanted then
    for _, region in ipairs(wanted) do names[name_in(sim, region)] = true end
    return names
  end
  local of, fixed = sim.blocks:field "region", sim.blocks:field "fixed"
  for b = 1, #of do if fixed[b] == 0 then names[of[b]] = true end end
  return names
end

-- The outlines (lists of points) of the chosen regions as they were at the start.
function choice.outlines(sim, names)
  local lists = {}
  for name in pairs(names) do
    local region = sim:region(name)
    if given(region, "outline") then
      lists[#lists + 1] = given(given(region, "outline"), "points")
    else
      for _, block in ipairs(given(region, "blocks")) do lists[#lists + 1] = given(block, "points") end
    end
  end
  return lists
end

-- Whether the script's function `where` answers true.
function choice.holds(options, item)
  local where = given(options, "where")
  local answer = where(item)
  if type(answer) ~= "boolean" then
    places.expected({ place = object.place(options), path = object.kind(options) .. ".where" }, "a function that returns true or false",
      answer)
  end
  return answer
end

return choice
