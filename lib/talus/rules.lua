-- What must hold between the fields of one object. A rule gets the given values and `bad(field, expected, got)`.
local native = require "talus.native"

local rules = {}

local function one_of(values, a, b, bad)
  if values[a] == nil and values[b] == nil then bad(nil, ("%s or %s"):format(a, b), "neither") end
  if values[a] ~= nil and values[b] ~= nil then bad(nil, ("%s or %s"):format(a, b), "both") end
end

function rules.region(values, bad)
  one_of(values, "outline", "blocks", bad)
  local v = values.velocity
  local moving = v and (v[1] ~= 0 or v[2] ~= 0) and "velocity" or (values.spin or 0) ~= 0 and "spin"
  if values.held and moving then bad(moving, "a region that is not held; a talus.fix moves what is", "held = true") end
  if values.bonded and not values.blocks then bad("bonded", "ready blocks to go with it", "an outline") end
  if not values.blocks then return end
  if values.holes and not values.bonded then bad("holes", "an outline or bonded blocks to go with it", "blocks that are not bonded") end
  for _, name in ipairs { "mesh", "cuts", "slivers", "sliver_part" } do
    if values[name] then bad(name, "an outline to go with it", "ready blocks") end
  end
end

function rules.mesh(values, bad)
  local is_pattern = values.kind ~= nil and values.kind ~= "triangles" and values.kind ~= "voronoi"
  if values.seed and values.kind ~= "voronoi" then bad("seed", 'kind "voronoi"', values.kind or "triangles") end
  if (values.nx == nil) ~= (values.ny == nil) then
    bad(values.nx and "ny" or "nx", "both nx and ny", "one of them")
  end
  if values.nx and not is_pattern then bad("nx", 'kind "cross", "diagonal" or "alternating"', values.kind or "triangles") end
  if values.size == nil and not values.nx then
    bad("size", is_pattern and "a size (m) or nx and ny" or "a size (m)", "nothing")
  end
  if values.size ~= nil and values.nx then bad("size", "a size or nx and ny", "both") end
  if is_pattern and values.size ~= nil and type(values.size) ~= "number" then
    bad("size", "a number for a pattern", "a size field")
  end
end

function rules.grade(values, bad)
  for i, source in ipairs(values.sources or {}) do
    if source.size > values.far then
      bad(("sources[%d].size"):format(i), ("at most far = %g (m)"):format(values.far), ("%g"):format(source.size))
    end
  end
end

function rules.stiffness(values, bad)
  one_of(values, "value", "times_young", bad)
  if values.times_young and values.per ~= "contact" then
    bad("times_young", 'per = "contact"', "stiffness per " .. values.per)
  end
end

local laws = require "talus.fracture_laws"

function rules.joint(values, bad)
  if values.residual and values.reduction then bad(nil, "residual or reduction", "both") end
  laws.check_residual(values, values.residual, "residual", bad)
  laws.check_residual(values, laws.residual_of(values.reduction), "reduction.residual", bad)
  laws.try_criterion(values, bad)
  laws.try_reduction(values, bad)
  if values.tension and not values.cohesion and not values.criterion then
    bad("cohesion", "a number >= 0 (Pa) beside tension, as bonds without cohesion fail in shear at once", "nothing")
  end
end

function rules.calibrate(values, bad)
  if not values.confined then return end
  local given = require("talus.object").given
  local strength, pressure = given(values.confined, "strength"), given(values.confined, "pressure")
  if strength <= values.ucs then bad("confined.strength", ("more than ucs = %g (Pa)"):format(values.ucs), "no more") end
  if strength <= pressure then
    bad("confined.strength", ("more than the pressure at the sides, %g (Pa)"):format(pressure), ("%g"):format(strength))
  end
end

-- s: time does not go on by less, and squares of less are no numbers.
local function least_time(t_end) return 2^-52*math.max(t_end, 1e-100) end

function rules.simulation(values, bad)
  local object = require "talus.object"
  if object.get(values.time, "mode") ~= "static" then
    local every, t_end = values.output and object.get(values.output, "every"), object.get(values.time, "t_end")
    local least = least_time(t_end)
    if every and every < least then
      require("talus.places").fail(object.place(values.output), ("simulation.output.every: expected at least %.3g (s), as time cannot come to t_end = %g by less, got %g"):format(least, t_end, every))
    end
    return
  end
  if values.charges then bad("charges", 'time.mode = "dynamic", as gas moves rock in time', "static") end
  for _, fix in ipairs(values.fix or {}) do
    local spin = object.get(fix, "spin")
    if spin ~= 0 then
      require("talus.places").fail(object.place(fix), ("fix.spin: expected 0, as a static run moves what is held but does not turn it, got %g"):format(spin))
    end
  end
end

-- persistence = trace_length/(trace_length + gap): two of the three give the third.
local function check_gap(values, bad)
  local length, gap, persistence = values.trace_length, values.gap, values.persistence
  if not length then
    if not persistence then bad("gap", "trace_length or persistence beside it", "gap alone") end
    if persistence == 1 then bad("gap", "a persistence < 1", "persistence = 1") end
    return
  end
  local follows = length/(length + gap)
  if persistence and math.abs(persistence - follows) > 1e-6*follows then  -- what a script computes agrees to round-off
    bad("persistence", ("%.6g, as trace_length/(trace_length + gap), or only two of the three"):format(follows),
      ("%g"):format(persistence))
  end
end
function rules.charge(values, bad) require("talus.gas").check(values, bad) end

function rules.jwl(values, bad) require("talus.explosives").check_jwl(values, bad) end

function rules.explosive(values, bad) require("talus.explosives").check(values, bad) end

function rules.joint_set(values, bad)
  local broken = values.gap or values.persistence and values.persistence < 1
  if values.gap then
    check_gap(values, bad)
  elseif broken and not values.trace_length then
    bad("trace_length", "a number > 0 (m), as persistence < 1", "nothing")
  end
  for _, name in ipairs { "trace_length", "trace_length_scatter", "gap_scatter" } do
    if values[name] and not broken then bad(name, "a persistence < 1 or a gap to go with it", "joints without bridges") end
  end
end

function rules.collect(values, bad)
  local count = (values.run and 1 or 0) + (values.history and 1 or 0) + (values.value and 1 or 0)
  if count ~= 1 then bad(nil, "one of run, history and value", count == 0 and "none" or "more than one") end
  for _, name in ipairs { "take", "at" } do
    if values[name] and not values.history then bad(name, "history beside it", "none") end
  end
  if values.take and values.at then bad(nil, "take or at", "both") end
end

function rules.fix(values, bad)
  if values.displacement and values.velocity then bad(nil, "displacement or velocity", "both") end
  if values.spin and values.on then bad("spin", "a fixity of the whole region", "one with `on`") end
  if values.x == false and values.y == false then bad(nil, "x or y to be held", "neither") end
  local held = { values.x, values.y }
  if held[1] == nil then held[1] = values.y ~= true end
  if held[2] == nil then held[2] = values.x ~= true end
  for _, field in ipairs { "displacement", "velocity" } do
    for k, axis in ipairs { "x", "y" } do
      local value = values[field] and values[field][k]
      if value and value ~= 0 and not held[k] then
        bad(("%s[%d]"):format(field, k), ("0, as %s is not held"):format(axis), native.describe(value))
      end
    end
  end
end

-- The law is tried standing and moving, twice alike: steps call it again when they are repeated.
function rules.numerics(values, bad)
  local law = values.damping
  if type(law) ~= "function" then return end
  for _, speed in ipairs { 0, 1 } do
    local at = ("at speed = %g, dt = 0.001"):format(speed)
    local worked, kept = pcall(law, speed, 1e-3)
    if not worked then bad("damping", "a function that works " .. at, tostring(kept)) end
    if not math.type(kept) or not (kept >= 0 and kept <= 1) then
      bad("damping", "a number in [0, 1] " .. at, native.describe(kept))
    end
    local _, again = pcall(law, speed, 1e-3)
    if again ~= kept then bad("damping", "the same answer to the same question " .. at, ("%s, then %s"):format(kept, again)) end
  end
end

function rules.line(values, bad)
  if values.from[1] == values.to[1] and values.from[2] == values.to[2] then
    bad(nil, "two different points", ("{%g, %g} twice"):format(values.from[1], values.from[2]))
  end
end

function rules.rect(values, bad)
  if values.from[1] == values.to[1] or values.from[2] == values.to[2] then
    bad(nil, "opposite corners of a rectangle with positive area",
      ("(%g, %g) and (%g, %g)"):format(values.from[1], values.from[2], values.to[1], values.to[2]))
  end
end

function rules.time(values, bad)
  if values.mode == "static" then
    for _, name in ipairs { "dt", "dt_min", "dt_max", "tolerance" } do
      if values[name] then bad(name, 'mode = "dynamic"', "static: steps divide the load, not time") end
    end
    return
  end
  if values.dt and values.tolerance then bad("dt", "dt_max, as `tolerance` chooses the step", "a fixed step") end
  if not values.t_end or values.t_end == 0 then
    bad("t_end", "a number > 0 (s) in dynamic mode", values.t_end or "nothing")
  end
  local least = least_time(values.t_end)
  for _, name in ipairs { "dt", "dt_min", "dt_max" } do
    if values[name] and values[name] < least then
      bad(name, ("at least %.3g (s), as time cannot come to t_end = %g by less"):format(least, values.t_end), ("%g"):format(values[name]))
    end
  end
  if values.steps then bad("steps", 'mode = "static"', "dynamic: give dt or displacement_ratio") end
  if values.dt_min and values.dt_max and values.dt_min > values.dt_max then
    bad("dt_min", ("at most dt_max = %g (s)"):format(values.dt_max), ("%g"):format(values.dt_min))
  end
  if values.dt and values.dt_max and values.dt > values.dt_max then
    bad("dt", ("at most dt_max = %g (s)"):format(values.dt_max), ("%g"):format(values.dt))
  end
  if values.dt and values.dt_min and values.dt < values.dt_min then
    bad("dt", ("at least dt_min = %g (s)"):format(values.dt_min), ("%g"):format(values.dt))
  end
end

return rules
