-- A bar hung from a pin, let go at 0.2 rad: its period over ten swings, T = 2 pi sqrt(I/(m g l)) (1 + a²/16 + 11 a⁴/3072).
-- Source: physical pendulum, series in the amplitude a (Landau & Lifshitz, Mechanics, § 11).
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
