-- A bar hung from a pin, let go at 0.2 rad: its period over ten swings, T = 2 pi sqrt(I/(m g l)) (1 + a²/16 + 11 a⁴/3072).
-- Source: physical pendulum, series in the amplitude a (Landau & Lifshitz, Mechanics, § 11).
-- Let go at 1 rad, the pin holds m (g - a_c), a_c the acceleration of the centroid on its circle; to first order in the step, as places are, and from
-- 0.05 s on, when a pin that was not pressed has settled. Its spring is 10^4 times as stiff as the bar: it stores next to nothing.
local talus = require "talus"
local u = talus.units
local g, amplitude, width, height = 9.81, 0.2, 0.2, 1.0
local rock = talus.material { name = "rock", density = 2500, young = 20*u.GPa, poisson = 0.2 }

-- Bar with its pin at the origin, at the angle a from hanging.
local function bar(a)
  local c, s = math.cos(a), math.sin(a)
  local function at(x, y) return { c*x - s*y, s*x + c*y } end
  return talus.polygon { at(-width/2, -height), at(width/2, -height), at(width/2, 0), at(-width/2, 0) }, at(0, -height/2)
end

local function period(order, dt)
  local outline, centre = bar(amplitude)
  local sim = talus.simulation {
    gravity = {0, -g},
    regions = { talus.region { name = "bar", outline = outline, material = rock, order = order } },
    fix = { talus.fix { region = "bar", on = talus.point(0, 0) } },
    probes = { centre = centre },
    time = { mode = "dynamic", t_end = 30, dt = dt },
  }
  -- Crossings of the vertical to the left and to the right alternate; a linear interpolation places each.
  local crossings, before, largest = {}, centre[1], 0
  for _ in sim:steps() do
    local x = centre[1] + sim.probes.centre.ux
    if before*x <= 0 and before ~= 0 then
      crossings[#crossings + 1] = sim.time - dt*x/(x - before)
      if #crossings == 21 then break end
    end
    if #crossings > 19 then largest = math.max(largest, math.abs(x)) end
    before = x
  end
  return (crossings[21] - crossings[1])/10, largest/(height/2)
end

local swing = amplitude
local inertia_by_mass = (width^2 + height^2)/12 + (height/2)^2
local expected = 2*math.pi*math.sqrt(inertia_by_mass/(g*height/2))*(1 + swing^2/16 + 11*swing^4/3072)
for _, order in ipairs { "rigid", 1 } do
  local t, last = period(order, 2e-3)
  talus.check.near("pendulum, order " .. order .. ": period over 10 swings, s", t, expected, { rel = 1e-3 })
  talus.check.near("pendulum, order " .. order .. ": amplitude of the 10th swing", last, math.sin(amplitude), { rel = 0.02 })
end

-- Error of the pin's force, the largest of a first half swing over the weight, and the highest strain energy over that of the swing.
local function held(order, dt)
  local start = 1
  local outline = bar(start)
  local sim = talus.simulation { gravity = {0, -g}, regions = { talus.region { name = "bar", outline = outline, material = rock, order = order } },
    fix = { talus.fix { name = "pin", region = "bar", on = talus.point(0, 0) } }, time = { mode = "dynamic", t_end = 0.8, dt = dt } }
  local mass, off, strain = rock.density*width*height, 0, 0
  for _ in sim:steps() do
    local a = start + sim.blocks[1].rotation
    local rate2, faster = 2*g*height/2*(math.cos(a) - math.cos(start))/inertia_by_mass, -g*height/2*math.sin(a)/inertia_by_mass
    local along, across = g*math.cos(a) + rate2*height/2, faster*height/2 + g*math.sin(a)
    local fx, fy = mass*(across*math.cos(a) - along*math.sin(a)), mass*(across*math.sin(a) + along*math.cos(a))
    local r, e = sim.reactions.pin, sim.energy
    if sim.time > 0.05 then off = math.max(off, math.sqrt((r[1] - fx)^2 + (r[2] - fy)^2)/(mass*g)) end
    strain = math.max(strain, e.strain)
  end
  return off, strain/sim.energy.scale
end
for _, order in ipairs { "rigid", 1 } do
  local coarse, strain = held(order, 4e-3)
  local fine = held(order, 2e-3)
  local label = "pendulum, order " .. order .. ": "
  talus.check.between(label .. "order of the pin's force in the step", math.log(coarse/fine, 2), 0.9, 1.1)
  talus.check.below(label .. "the pin's force at 2 ms, off by, of the weight", fine, 0.02)
  talus.check.below(label .. "highest strain energy over that of the swing", strain, order == "rigid" and 1e-8 or 1e-5)
end
