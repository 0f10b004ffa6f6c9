-- Pictures and tables of a script's own numbers, beside those that a run writes itself: sim:plot, sim:table.
local native = require "talus.native"
local object = require "talus.object"
local places = require "talus.places"
local get, given = object.get, object.given

local results = {}

local taken = { energy = true, gas_pressure = true, gas_volume = true, load_displacement = true, history = true,
                history_before = true, run = true, blocks = true, joints = true, cracks = true }

-- The name of a file without its ending, which goes into the simulation's output.dir.
function results.check_name(name, path)
  local where = { place = places.here(), path = path }
  if type(name) ~= "string" or not name:match("^[%w_-]+$") then
    places.expected(where, "a file's name of letters, digits, _ and -, without its ending", name)
  end
  if taken[name] then places.expected(where, "a name that the run does not write itself", name) end
  return name
end

local function check_simulation(sim, path)
  if type(sim) ~= "userdata" then
    places.expected({ place = places.here(), path = path }, "a simulation", sim)
  end
end
results.check_simulation = check_simulation

local function list_of(series)
  local list = {}
  for i, one in ipairs(series) do
    if #given(one, "x") ~= #given(one, "y") then
      places.fail(object.place(one), ("plot[%d]: expected as many x as y, got %d and %d"):format(i, #given(one, "x"),
        #given(one, "y")))
    end
    list[i] = { name = given(one, "name"), x = given(one, "x"), y = given(one, "y"), markers = get(one, "markers"),
                dashed = get(one, "dashed"), line = get(one, "line") }
  end
  return list
end

-- sim:plot("stress_strain", { x_label = …, { name = …, x = {…}, y = {…} }, … }): <dir>/stress_strain.svg
function native.methods.plot(sim, name, fields)
  check_simulation(sim, "sim:plot")
  results.check_name(name, "sim:plot")
  local plot = object.new("plot", fields)
  local flat = { series = list_of(given(plot, "series")) }
  for _, field in ipairs { "title", "x_label", "x_unit", "y_label", "y_unit", "log_x", "log_y", "equal" } do
    flat[field] = get(plot, field)
  end
  native.plot(sim, name, flat)
end

-- sim:table("pile", { { "x [m]", xs }, { "y [m]", ys } }): <dir>/pile.csv
function native.methods.table(sim, name, columns)
  check_simulation(sim, "sim:table")
  results.check_name(name, "sim:table")
  local flat = {}
  for i, column in ipairs(type(columns) == "table" and columns or {}) do
    local where = { place = places.here(), path = ("sim:table[%d]"):format(i) }
    if type(column) ~= "table" or type(column[1]) ~= "string" or type(column[2]) ~= "table" then
      places.expected(where, "{ name, list of numbers }", column)
    end
    for k, value in ipairs(column[2]) do
      if type(value) ~= "number" then places.expected(places.inside(where, ("[2][%d]"):format(k)), "a number", value) end
    end
    if i > 1 and #column[2] ~= #columns[1][2] then
      places.expected(where, ("%d numbers, as in the first column"):format(#columns[1][2]), #column[2])
    end
    flat[i] = { name = column[1], values = column[2] }
  end
  if #flat == 0 then
    places.expected({ place = places.here(), path = "sim:table" }, "a list of { name, list of numbers }", columns)
  end
  native.table(sim, name, { columns = flat })
end

return results
