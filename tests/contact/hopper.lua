-- Stones fall into a funnel of 60 degrees whose outlet is too narrow for them.
local talus = require "talus"
local shapes = require "shapes"
local seed = talus.param("seed", 15, "of the stones")
local rows = talus.param("rows", 16, "layers at the start")
local columns = talus.param("columns", 16, "stones in a layer")
local step = talus.param("step", 200, "step at which the problem is taken")
local dt = talus.param("dt", 1e-3, "s")
local L = 0.1
local pitch = 1.25*L
local half, outlet = columns*pitch/2 + 0.4*L, 0.35*L
local rise = (half - outlet)*math.tan(math.rad(60))
local top = rise + rows*pitch + L
local rock = talus.material { name = "rock", density = 2500, young = 10e9, poisson = 0.2 }
talus.simulation {
  gravity = {0, -shapes.g}, contact = talus.joint { name = "rough", friction = math.rad(30) },
  regions = {
    talus.region { name = "hopper", material = rock, held = true, blocks = {
      { {-outlet, 0}, {-half, rise}, {-half, top}, {-half - L, top}, {-half - L, 0} },
      { {outlet, 0}, {half + L, 0}, {half + L, top}, {half, top}, {half, rise} } } },
    talus.region { name = "stones", material = rock, blocks = shapes.stones(shapes.random(seed), rows, columns, L, pitch, rise + 0.2*L) } },
  time = shapes.time(step, dt),
}
