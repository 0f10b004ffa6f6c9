-- The walls that a DDA program of Shi's kind was measured on: bricks of 1 x 0.5 m on a held slab, E 1 GPa, friction 30 degrees, put down
-- at rest, 50 steps of 2 ms. CPU seconds a step.
local talus = require "talus"
local u = talus.units
local nx, ny = talus.param("nx", 10, "bricks in a layer"), talus.param("ny", 10, "layers")
local brick = talus.material { name = "brick", density = 2600, young = 1*u.GPa, poisson = 0.25 }
local sim = talus.simulation {
  gravity = {0, -9.81}, contact = talus.joint { name = "bed", friction = 30*u.deg, stiffness = { per = "contact", value = 1e10 } },
  regions = {
    talus.region { name = "ground", outline = talus.rect(-1, -1, nx + 1, 0), material = brick, held = true },
    talus.region { name = "wall", material = brick,
                   blocks = talus.running_bond { at = {0, 0}, courses = ny, per_course = nx, length = 1, height = 0.5 } },
  },
  time = { mode = "dynamic", t_end = 0.1, dt = 0.002 },
}
local start = os.clock()
sim:run()
print(("BENCH %d %.6g value"):format(#sim.blocks, (os.clock() - start)/sim.totals.steps))
