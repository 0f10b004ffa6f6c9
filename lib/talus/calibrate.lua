-- Joint values from wanted strengths: tests, and corrections in proportion. At a fixed ratio of cohesion to tension strengths are in
-- proportion to both, as rock and contacts are linear but for angles; the ratio changes little from round to round.
local object = require "talus.object"
local lab = require "talus.lab"
local get, given = object.get, object.given

local function flow(friction) return math.tan(math.pi/4 + friction/2)^2 end

-- What a test gives, or nothing and why it could not be made: a run that has to stop, or joint values that no test can begin with.
local function tried(test, fields)
  local worked, answer = pcall(test, fields)
  if worked then return answer end
  if type(answer) ~= "table" or answer.kind ~= "run" and answer.kind ~= "input" then error(answer, 0) end
  return nil, answer.message
end

local function new_joint(fields) return object.new("joint", fields) end

-- The means over the meshes of what the tests of one set of joint values give; of a test that gives no strength above 0 nothing, and why.
local function measure(options, values)
  local sums, count = { young = 0, ucs = 0, tensile = 0, confined = 0 }, get(options, "meshes")
  local confined, problem = given(options, "confined"), nil
  local function add(name, curve, message)
    if curve and curve.strength > 0 and sums[name] then
      sums[name] = sums[name] + curve.strength/count
    else
      problem = problem or ("the test for `%s` %s"):format(name, message and "failed: " .. message or "found no strength")
      sums[name] = nil
    end
  end
  for k = 1, count do
    local size = given(options, "size")*0.98^(k - 1)
    local joint, refused = tried(new_joint, { name = "calibrated", friction = values.friction, cohesion = values.cohesion,
                                              tension = values.tension, residual = given(options, "residual") })
    if not joint then return {}, refused end
    local width = get(options, "across")*given(options, "size")
    local function test(pressure)
      return tried(lab.compression, { material = given(options, "material"), joint = joint, size = size, width = width,
                                      pressure = pressure, keep = 0.85 })
    end
    local uniaxial, message = test(0)
    add("ucs", uniaxial, message)
    sums.young = sums.young and uniaxial and uniaxial.young and sums.young + uniaxial.young/count
    add("tensile", tried(lab.brazilian, { material = given(options, "material"), joint = joint, size = size, diameter = 2*width,
                                          keep = 0.85 }))
    if confined then add("confined", test(given(confined, "pressure"))) end
  end
  sums.young = sums.young or nil  -- where strengths are passed at once there is no slope
  if not confined then sums.confined = nil end
  return sums, problem
end

local function misses(options, reached)
  local worst = math.max(math.abs(reached.ucs/given(options, "ucs") - 1), math.abs(reached.tensile/given(options, "tensile") - 1))
  local confined = given(options, "confined")
  if confined then worst = math.max(worst, math.abs(reached.confined/given(confined, "strength") - 1)) end
  return worst
end

-- Friction first: it moves the uniaxial strength of a given cohesion, 2 c tan(45° + φ/2), too.
local function corrected(options, values, reached)
  local friction, confined = values.friction, given(options, "confined")
  if confined then
    local pressure = given(confined, "pressure")
    local wanted, got = (given(confined, "strength") - given(options, "ucs"))/pressure, (reached.confined - reached.ucs)/pressure
    local slope = math.min(100, math.max(1, flow(friction)*wanted/math.max(got, 0.1)))
    friction = 2*(math.atan(math.sqrt(slope)) - math.pi/4)
  end
  return { friction = friction, tension = values.tension*given(options, "tensile")/reached.tensile,
           cohesion = values.cohesion*given(options, "ucs")/reached.ucs*math.sqrt(flow(values.friction)/flow(friction)) }
end

return function(fields)
  local options = object.new("calibrate", fields)
  local friction = get(options, "friction")
  local values = { friction = friction, tension = given(options, "tensile"), cohesion = given(options, "ucs")/2/math.sqrt(flow(friction)) }
  local best
  for round = 1, get(options, "most") do
    local reached, problem = measure(options, values)
    local off = problem and math.huge or misses(options, reached)
    if not best or off < best.off then best = { joint = values, reached = reached, off = off } end
    best.rounds, best.converged = round, best.off <= get(options, "tolerance")
    best.reason = problem
    if best.converged or problem then break end
    values = corrected(options, values, reached)
  end
  if not best.converged and not best.reason then
    best.reason = ("a strength misses by %.3g of its value, rounds: %d"):format(best.off, best.rounds)
  end
  return best
end
