-- A block slides down an incline of 30 degrees at a friction of 20 for 2 s, against the closed form.
local talus = require "talus"
local u = talus.units
local dt = talus.param("dt", 1e-2, "time step, s")
local order, integrator = talus.param("order", "first", "rigid or first"), talus.param("integrator", "theta", "theta or newmark")
local g, alpha, phi = 9.81, 30*u.deg, 20*u.deg
local c, s = math.cos(alpha), math.sin(alpha)
local function at(x, y) return { c*x + s*y, -s*x + c*y } end
local rock = talus.material { name = "rock", density = 2600, young = 5*u.GPa, poisson = 0.25 }
local sim = talus.simulation {
  gravity = {0, -g}, contact = talus.joint { name = "plane", friction = phi },
  regions = {
    talus.region { name = "plane", outline = { at(-2, -1), at(60, -1), at(60, 0), at(-2, 0) }, material = rock, held = true },
    talus.region { name = "block", outline = { at(0, 0), at(1, 0), at(1, 0.5), at(0, 0.5) }, material = rock,
                   order = order == "rigid" and "rigid" or 1 },
  },
  probes = { centre = at(0.5, 0.25) }, numerics = { integrator = integrator },
  time = { mode = "dynamic", t_end = 2, dt = dt, start = "settled" },
}
sim:run()
local p = sim.probes.centre
print(("BENCH %d %.6g"):format(#sim.blocks, math.abs(math.sqrt(p.ux^2 + p.uy^2)/(0.5*g*(s - c*math.tan(phi))*4) - 1)))
