-- A wall of bricks that begins at rest under its own weight and is pushed at the top.
-- Run: talus wall.lua                   results in out/wall: history.csv, pictures, blocks.pvd for ParaView
--      talus wall.lua -p push=60        with another value of a parameter
--      talus check wall.lua             what it would take, without running it
local talus = require "talus"
local u = talus.units  -- SI everywhere: multiply by a unit, 1*u.GPa, 30*u.deg

-- Parameters can be given on the command line with -p name=value.
local courses = talus.param("courses", 8, "courses of bricks")
local push = talus.param("push", 20, "force on the top, kN")

local length, height = 1.0, 0.5
local stone = talus.material { name = "stone", density = 2400, young = 1*u.GPa, poisson = 0.2 }

local sim = talus.simulation {
  gravity = {0, -9.81},
  contact = talus.joint { name = "bed joint", friction = 30*u.deg },  -- between regions and between bricks
  regions = {
    talus.region { name = "slab", outline = talus.rect(-1, -0.5, 7, 0), material = stone, held = true },
    talus.region { name = "wall", material = stone,  -- ready blocks instead of an outline that is cut
                   blocks = talus.running_bond { at = {0, 0}, courses = courses, per_course = 5, length = length, height = height } },
  },
  -- A force over time, as a function or a list of {t, value}.
  loads  = { talus.point_load { name = "push", region = "wall", at = {0, (courses - 0.5)*height},
                                force = { { {0, 0}, {0.1, push*u.kN} }, 0 } } },
  probes = { top = {0.01, courses*height - 0.01} },
  time   = { mode = "dynamic", t_end = 0.4, dt = 2*u.ms, start = "settled" },
  output = { dir = "out/wall", every = 0.1, picture = "syy" },
}
sim:run()

print(("the top has moved %.2f mm"):format(sim.probes.top.ux/u.mm))
