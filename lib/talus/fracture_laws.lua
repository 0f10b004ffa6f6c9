-- What a joint says of its failure: checks, trials of the functions it gives, and its flat form for the engine.
local native = require "talus.native"
local trial = require "talus.trial"
local finite = trial.finite

local laws = {}
local object  -- requires the rules, and so this file

local function of(self, name)
  object = object or require "talus.object"
  return object.get(self, name)
end
local function kind(value)
  object = object or require "talus.object"
  return object.kind(value)
end

local usual_cohesion = 0.05e6  -- Pa, of the roughness of a crack (Ning et al. 2011)

function laws.residual_of(law)
  local word = kind(law)
  if word == "softening" or word == "slip_weakening" then return of(law, "residual") end
end

local unlimited = 1e30  -- Pa

-- Cohesion without tension is Mohr and Coulomb's line without a cut-off: it ends at c/tan φ.
local function tension_of(friction, cohesion, tension)
  if tension then return tension end
  if not cohesion then return 0 end
  return math.min(unlimited, cohesion/math.tan(friction))
end

-- The joint's strengths with what is left out filled in.
local function strength(values)
  local friction = values.friction or math.pi/6
  return { friction = friction, cohesion = values.cohesion or 0, tension = tension_of(friction, values.cohesion, values.tension) }
end

local function filled(residual, intact)
  local function value(name, default)
    local given = residual and of(residual, name)
    if given == nil then return default end
    return given
  end
  return { friction = value("friction", intact.friction),
           cohesion = value("cohesion", math.min(usual_cohesion, intact.cohesion)),
           tension = value("tension", 0) }
end

function laws.check_residual(values, residual, path, bad)
  if not residual then return end
  local intact = strength(values)
  for _, name in ipairs { "cohesion", "tension" } do
    local left = of(residual, name)
    if left and left > intact[name] then
      bad(path .. "." .. name, ("at most the joint's own, %g (Pa)"):format(intact[name]), ("%g"):format(left))
    end
  end
end

-- What a criterion sees of a bond, with a stand-in for where that lies. As in a run its metatable cannot be taken away.
local function asked(values, intact, normal, shear)
  local bond = { id = 1, length = 1, x = 0, y = 0, dip = 0, property = values.name or "joint 1" }
  return setmetatable({ normal = normal, shear = shear, tension = intact.tension, cohesion = intact.cohesion,
                        friction = intact.friction }, { __index = bond, __metatable = false })
end

function laws.try_criterion(values, bad)
  if not values.criterion then return end
  local intact = strength(values)
  for _, load in ipairs { { 0, 0 }, { 1, 1 }, { -1, 1 } } do
    local given = ("at normal = %g, shear = %g"):format(load[1], load[2])
    local bond = asked(values, intact, load[1], load[2])
    local first, second = trial.twice(values.criterion, "criterion", given, bad, bond)
    for name, value in pairs(intact) do
      if bond[name] ~= value then bad("criterion", "a function that leaves what it is given as it is", "one that sets t." .. name) end
    end
    if not (finite(first) and first >= 0) then
      bad("criterion", "a finite number >= 0 (how far the strength is used) " .. given, native.describe(first))
    end
    if first ~= second then
      bad("criterion", "the same answer to the same traction " .. given, ("%s, then %s"):format(first, second))
    end
  end
end

local remains = { "friction", "cohesion", "tension" }
local known = { friction = true, cohesion = true, tension = true }

-- One strength of what a reduction returned.
local function try_left(name, left, own, given, bad)
  if left == nil then return end
  if name == "friction" then
    if not (finite(left) and left >= 0 and left <= math.pi/2) then
      local hint = finite(left) and left > 0 and left < 90 and ("; in degrees? write %g*talus.units.deg"):format(left) or ""
      bad("reduction", "a friction in [0, π/2] (rad) " .. given, native.describe(left) .. hint)
    end
  elseif not (finite(left) and left >= 0) then
    bad("reduction", ("a %s >= 0 %s"):format(name, given), native.describe(left))
  elseif left > own*(1 + 1e-12) then
    bad("reduction", ("a %s of at most the joint's own, %g (Pa) %s"):format(name, own, given), ("%g"):format(left))
  end
end

-- The law with its answer read: what it does when it is read belongs to it.
local function read(law)
  return function(...)
    local answer = law(...)
    if type(answer) ~= "table" then return answer end
    local fields = {}
    for name in pairs(answer) do fields[name] = answer[name] end
    for _, name in ipairs(remains) do fields[name] = answer[name] end
    return fields
  end
end

function laws.try_reduction(values, bad)
  if type(values.reduction) ~= "function" then return end
  for _, way in ipairs { { 0, 0 }, { 1e-3, 0 }, { 0, 1e-3 } } do
    local given = ("at slip = %g, opening = %g, normal = 0"):format(way[1], way[2])
    local first, second = trial.twice(read(values.reduction), "reduction", given, bad, strength(values), way[1], way[2], 0)
    if type(first) ~= "table" then
      bad("reduction", "a table { friction, cohesion, tension } " .. given, native.describe(first))
    end
    for name in pairs(first) do
      if not known[name] then
        bad("reduction", "friction, cohesion and tension in the table " .. given, native.describe(name))
      end
    end
    for _, name in ipairs(remains) do
      try_left(name, first[name], strength(values)[name], given, bad)
      if type(second) ~= "table" or second[name] ~= first[name] then
        bad("reduction", "the same answer to the same question " .. given, "another the second time")
      end
    end
  end
end

-- Bonds break where the joint gives a strength.
function laws.flatten(joint, flat)
  local given = object and object.given or require("talus.object").given
  flat.tension = tension_of(flat.friction, given(joint, "cohesion"), given(joint, "tension"))
  local intact = { friction = flat.friction, cohesion = flat.cohesion, tension = flat.tension }
  flat.breaks = given(joint, "tension") ~= nil or given(joint, "cohesion") ~= nil
    or given(joint, "criterion") ~= nil
  flat.criterion = given(joint, "criterion")
  local law = given(joint, "reduction")
  local residual = filled(given(joint, "residual") or laws.residual_of(law), intact)
  flat.residual_friction, flat.residual_cohesion, flat.residual_tension =
    residual.friction, residual.cohesion, residual.tension
  if type(law) == "function" then
    flat.reduction = law
  elseif law then
    flat.law = { kind = kind(law) }
    for _, name in ipairs { "shape", "G_I", "G_II", "distance", "jrc", "jcs" } do
      local known, value = pcall(of, law, name)
      if known then flat.law[name] = value end
    end
    if flat.law.kind == "barton_bandis" then flat.residual_friction = given(law, "friction") or intact.friction end
  end
  local scatter = given(joint, "scatter")
  if scatter then flat.weibull, flat.seed = of(scatter, "modulus"), of(scatter, "seed") end
end

-- Strengths of a joint from Hoek and Brown's criterion (Hoek, Carranza-Torres & Corkum 2002, equations 2 to 5, 7, 12 and 13).
function laws.hoek_brown(fields)
  object = object or require "talus.object"
  local given = object.new("hoek_brown", fields)
  local ucs, mi, gsi, d = of(given, "ucs"), of(given, "mi"), of(given, "gsi"), of(given, "disturbance")
  local mb = mi*math.exp((gsi - 100)/(28 - 14*d))
  local s = math.exp((gsi - 100)/(9 - 3*d))
  local a = 1/2 + (math.exp(-gsi/15) - math.exp(-20/3))/6
  local n = (of(given, "confinement") or ucs/4)/ucs
  local k = (s + mb*n)^(a - 1)
  local sine = 6*a*mb*k/(2*(1 + a)*(2 + a) + 6*a*mb*k)
  local cohesion = ucs*((1 + 2*a)*s + (1 - a)*mb*n)*k
    /((1 + a)*(2 + a)*math.sqrt(1 + 6*a*mb*k/((1 + a)*(2 + a))))
  return { friction = math.asin(sine), cohesion = cohesion, tension = s*ucs/mb }
end

return laws
