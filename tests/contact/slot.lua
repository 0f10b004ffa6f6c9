-- Bricks with slanting joints jammed in a slot that narrows downwards by 3 degrees a side; one heavy brick drives them in.
local talus = require "talus"
local shapes = require "shapes"
local seed = talus.param("seed", 1, "of the bricks")
local courses = talus.param("courses", 20, "layers")
local step = talus.param("step", 1, "step at which the problem is taken")
local dt = talus.param("dt", 2e-3, "s")
local function left(y) return -3 - y*math.tan(math.rad(3)) end
local function right(y) return -left(y) end
local h, top = 0.5, 0.5*courses
local rock = talus.material { name = "rock", density = 2600, young = 10e9, poisson = 0.2 }
local lead = talus.material { name = "heavy", density = 26e3, young = 10e9, poisson = 0.2 }
talus.simulation {
  gravity = {0, -shapes.g}, contact = talus.joint { name = "joint", friction = math.rad(25) },
  regions = {
    talus.region { name = "jaws", material = rock, held = true, blocks = {
      { {-8, 0}, {left(0), 0}, {left(top + 2), top + 2}, {-8, top + 2} },
      { {right(0), 0}, {8, 0}, {8, top + 2}, {right(top + 2), top + 2} } } },
    talus.region { name = "bricks", material = rock, blocks = shapes.courses(shapes.random(seed), courses, h, 1, left, right, 0.6) },
    talus.region { name = "weight", material = lead,
      outline = { {left(top) + 0.01, top}, {right(top) - 0.01, top}, {right(top) - 0.01, top + 1}, {left(top) + 0.01, top + 1} } } },
  time = shapes.time(step, dt),
}
