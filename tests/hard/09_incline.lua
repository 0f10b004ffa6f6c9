-- 9. φ = α(1 + 1e-6): slip < 1e-6 L in 1e4 steps. φ = α(1 − 1e-3): acceleration within 1 % of the formula. Incline of 30°,
-- φ = 10…29°, Δt 1e-2…1e-4, from a settled start: error < 1e-5 at every Δt.
-- Source: s = ½g(sin α − cos α tan φ)t² (Coulomb sliding).
-- Run: scripts/run tests/hard/09_incline.lua -p full=true      (quick: friction in steps of 4.75 degrees)
local talus = require "talus"
local full = talus.param("full", false, "friction in steps of 1 degree")
local g, L = 9.81, 1
local function slide(alpha, phi, time)
  local h = 0.5
  local c, s = math.cos(alpha), math.sin(alpha)
  local function at(x, y) return {c*x + s*y, -s*x + c*y} end   -- downhill along +x
  local rock = talus.material { name = "rock", density = 2600, young = 5e9, poisson = 0.25 }
  local sim = talus.simulation {
    gravity = {0, -g}, contact = talus.joint { name = "plane", friction = phi },
    regions = {
      talus.region { name = "plane", outline = { at(-2, -1), at(60, -1), at(60, 0), at(-2, 0) }, material = rock, held = true },
      talus.region { name = "block", outline = { at(0, 0), at(L, 0), at(L, h), at(0, h) }, material = rock } },
    probes = { centre = at(L/2, h/2) }, time = time,
  }
  sim:run()
  local p = sim.probes.centre
  return p.ux*c - p.uy*s, sim
end
local alpha = math.rad(30)
local function slope(phi) return g*(math.sin(alpha) - math.cos(alpha)*math.tan(phi)) end
local still = slide(alpha, alpha*(1 + 1e-6), { mode = "dynamic", t_end = 10, dt = 1e-3, start = "settled" })
talus.check.below("friction at 1 + 1e-6 of the slope: way in 1e4 steps, m", math.abs(still), 1e-6*L)
local t = 10
local way = slide(alpha, alpha*(1 - 1e-3), { mode = "dynamic", t_end = t, dt = 1e-3, start = "settled" })
talus.check.near("friction at 1 - 1e-3 of the slope: acceleration, m/s2", 2*way/t^2, slope(alpha*(1 - 1e-3)), { rel = 0.01 })
local t_end = 2
for _, dt in ipairs { 1e-2, 1e-3, 1e-4 } do
  local worst = 0
  for degrees = 10, 29, full and 1 or 4.75 do
    local expected = 0.5*slope(math.rad(degrees))*t_end^2
    local off = math.abs(slide(alpha, math.rad(degrees), { mode = "dynamic", t_end = t_end, dt = dt, start = "settled" })/expected - 1)
    worst = math.max(worst, off)
  end
  talus.check.below(string.format("incline 30 degrees, friction 10 to 29, dt %g s: largest error", dt), worst, 1e-5)
end

-- Another slope, and one that holds: 25 degrees at 15, 30 at 31.
local other, limit = math.rad(25), math.rad(15)
talus.check.near("incline 25 degrees, friction 15, dt 0.01 s: way in 2 s, m", slide(other, limit, { mode = "dynamic", t_end = 2, dt = 1e-2, start = "settled" }),
                 0.5*g*(math.sin(other) - math.cos(other)*math.tan(limit))*4, { rel = 1e-5 })
local _, stuck = slide(alpha, math.rad(31), { mode = "dynamic", t_end = 10, dt = 1e-2, start = "settled" })
local slip = 0
for _, contact in ipairs(stuck.contacts:select(function(c) return c.normal_force > 0 end)) do slip = math.max(slip, math.abs(contact.slip)) end
talus.check.below("incline 30 degrees, friction 31: plastic slip in 10 s, m", slip, 1e-9)
