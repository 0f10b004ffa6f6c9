-- Charges: constants of explosives, trials of laws, and the flat form for the engine.
local native = require "talus.native"
local object = require "talus.object"
local places = require "talus.places"
local trial = require "talus.trial"
local finite = trial.finite
local get, given = object.get, object.given

local gas = {}

-- Dobratz & Crawford, LLNL Explosives Handbook (1985); emulsion: Hansson, SveBeFo (2009), rounded. Units: kg/m3, Pa, J/m3.
gas.explosives = {
  TNT = { density = 1630, A = 371.2e9, B = 3.231e9, R1 = 4.15, R2 = 0.95, omega = 0.30, E = 7.0e9 },
  ANFO = { density = 931, A = 49.46e9, B = 1.891e9, R1 = 3.907, R2 = 1.118, omega = 0.333, E = 2.484e9 },
  emulsion = { density = 1245, A = 214.4e9, B = 0.182e9, R1 = 4.2, R2 = 0.9, omega = 0.15, E = 4.19e9 },
}

local function try(law, argument, given_text, bad, field, check)
  local answer, again = trial.twice(law, field, given_text, bad, argument)
  local problem = check(answer)
  if problem then bad(field, problem .. " " .. given_text, native.describe(answer)) end
  if again ~= answer then bad(field, "the same answer to the same question " .. given_text, "another the second time") end
  return answer
end

function gas.check(values, bad)
  if type(values.eos) == "function" then
    local last = math.huge
    for _, v in ipairs { 1, 1.5, 2, 5, 20, 100 } do
      local text = ("at v = %g"):format(v)
      local pressure = try(values.eos, v, text, bad, "eos", function(p)
        return not (finite(p) and p > 0) and "a pressure > 0 (Pa)" or nil
      end)
      if pressure > last*(1 + 1e-9) then
        bad("eos", ("a pressure that falls as the gas expands: at most %.6g (Pa) %s"):format(last, text),
          ("%.6g"):format(pressure))
      end
      last = pressure
    end
  end
  if type(values.gas_speed) == "function" then
    for _, t in ipairs { 0, 1e-3, 1 } do
      try(values.gas_speed, t, ("at t = %g"):format(t), bad, "gas_speed", function(speed)
        return not (finite(speed) and speed >= 0) and "a speed >= 0 (m/s)" or nil
      end)
    end
  end
  if values.venting then
    for _, t in ipairs { 0, 1e-3, 1 } do
      try(values.venting, t, ("at t = %g"):format(t), bad, "venting", function(part)
        return not (finite(part) and part >= 0 and part <= 1) and "a part from 0 to 1" or nil
      end)
    end
  end
end

function gas.check_jwl(values, bad)
  for _, name in ipairs { "A", "B", "R1", "R2", "omega", "E" } do
    if values.explosive and values[name] then bad(name, "an explosive or its constants", "both") end
    if not values.explosive and not values[name] then bad(name, "a number > 0, as no explosive is named", "nothing") end
  end
  if values.explosive then return end
  -- C of the isentrope, which is what is left of the pressure in the end.
  local least = values.A/values.R1*math.exp(-values.R1) + values.B/values.R2*math.exp(-values.R2)
  if values.E <= least then
    bad("E", ("more than A/R1 e^-R1 + B/R2 e^-R2 = %.6g (J/m3), or the pressure becomes negative"):format(least), ("%g"):format(values.E))
  end
end

local function flatten_law(law)
  if type(law) == "function" then return nil end
  if object.kind(law) == "polytropic" then
    return { kind = "polytropic", pressure = get(law, "pressure"), gamma = get(law, "gamma") }
  end
  local flat = { kind = "jwl", filled = get(law, "filled") }
  local known = gas.explosives[given(law, "explosive")]
  for _, name in ipairs { "A", "B", "R1", "R2", "omega", "E" } do
    flat[name] = known and known[name] or given(law, name)
  end
  return flat
end

-- Region and hole by number.
local function find_hole(charge, regions, links)
  local wanted, region = given(charge, "hole"), given(charge, "region")
  local asked = region and links.region(region, charge)
  local names, found = {}, nil
  for r, candidate in ipairs(regions) do
    for h, hole in ipairs(given(candidate, "holes") or {}) do
      local name = given(hole, "name") or ("hole %d"):format(h)
      names[#names + 1] = name
      if name == wanted and (not asked or candidate == asked) then
        if found then
          places.fail(object.place(charge), ("charge.region: expected the region of hole %q, of which there are two, got"
            .. " nothing"):format(wanted))
        end
        found = { region = r, hole = h }
      end
    end
  end
  if not found then
    places.fail(object.place(charge), ("charge.hole: there is no hole %q%s; name it with talus.circle { …, name = %q }")
      :format(wanted, native.suggestion(wanted, names), wanted))
  end
  return found
end

function gas.flatten(charges, regions, links)
  local list, taken = {}, {}
  for i, charge in ipairs(charges) do
    local at = find_hole(charge, regions, links)
    local key = at.region .. "/" .. at.hole
    if taken[key] then
      places.fail(object.place(charge), ("charge.hole: expected a hole of its own, got %q, which has a charge already"):format(
        given(charge, "hole")))
    end
    taken[key] = true
    local eos, speed = given(charge, "eos"), get(charge, "gas_speed")
    list[i] = { place = object.place(charge), name = given(charge, "name") or ("charge %d"):format(i),
                region = at.region, hole = at.hole, delay = get(charge, "delay"),
                eos = type(eos) == "function" and eos or nil, law = flatten_law(eos),
                speed = type(speed) == "number" and speed or nil, speed_law = type(speed) == "function" and speed or nil,
                venting = given(charge, "venting") }
  end
  return list
end

return gas
