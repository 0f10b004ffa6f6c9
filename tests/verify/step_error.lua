-- time.tolerance: what the errors of steps add up to is what was asked for, and falls in proportion. A bar hung from a pin, let go at
-- 1 rad, against its equation of motion (physical pendulum, integrated to 1e-10 by Runge and Kutta's rule); and a pulse in a bonded
-- bar, against a run at a thirtieth of the least tolerance. Errors of velocity, as part of the fastest motion. (15 s CPU)
local talus = require "talus"
local u = talus.units
local g, amplitude, height, width, t_end = 9.81, 1.0, 1.0, 0.2, 4.0

-- Angle and spin of the pendulum at t_end, and the largest spin.
local function exact()
  local k = g*(height/2)/((width^2 + height^2)/12 + (height/2)^2)
  local angle, spin, steps = amplitude, 0, 20000
  local dt = t_end/steps
  for _ = 1, steps do
    local a1, s1 = spin, -k*math.sin(angle)
    local a2, s2 = spin + dt/2*s1, -k*math.sin(angle + dt/2*a1)
    local a3, s3 = spin + dt/2*s2, -k*math.sin(angle + dt/2*a2)
    local a4, s4 = spin + dt*s3, -k*math.sin(angle + dt*a3)
    angle, spin = angle + dt/6*(a1 + 2*a2 + 2*a3 + a4), spin + dt/6*(s1 + 2*s2 + 2*s3 + s4)
  end
  return spin, math.sqrt(2*k*(1 - math.cos(amplitude)))
end
local spin, largest = exact()

local function pendulum(tolerance, theta)
  local c, s = math.cos(amplitude), math.sin(amplitude)
  local function at(x, y) return { c*x - s*y, s*x + c*y } end
  local sim = talus.simulation {
    gravity = {0, -g},
    regions = { talus.region { name = "bar", order = "rigid", material = talus.material { density = 2500, young = 20*u.GPa, poisson = 0.2 },
                               outline = talus.polygon { at(-width/2, -height), at(width/2, -height), at(width/2, 0), at(-width/2, 0) } } },
    fix = { talus.fix { region = "bar", on = talus.point(0, 0) } }, numerics = { theta = theta },
    time = { mode = "dynamic", t_end = t_end, tolerance = tolerance, displacement_ratio = 0.1 },
  }
  sim:run()
  return math.abs(sim.blocks[1].spin - spin)/largest, sim.totals
end

for _, case in ipairs { { 0.75, 3e-2, 3e-3, 3e-4 } } do  -- at theta 0.5 a pin rings, as nothing damps it
  local theta, errors, steps = case[1], {}, {}
  for k = 2, #case do
    local error, totals = pendulum(case[k], theta)
    errors[#errors + 1], steps[#steps + 1] = error, totals.steps
    talus.check.below(("pendulum, theta %g, tolerance %g: error, of the tolerance (%d steps, %d taken again)"):format(theta, case[k], totals.steps,
      totals.cuts), error/case[k], 3)
  end
  talus.check.near(("pendulum, theta %g: power of the tolerance that the error goes with"):format(theta),
    math.log(errors[1]/errors[3])/math.log(case[2]/case[4]), 1, { abs = 0.25 })
  talus.check.near(("pendulum, theta %g: power of the tolerance that the number of steps goes with"):format(theta),
    math.log(steps[3]/steps[1])/math.log(case[2]/case[4]), 1, { abs = 0.2 })
end

-- A pulse of 2 ms runs along 2 m of 0.1 m blocks and comes back from the free end.
local function pulse(tolerance, theta)
  local h, n = 0.1, 20
  local cuts = {}
  for i = 1, n - 1 do cuts[i] = talus.trace { points = { {i*h, 0}, {i*h, h} }, bonded = true } end
  local sim = talus.simulation {
    regions = { talus.region { name = "bar", outline = talus.rect(0, 0, n*h, h), cuts = cuts,
                               material = talus.material { density = 2500, young = 10*u.GPa, poisson = 0 } } },
    fix = talus.fix { region = "bar", on = {"top", "bottom"}, y = true },
    loads = talus.edge_load { region = "bar", on = "left",
                              traction = { function(t) return t < 2*u.ms and 1e6*math.sin(math.pi*t/(2*u.ms))^2 or 0 end, 0 } },
    numerics = { theta = theta, recovery = false },
    time = { mode = "dynamic", t_end = 4*u.ms, tolerance = tolerance, displacement_ratio = 0.1 },
  }
  sim:run()
  return sim.blocks:field "velocity", sim.totals
end

local reference = pulse(3e-5, 0.5)
for _, case in ipairs { { 0.75, 1e-1, 1e-2 }, { 0.5, 1e-2, 1e-3 } } do
  local theta = case[1]
  local function off(tolerance)
    local velocities, totals = pulse(tolerance, theta)
    local difference, whole = 0, 0
    for b, v in ipairs(velocities) do
      difference, whole = difference + (v[1] - reference[b][1])^2, whole + reference[b][1]^2
    end
    return math.sqrt(difference/whole), totals
  end
  local coarse = off(case[2])
  local fine, totals = off(case[3])
  talus.check.below(("pulse, theta %g, tolerance %g: error, of the tolerance (%d steps)"):format(theta, case[3], totals.steps), fine/case[3], 3)
  talus.check.near(("pulse, theta %g: power of the tolerance that the error goes with"):format(theta),
    math.log(coarse/fine)/math.log(case[2]/case[3]), 1, { abs = 0.3 })
end
