-- Gas opens three cracks on given paths round a borehole, for 100 µs: the growth of its volume, cracks included, at ten times. The rock
-- between is elastic and the paths take G_I, so that what comes out depends on no mesh but by its error.
local talus = require "talus"
local u = talus.units
local size, order, dt = talus.param("size", 0.03, "edge at the hole, m"), talus.param("order", 1, "of the blocks"), talus.param("dt", 2e-6, "s")
local path = talus.joint { name = "path", friction = 45*u.deg, cohesion = 20*u.MPa, tension = 5*u.MPa,
                           reduction = talus.laws.softening { G_I = 200, residual = { cohesion = 0 } } }
local cuts = {}
for k = 1, 3 do
  local angle = (k/3 + 1/4)*2*math.pi
  cuts[k] = talus.trace { points = { {0, 0}, {0.5*math.cos(angle), 0.5*math.sin(angle)} }, bonded = true, joint = path }
end
local sim = talus.simulation {
  regions = { talus.region { name = "plate", outline = talus.rect(-1, -1, 1, 1), order = order, cuts = cuts,
                             material = talus.material { density = 2600, young = 55*u.GPa, poisson = 0.3 },
                             holes = { talus.circle { at = {0, 0}, radius = 0.1, sides = 24, name = "hole" } },
                             mesh = { size = talus.grade { { at = "hole", size = size }, far = 5*size } } } },
  boundaries = { talus.viscous { region = "plate", on = {"left", "right", "bottom", "top"} } },
  charges = { talus.charge { hole = "hole", eos = talus.eos.polytropic { pressure = 50*u.MPa, gamma = 1.4 }, gas_speed = 2000 } },
  time = { t_end = 1e-4, dt = dt },
}
local growth = {}
for _ in sim:steps() do
  local charge = sim.charges[1]
  if sim.time > (#growth + 1 - 1e-6)*1e-5 then growth[#growth + 1] = ("%.9g"):format(charge.volume/charge.first_volume - 1) end
end
print(("BENCH %d {%s} value"):format(#sim.blocks, table.concat(growth, ",")))
