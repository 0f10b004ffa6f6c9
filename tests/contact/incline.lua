-- A pile of bricks on an incline of 30 degrees, friction 25: it slides and its upper courses slide on the lower ones.
local talus = require "talus"
local shapes = require "shapes"
local seed = talus.param("seed", 1, "of the bricks")
local courses = talus.param("courses", 12, "layers")
local step = talus.param("step", 1, "step at which the problem is taken")
local dt = talus.param("dt", 2e-3, "s")
local a = math.rad(30)
local rock = talus.material { name = "rock", density = 2600, young = 5e9, poisson = 0.25 }
-- In the axes of the incline; gravity turns.
talus.simulation {
  gravity = { shapes.g*math.sin(a), -shapes.g*math.cos(a) }, contact = talus.joint { name = "joint", friction = math.rad(25) },
  regions = {
    talus.region { name = "incline", outline = talus.rect(-5, -1, 60, 0), material = rock, held = true },
    talus.region { name = "pile", material = rock, blocks = shapes.courses(shapes.random(seed), courses, 0.5, 1,
      function(y) return 0.4*y end, function(y) return 14 - 0.4*y end, 0.3) } },
  time = shapes.time(step, dt),
}
