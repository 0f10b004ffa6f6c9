-- Explosives: constants, and the isentrope and mass of a charge of a density and diameter in its hole.
local object = require "talus.object"
local places = require "talus.places"
local get, given = object.get, object.given

local explosives = {}

-- Dobratz & Crawford, LLNL Explosives Handbook (1985); emulsion: Hansson, SveBeFo (2009), rounded. Units: kg/m3, Pa, J/m3.
explosives.known = {
  TNT = { density = 1630, A = 371.2e9, B = 3.231e9, R1 = 4.15, R2 = 0.95, omega = 0.30, E = 7.0e9 },
  ANFO = { density = 931, A = 49.46e9, B = 1.891e9, R1 = 3.907, R2 = 1.118, omega = 0.333, E = 2.484e9 },
  emulsion = { density = 1245, A = 214.4e9, B = 0.182e9, R1 = 4.2, R2 = 0.9, omega = 0.15, E = 4.19e9 },
}

local names = { "A", "B", "R1", "R2", "omega", "E" }

-- C of the isentrope is what is left of the pressure in the end.
local function check_tail(values, bad)
  local least = values.A/values.R1*math.exp(-values.R1) + values.B/values.R2*math.exp(-values.R2)
  if values.E <= least then
    bad("E", ("more than A/R1 e^-R1 + B/R2 e^-R2 = %.6g (J/m3), or the pressure becomes negative"):format(least), ("%g"):format(values.E))
  end
end

function explosives.check(values, bad) check_tail(values, bad) end

function explosives.check_jwl(values, bad)
  for _, name in ipairs(names) do
    if values.explosive and values[name] then bad(name, "an explosive or its constants", "both") end
    if not values.explosive and not values[name] then bad(name, "a number > 0, as no explosive is named", "nothing") end
  end
  if not values.explosive then check_tail(values, bad) end
end

-- Flat constants of a talus.eos.jwl, or of what a charge says of its explosive: a name or a table.
function explosives.constants(source)
  local known = explosives.known[type(source) == "string" and source or object.kind(source) == "jwl" and given(source, "explosive")]
  local flat = { kind = "jwl" }
  for _, name in ipairs(names) do flat[name] = known and known[name] or given(source, name) end
  return flat, known and known.density or object.kind(source) == "explosive" and given(source, "density") or nil
end

-- Area of a hole, and the diameter of the widest charge: of the circle round a regular polygon of six corners or more, which stands for
-- it as a talus.circle does; else of a disc of that area.
local function size_of(points)
  local area, n, x, y = 0, #points, 0, 0
  for i, p in ipairs(points) do
    local q = points[i % n + 1]
    area = area + (p[1]*q[2] - p[2]*q[1])/2
    x, y = x + p[1]/n, y + p[2]/n
  end
  area = math.abs(area)
  local round = 2*math.sqrt(2*area/(n*math.sin(2*math.pi/n)))
  for _, p in ipairs(points) do
    if n < 6 or math.abs(2*math.sqrt((p[1] - x)^2 + (p[2] - y)^2) - round) > 1e-6*round then return area, 2*math.sqrt(area/math.pi) end
  end
  return area, round
end

-- The isentrope in v = V/V0 and the mass a metre. w, the volume over that of the explosive at the density its constants hold
-- for, is V (that density)/mass = v/filled: products go by volume per mass, so a looser charge begins further down.
function explosives.charge(charge, outline)
  local law, reference = explosives.constants(given(charge, "explosive"))
  local area, widest = size_of(outline)
  local diameter = given(charge, "diameter")
  if diameter and diameter > widest*(1 + 1e-9) then
    places.fail(object.place(charge), ("charge.diameter: expected at most that of the hole %q, %.6g (m), got %g"):format(
      given(charge, "hole"), widest, diameter))
  end
  local mass = (given(charge, "density") or reference)*(diameter and math.pi/4*diameter^2 or area)
  law.filled = mass/(reference*area)
  return law, mass, mass/area
end

function explosives.jwl(law)
  local flat = explosives.constants(law)
  flat.filled = get(law, "filled")
  return flat
end

return explosives
