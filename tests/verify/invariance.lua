-- Nothing depends on absolute length, place or direction: scenes scaled by 1000, turned by 37 degrees and shifted by
-- 10 km give the same dimensionless answer. Source: dimensional analysis; gravity stays, so times grow with the root
-- of the scale and stiffnesses with the scale.
local talus = require "talus"
local u = talus.units
local g = 9.81

local ways = {
  { name = "as it is", scale = 1, angle = 0, shift = {0, 0} },
  { name = "scaled by 1000", scale = 1000, angle = 0, shift = {0, 0} },
  { name = "scaled by 1/1000", scale = 1/1000, angle = 0, shift = {0, 0} },
  { name = "turned by 37 degrees", scale = 1, angle = 37*u.deg, shift = {0, 0} },
  { name = "shifted by 10 km", scale = 1, angle = 0, shift = {1e4, -1e4} },
}

local function placing(way)
  local c, s = math.cos(way.angle), math.sin(way.angle)
  local function direction(x, y) return { way.scale*(c*x - s*y), way.scale*(s*x + c*y) } end
  local function at(x, y)
    local d = direction(x, y)
    return { d[1] + way.shift[1], d[2] + way.shift[2] }
  end
  -- Back into the axes and the scale of the scene as it is.
  local function back(x, y) return (c*x + s*y)/way.scale, (-s*x + c*y)/way.scale end
  return at, direction, back
end

-- A tilted block is thrown onto a rough slab with two more on it; the three end up somewhere.
local function throw(way)
  local at, direction, back = placing(way)
  local k = way.scale
  local rock = talus.material { name = "rock", density = 2500, young = 1*u.GPa*k, poisson = 0.25 }
  local function box(x, y, w, h, tilt)
    local c, s = math.cos(tilt), math.sin(tilt)
    local corners = {}
    for i, p in ipairs { {0, 0}, {w, 0}, {w, h}, {0, h} } do
      corners[i] = at(x + c*p[1] - s*p[2], y + s*p[1] + c*p[2])
    end
    return talus.polygon(corners)
  end
  local fall = direction(0, -g/k)
  local v = direction(3/math.sqrt(k), 0)
  local sim = talus.simulation {
    gravity = fall, contact = talus.joint { name = "rough", friction = 35*u.deg },
    regions = {
      talus.region { name = "slab", outline = box(-4, -1, 12, 1, 0), material = rock, held = true },
      talus.region { name = "lower", outline = box(1, 0, 1, 0.5, 0), material = rock },
      talus.region { name = "upper", outline = box(1.1, 0.5, 0.8, 0.5, 0), material = rock },
      talus.region { name = "thrown", outline = box(-1.5, 0.6, 0.6, 0.4, 0.3), material = rock, velocity = v },
    },
    time = { mode = "dynamic", t_end = 0.8*math.sqrt(k), dt = 1e-3*math.sqrt(k) },
  }
  sim:run()
  local out = {}
  for i = 2, 4 do
    local b = sim.blocks[i]
    out[#out + 1], out[#out + 2] = back(b.ux, b.uy)
    out[#out + 1] = b.rotation
  end
  return out
end

-- The cantilever: deflection over length and stress over modulus, under a load that grows with the scale squared.
local function bend(way)
  local at, direction, back = placing(way)
  local rock = talus.material { name = "rock", density = 2500, young = 35*u.GPa, poisson = 0.3 }
  local sim = talus.simulation {
    regions = { talus.region { name = "beam", outline = talus.polygon { at(0, 0), at(8, 0), at(8, 1), at(0, 1) },
                               material = rock, mesh = { kind = "cross", nx = 32, ny = 4 } } },
    fix = { talus.fix { region = "beam", on = talus.segment(at(0, 0), at(0, 1)) } },
    loads = { talus.point_load { at = at(8, 0.5), force = direction(0, -5*u.kN) } },
    probes = { tip = at(7.9, 0.5), near = at(1.02, 0.9) },
    time = { mode = "static" },
  }
  sim:run()
  local near = sim.probes.near
  local _, deflection = back(sim.probes.tip.ux, sim.probes.tip.uy)
  return { deflection*35*u.GPa/8, near.s1, near.s2 }  -- all in Pa
end

-- The lengths of automatic steps of a soft block that falls on its corner and shears (of second order: and bends), part of the first.
local function shear(way, order)
  local at, direction = placing(way)
  local k = way.scale
  local clay = talus.material { name = "clay", density = 2500, young = 1*u.MPa*k, poisson = 0.25 }
  local sim = talus.simulation {
    gravity = direction(0, -g/k), contact = talus.joint { friction = 35*u.deg },
    regions = {
      talus.region { name = "slab", outline = talus.polygon { at(-4, -1), at(4, -1), at(4, 0), at(-4, 0) }, material = clay, held = true },
      talus.region { name = "block", outline = talus.polygon { at(0, 0.01), at(0.8, 0.41), at(0.4, 1.21), at(-0.4, 0.81) }, material = clay, order = order,
                     velocity = direction(0, -2/math.sqrt(k)) },
    },
    time = { mode = "dynamic", t_end = 1*math.sqrt(k) },
  }
  local steps = {}
  local first = sim:step().dt
  for i = 1, 14 do steps[i] = sim:step().dt/first end
  return steps
end

local function shear_and_bend(way) return shear(way, 2) end

for name, run in pairs { throw = throw, cantilever = bend, ["lengths of steps"] = shear, ["lengths of steps, second order"] = shear_and_bend } do
  local reference = run(ways[1])
  local largest = 0
  for _, value in ipairs(reference) do largest = math.max(largest, math.abs(value)) end
  for i = 2, #ways do
    local off = 0
    for k, value in ipairs(run(ways[i])) do off = math.max(off, math.abs(value - reference[k])/largest) end
    talus.check.below(string.format("%s, %s: difference", name, ways[i].name), off, 1e-6)
  end
  talus.check.above(name .. ": largest answer", largest, 0.1)
end
