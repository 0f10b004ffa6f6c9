-- A heap: stones fall in a column on a rough slab.
local talus = require "talus"
local shapes = require "shapes"
local seed = talus.param("seed", 7, "of the stones")
local rows = talus.param("rows", 20, "layers at the start")
local columns = talus.param("columns", 10, "stones in a layer")
local step = talus.param("step", 100, "step at which the problem is taken")
local dt = talus.param("dt", 1e-3, "s")
local rock = talus.material { name = "rock", density = 2500, young = 10e9, poisson = 0.2 }
talus.simulation {
  gravity = {0, -shapes.g}, contact = talus.joint { name = "rough", friction = math.rad(30) },
  regions = { talus.region { name = "slab", material = rock, held = true, outline = talus.rect(-20, -1, 20, 0) },
              talus.region { name = "stones", material = rock,
                             blocks = shapes.stones(shapes.random(seed), rows, columns, 0.1, 0.12, 0.01) } },
  time = shapes.time(step, dt),
}
