-- A running-bond wall that is put down at rest and stands for a second: how far a brick is from where it should be, over its height. Rigid
-- bricks on stiff contacts should not move at all.
local talus = require "talus"
local u = talus.units
local courses, dt = talus.param("courses", 10, "layers, and bricks in a layer"), talus.param("dt", 1/60, "time step, s")
local order, solver = talus.param("order", "rigid", "rigid or first"), talus.param("solver", "auto", "auto, factor or sweeps")
local sleeping = talus.param("sleeping", false, "let what rests sleep")
local brick = talus.material { name = "brick", density = 2600, young = 5*u.GPa, poisson = 0.25 }
local sim = talus.simulation {
  gravity = {0, -9.81}, contact = talus.joint { name = "bed", friction = 35*u.deg },
  regions = {
    talus.region { name = "ground", outline = talus.rect(-1, -1, courses + 1, 0), material = brick, held = true },
    talus.region { name = "wall", material = brick, order = order == "rigid" and "rigid" or 1,
                   blocks = talus.running_bond { at = {0, 0}, courses = courses, per_course = courses, length = 1, height = 0.5 } },
  },
  numerics = { solver = solver, sleeping = sleeping }, time = { mode = "dynamic", t_end = 1, dt = dt },
}
sim:run()
local most = 0
for _, v in ipairs(sim.blocks:field "u") do most = math.max(most, v) end
print(("BENCH %d %.6g"):format(#sim.blocks, most/0.5))
