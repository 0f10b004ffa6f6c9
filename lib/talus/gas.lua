-- Charges: trials of laws, the chamber that laws see, and the flat form for the engine.
local native = require "talus.native"
local object = require "talus.object"
local explosives = require "talus.explosives"
local places = require "talus.places"
local trial = require "talus.trial"
local finite = trial.finite
local get, given = object.get, object.given

local gas = {}

-- The chamber as laws see it, to be read only, and the function that sets its numbers before a call.
local function view_of(name)
  local numbers = { name = name }
  local view = setmetatable({}, {
    __name = "chamber", __metatable = false,
    __index = function(_, key)
      if numbers[key] ~= nil then return numbers[key] end
      local known = { "name", "volume", "first_volume", "pressure", "front" }
      error(("chamber.%s: there is no such thing%s"):format(key, native.suggestion(tostring(key), known)), 2)
    end,
    __newindex = function() error("a chamber can only be read", 2) end,
  })
  local function set(volume, first_volume, pressure, front)
    numbers.volume, numbers.first_volume, numbers.pressure, numbers.front = volume, first_volume, pressure, front
  end
  return view, set
end

-- Laws as the engine calls them: with the numbers of the chamber, from which the script's gets the table.
local function eos_with_chamber(law, name)
  local view, set = view_of(name)
  return function(v, t, ...)
    set(...)
    return law(v, t, view)
  end
end

local function law_with_chamber(law, name)
  local view, set = view_of(name)
  return function(t, ...)
    set(...)
    return law(t, view)
  end
end

local function try(law, given_text, field, bad, check, ...)
  local answer, again = trial.twice(law, field, given_text, bad, ...)
  local problem = check(answer)
  if problem then bad(field, problem .. " " .. given_text, native.describe(answer)) end
  if again ~= answer then bad(field, "the same answer to the same question " .. given_text, "another the second time") end
  return answer
end

-- A chamber of 1 m3 at first, under 1 MPa, for the trials.
local function tried(name, volume)
  local view, set = view_of(name)
  set(volume, 1, 1e6, 0)
  return view
end

-- From 1 to 10 000, ten to each doubling. Far out a pressure may be too small for a number.
local trials, far = {}, 100
for k = 0, 133 do trials[k + 1] = 2^(k/10) end

local function try_eos(law, name, bad)
  for _, t in ipairs { 0, 1e-3 } do
    local last, before = math.huge, nil
    for _, v in ipairs(trials) do
      local text = ("at v = %g"):format(v) .. (t > 0 and (", t = %g"):format(t) or "")
      local pressure = try(law, text, "eos", bad, function(p)
        return not (finite(p) and (p > 0 or p == 0 and v > far)) and "a pressure > 0 (Pa)" or nil
      end, v, t, tried(name, v))
      if pressure > last*(1 + 1e-9) then
        bad("eos", ("a pressure that falls as the gas expands: %s at most that at v = %g, %.6g (Pa)"):format(text, before, last),
          ("%.6g"):format(pressure))
      end
      last, before = pressure, v
    end
  end
end

local function try_in_time(law, name, field, bad, check)
  for _, t in ipairs { 0, 1e-3, 1 } do try(law, ("at t = %g"):format(t), field, bad, check, t, tried(name, 1)) end
end

-- What the gas weighs, and the γ it leaves with, if the orifice does not say.
local function check_orifice(values, bad)
  local orifice, eos = values.venting, values.eos
  if not given(orifice, "density") and not values.explosive then
    bad("venting", "an orifice with a density (kg/m3) of the gas, as the charge is not given by an explosive", "one without")
  end
  if not given(orifice, "gamma") and object.kind(eos) == "polytropic" and get(eos, "gamma") <= 1 then
    bad("venting", "an orifice with gamma > 1, as that of the gas is not", ("%g"):format(get(eos, "gamma")))
  end
end

local function without_opening(venting) return object.kind(venting) == "orifice" and not given(venting, "opening") end

-- Through what the collar lets gas out that an orifice is to pass.
local function check_stemming(values, bad)
  if not without_opening(values.venting) or given(values.stemming, "charge_length") then return end
  bad("stemming", "one with a charge_length (m), as the orifice has no opening of its own", "one without")
end

-- The same where it is the orifice of another charge, whose gas it may meet.
local function check_collars(charges)
  local through
  for i, charge in ipairs(charges) do
    if without_opening(given(charge, "venting")) then through = through or given(charge, "name") or ("charge %d"):format(i) end
  end
  for _, charge in ipairs(through and charges or {}) do
    local stemming = given(charge, "stemming")
    if stemming and not given(stemming, "charge_length") then
      places.fail(object.place(charge), ("charge.stemming: expected one with a charge_length (m), as the orifice of charge %q has no opening of "
        .. "its own, got one without"):format(through))
    end
  end
end

function gas.check(values, bad)
  if (values.eos == nil) == (values.explosive == nil) then
    bad(nil, "eos or explosive", values.eos == nil and "neither" or "both")
  end
  for _, name in ipairs { "density", "diameter" } do
    if values[name] and not values.explosive then bad(name, "an explosive to go with it", "an eos") end
  end
  local name = values.name or "charge"
  if type(values.eos) == "function" then try_eos(values.eos, name, bad) end
  if type(values.gas_speed) == "function" then
    try_in_time(values.gas_speed, name, "gas_speed", bad, function(speed)
      return not (finite(speed) and speed >= 0) and "a speed >= 0 (m/s)" or nil
    end)
  end
  if values.stemming then check_stemming(values, bad) end
  if object.kind(values.venting) == "orifice" then
    check_orifice(values, bad)
  elseif values.venting then
    try_in_time(values.venting, name, "venting", bad, function(part)
      return not (finite(part) and part >= 0 and part <= 1) and "a part from 0 to 1" or nil
    end)
  end
end

local function flatten_eos(law)
  if type(law) == "function" then return nil end
  if object.kind(law) == "polytropic" then
    return { kind = "polytropic", pressure = get(law, "pressure"), gamma = get(law, "gamma") }
  end
  return explosives.jwl(law)
end

-- A second hole of that name: in the same region, whose name is given then, or in another.
local function refuse_second(charge, region)
  local wanted = given(charge, "hole")
  if region then
    places.fail(object.place(charge), ("charge.hole: expected a hole with a name of its own, got %q, of which region %q has two")
      :format(wanted, region))
  end
  places.fail(object.place(charge), ("charge.region: expected the region of hole %q, of which there are two, got nothing")
    :format(wanted))
end

-- Region and hole by number.
local function find_hole(charge, regions, links)
  local wanted, region = given(charge, "hole"), given(charge, "region")
  local asked = region and links.region(region, charge)
  local names, found, elsewhere = {}, nil, nil
  for r, candidate in ipairs(regions) do
    for h, hole in ipairs(given(candidate, "holes") or {}) do
      local name = given(hole, "name") or ("hole %d"):format(h)
      names[#names + 1] = name
      if name == wanted and asked and candidate ~= asked then elsewhere = given(candidate, "name") or ("region %d"):format(r) end
      if name == wanted and (not asked or candidate == asked) then
        if found then refuse_second(charge, found.region == r and (given(candidate, "name") or ("region %d"):format(r))) end
        found = { region = r, hole = h, outline = given(hole, "points") }
      end
    end
  end
  if not found and elsewhere then
    places.fail(object.place(charge), ("charge.hole: there is no hole %q in region %q; it is in region %q"):format(wanted, region, elsewhere))
  elseif not found then
    places.fail(object.place(charge), ("charge.hole: there is no hole %q%s; name it with talus.circle { …, name = %q }")
      :format(wanted, native.suggestion(wanted, names), wanted))
  end
  return found
end

local function flatten_orifice(orifice, law, density)
  if object.kind(orifice) ~= "orifice" then return nil end
  return { coefficient = get(orifice, "coefficient"), atmosphere = get(orifice, "atmosphere"), opening = given(orifice, "opening"),
           density = given(orifice, "density") or density,
           gamma = given(orifice, "gamma") or law and (law.gamma or 1 + law.omega) or 1.4 }
end

local function flatten_stemming(stemming)
  return stemming and { length = get(stemming, "length"), density = get(stemming, "density"), charge_length = given(stemming, "charge_length") }
end

local function flatten_charge(charge, name, i, at)
  local eos, speed, venting = given(charge, "eos"), get(charge, "gas_speed"), given(charge, "venting")
  local law, mass, density
  if eos then law = flatten_eos(eos) else law, mass, density = explosives.charge(charge, at.outline) end
  local function of_script(value, wrap) return type(value) == "function" and wrap(value, name) or nil end
  return { place = object.place(charge), name = name, region = at.region, hole = at.hole, delay = get(charge, "delay"),
           scatter = given(charge, "delay_scatter")
             and { deviation = given(charge, "delay_scatter"), seed = get(charge, "seed"), charge = i },
           mass = mass, law = law, eos = of_script(eos, eos_with_chamber),
           speed = type(speed) == "number" and speed or nil, speed_law = of_script(speed, law_with_chamber),
           venting = of_script(venting, law_with_chamber), orifice = flatten_orifice(venting, law, density),
           stemming = flatten_stemming(given(charge, "stemming")) }
end

-- A charge and what it is made of: objects without anything that could change while a simulation uses them.
function gas.parts(charge)
  local parts = { charge }
  for _, name in ipairs { "explosive", "eos", "venting", "stemming" } do
    local part = given(charge, name)
    if object.kind(part) then parts[#parts + 1] = part end
  end
  return parts
end

function gas.flatten(charges, regions, links)
  local list, taken, named = {}, {}, {}
  for i, charge in ipairs(charges) do
    local at = find_hole(charge, regions, links)
    local key = at.region .. "/" .. at.hole
    if taken[key] then
      places.fail(object.place(charge), ("charge.hole: expected a hole of its own, got %q, which has a charge already"):format(
        given(charge, "hole")))
    end
    local name = given(charge, "name") or ("charge %d"):format(i)
    if named[name] then
      places.fail(object.place(charge), ("charge.name: expected a name of its own, got %q, the name of charge %d"):format(name,
        named[name]))
    end
    taken[key], named[name] = true, i
    list[i] = flatten_charge(charge, name, i, at)
  end
  check_collars(charges)
  return list
end

return gas
