-- A wall of bricks of random lengths that touch all round, gravity put on at once.
local talus = require "talus"
local shapes = require "shapes"
local seed = talus.param("seed", 1, "of the bricks")
local courses = talus.param("courses", 12, "layers, and bricks in a layer")
local step = talus.param("step", 1, "step at which the problem is taken")
local dt = talus.param("dt", 5e-3, "s")
local n = courses
local stone = talus.material { name = "stone", density = 2600, young = 1e9, poisson = 0.25 }
talus.simulation {
  gravity = {0, -shapes.g}, contact = talus.joint { name = "bed", friction = math.rad(30) },
  regions = {
    talus.region { name = "slab", outline = talus.rect(-1, -1, n + 1, 0), material = stone, held = true },
    talus.region { name = "wall", material = stone,
      blocks = shapes.courses(shapes.random(seed), n, 0.5, 1, function() return 0 end, function() return n end) } },
  time = shapes.time(step, dt),
}
