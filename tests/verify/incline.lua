-- A block on an incline, from a settled start: s = g (sin a - cos a tan phi) t²/2 (Coulomb sliding).
local talus = require "talus"
local u = talus.units
local g = 9.81

local function slide(alpha, phi, dt, t_end)
  local a, h = alpha*u.deg, 0.5
  local c, s = math.cos(a), math.sin(a)
  local function at(x, y) return {c*x + s*y, -s*x + c*y} end   -- downhill along +x
  local rock = talus.material { name = "rock", density = 2600, young = 5*u.GPa, poisson = 0.25 }
  local length = 60
  local sim = talus.simulation {
    gravity = {0, -g},
    contact = talus.joint { name = "plane", friction = phi*u.deg },
    regions = {
      talus.region { name = "plane", outline = { at(-2, -1), at(length, -1), at(length, 0), at(-2, 0) },
                     material = rock, held = true },
      talus.region { name = "block", outline = { at(0, 0), at(2*h, 0), at(2*h, h), at(0, h) }, material = rock },
    },
    probes = { centre = at(h, h/2) },
    time = { mode = "dynamic", t_end = t_end, dt = dt, start = "settled" },
  }
  sim:run()
  local p = sim.probes.centre
  return math.sqrt(p.ux^2 + p.uy^2), sim
end

for _, case in ipairs { {25, 15}, {30, 20}, {30, 25} } do
  local alpha, phi = case[1], case[2]
  local expected = 0.5*g*(math.sin(alpha*u.deg) - math.cos(alpha*u.deg)*math.tan(phi*u.deg))*4
  for _, dt in ipairs { 1e-2, 1e-3, 1e-4 } do
    talus.check.near(string.format("incline %d/%d, dt %g", alpha, phi, dt), slide(alpha, phi, dt, 2), expected, { rel = 1e-5 })
  end
end

local _, stuck = slide(30, 31, 1e-2, 10)
local slip = 0
for _, contact in ipairs(stuck.contacts:select(function(c) return c.normal_force > 0 end)) do
  slip = math.max(slip, math.abs(contact.slip))
end
talus.check.below("30 degrees at friction 31: plastic slip in 10 s, m", slip, 1e-9)
