-- Peak particle velocity and its attenuation with scaled distance.
local object = require "talus.object"
local places = require "talus.places"
local native = require "talus.native"
local fit = require "talus.fit"
local choice = require "talus.blast.choice"
local given = object.given

-- Where the distance is counted from, and the mass of the charge there, if it is known.
local function origin(sim, options)
  local at, charges = given(options, "at"), sim.charges
  if type(at) == "table" then return at end
  if #charges == 0 then
    places.fail(object.place(options), "vibration.at: expected a point, as the simulation has no charges, got "
      .. native.describe(at))
  end
  local charge = charges[at or 1]
  if not charge then
    local names = {}
    for _, one in ipairs(charges) do names[#names + 1] = one.name end
    places.fail(object.place(options), ("vibration.at: there is no charge %q%s"):format(at, native.suggestion(at, names)))
  end
  return { charge.x, charge.y }, charge.mass
end

local function wanted_probes(sim, options)
  if not given(options, "probes") then
    local list = {}
    for i = 1, #sim.probes do list[i] = sim.probes[i] end  -- not to the one after the last, which messages would tell of
    return list
  end
  local list = {}
  for i, name in ipairs(given(options, "probes")) do list[i] = sim.probes[name] end
  return list
end

local function write(sim, name, found)
  local distance, scaled, ppv, law = {}, {}, {}, {}
  for i, point in ipairs(found.points) do distance[i], scaled[i], ppv[i] = point.distance, point.scaled, point.ppv end
  local series = { { name = "probes", x = scaled, y = ppv, markers = true, line = false } }
  if found.K then
    for i, x in ipairs(scaled) do law[i] = found.K*x^-found.beta end
    series[2] = { name = ("%.3g (R/√W)^−%.3g"):format(found.K, found.beta), x = scaled, y = law, dashed = true }
  end
  sim:table(name, { { "distance [m]", distance }, { "scaled distance [m/kg^0.5]", scaled }, { "ppv [m/s]", ppv } })
  sim:plot(name, { title = "Peak particle velocity", x_label = "R/√W", x_unit = "m/√kg", y_label = "PPV", y_unit = "m/s", log_x = true,
                   log_y = true, series })
end

return function(sim, fields)
  local options = choice.options("vibration", sim, fields)
  local from, mass = origin(sim, options)
  local root = math.sqrt(given(options, "mass") or mass or 1)
  local found = { points = {} }
  for _, probe in ipairs(wanted_probes(sim, options)) do
    local distance = math.sqrt((probe.x - probe.ux - from[1])^2 + (probe.y - probe.uy - from[2])^2)
    if distance > 0 and probe.peak_speed > 0 then
      found.points[#found.points + 1] = { name = probe.name, distance = distance, scaled = distance/root, ppv = probe.peak_speed,
                                          time = probe.peak_at }
    end
  end
  table.sort(found.points, function(a, b) return a.distance < b.distance end)
  local xs, ys = {}, {}
  for i, point in ipairs(found.points) do xs[i], ys[i] = math.log(point.scaled), math.log(point.ppv) end
  local a, b, residual = fit.line(xs, ys)
  if a then found.K, found.beta, found.residual = math.exp(a), -b, residual end
  if given(options, "file") and #found.points > 0 then write(sim, given(options, "file"), found) end
  return found
end
