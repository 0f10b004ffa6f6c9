-- Gas breaks rock round a borehole for 40 µs: the hole's volume over that at the start, less one. The run with the most blocks, or the
-- shortest steps, is what the others are compared with.
local talus = require "talus"
local u = talus.units
local size, order, dt = talus.param("size", 0.03, "edge at the hole, m"), talus.param("order", 1, "of the blocks"), talus.param("dt", 2e-6, "s")
local joint = talus.joint { name = "rock bonds", friction = 45*u.deg, cohesion = 20*u.MPa, tension = 5*u.MPa, residual = { cohesion = 0.05*u.MPa } }
local sim = talus.simulation {
  regions = { talus.region { name = "plate", outline = talus.rect(-1, -1, 1, 1), joint = joint, order = order,
                             material = talus.material { density = 2600, young = 55*u.GPa, poisson = 0.3 },
                             holes = { talus.circle { at = {0, 0}, radius = 0.1, sides = 24, name = "hole" } },
                             mesh = { size = talus.grade { { at = "hole", size = size }, far = 5*size } } } },
  boundaries = { talus.viscous { region = "plate", on = {"left", "right", "bottom", "top"} } },
  charges = { talus.charge { hole = "hole", eos = talus.eos.polytropic { pressure = 100*u.MPa, gamma = 1.4 }, gas_speed = 200 } },
  time = { t_end = 4e-5, dt_max = dt, displacement_ratio = 0.002 },
}
sim:run()
print(("BENCH %d %.9g value"):format(#sim.blocks, sim.charges[1].volume/sim.charges[1].first_volume - 1))
