-- Joint values from wanted strengths: tests, and corrections in proportion. At a fixed ratio of cohesion to tension strengths are in
-- proportion to both, as rock and contacts are linear but for angles; the ratio changes little from round to round.
local object = require "talus.object"
local lab = require "talus.lab"
local get, given = object.get, object.given

local function flow(friction) return math.tan(math.pi/4 + friction/2)^2 end

-- The means over the meshes of what the tests of one set of joint values give.
local function measure(options, values)
  local sums, count = { young = 0, ucs = 0, tensile = 0, confined = 0 }, get(options, "meshes")
  local confined = given(options, "confined")
  for k = 1, count do
    local size = given(options, "size")*0.98^(k - 1)
    local joint = object.new("joint", { name = "calibrated", friction = values.friction, cohesion = values.cohesion,
                                        tension = values.tension, residual = given(options, "residual") })
    local width = get(options, "across")*given(options, "size")
    local function test(pressure)
      return lab.compression { material = given(options, "material"), joint = joint, size = size, width = width, pressure = pressure,
                               keep = 0.85 }
    end
    local uniaxial = test(0)
    sums.young, sums.ucs = sums.young + uniaxial.young/count, sums.ucs + uniaxial.strength/count
    local split = lab.brazilian { material = given(options, "material"), joint = joint, size = size, diameter = 2*width, keep = 0.85 }
    sums.tensile = sums.tensile + split.strength/count
    if confined then sums.confined = sums.confined + test(given(confined, "pressure")).strength/count end
  end
  if not confined then sums.confined = nil end
  return sums
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
    local reached = measure(options, values)
    local off = misses(options, reached)
    if not best or off < best.off then best = { joint = values, reached = reached, off = off } end
    best.rounds, best.converged = round, best.off <= get(options, "tolerance")
    if best.converged then break end
    values = corrected(options, values, reached)
  end
  return best
end
