-- A block of 0.2 m at 300 m/s hits a free wall of bricks.
local talus = require "talus"
local shapes = require "shapes"
local seed = talus.param("seed", 1, "of the bricks")
local courses = talus.param("courses", 14, "layers")
local step = talus.param("step", 3, "step at which the problem is taken")
local dt = talus.param("dt", 1e-5, "s")
local width, height = 1.4, 0.1*courses
local rock = talus.material { name = "rock", density = 2600, young = 55e9, poisson = 0.2 }
local y, half = 0.5*height, 0.1*math.sqrt(2)
talus.simulation {
  contact = talus.joint { name = "joint", friction = 0.5 },
  regions = {
    talus.region { name = "wall", material = rock, blocks = shapes.courses(shapes.random(seed), courses, 0.1, 0.1,
      function() return 0 end, function() return width end) },
    talus.region { name = "ball", material = rock, velocity = {300, 0},
      outline = { {-2*half - 0.001, y}, {-half - 0.001, y - half}, {-0.001, y}, {-half - 0.001, y + half} } } },
  time = shapes.time(step, dt),
}
