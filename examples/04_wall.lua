-- A running-bond wall of bricks stands under its own weight: mean stress of each course against rho g depth.
-- Run: scripts/run examples/04_wall.lua -p courses=10      (0.3 s CPU)
-- Teaches: ready blocks, the settled start, reading whole fields.
-- Picture: docs/pictures/04_wall.svg
local talus = require "talus"
local u = talus.units

local courses = talus.param("courses", 10, "courses of bricks")
local density, length, height = 2600, 1.0, 0.5
local stone = talus.material { name = "stone", density = density, young = 1*u.GPa, poisson = 0.25 }

local sim = talus.simulation {
  gravity = {0, -9.81},
  contact = talus.joint { name = "bed joint", friction = 30*u.deg },
  regions = {
    talus.region { name = "slab", outline = talus.rect(-1, -0.5, 12, 0), material = stone, held = true },
    talus.region { name = "wall", material = stone,
                   blocks = talus.running_bond { at = {0, 0}, courses = courses, per_course = 10,
                                                 length = length, height = height } },
  },
  time   = { mode = "dynamic", t_end = 0.2, dt = 2*u.ms, start = "settled" },
  output = { dir = "out/wall", every = 0.1, picture = "syy" },
}
sim:run()
-- Course by course, from the area-weighted stress of its bricks.
for course = 1, courses, math.max(1, courses // 3) do
  local force, width = 0, 0
  for _, brick in ipairs(sim.blocks:where { region = "wall" }) do
    if math.abs(brick.centroid[2] - (course - 0.5)*height) < 0.25*height then
      force = force + brick.syy*brick.area
      width = width + brick.area
    end
  end
  local depth = (courses - course + 0.5)*height
  talus.check.near("mean syy of course " .. course, force/width, -density*9.81*depth, { rel = 1e-3 })
end
talus.check.below("speed at the end", math.max(table.unpack(sim.blocks:field("speed"))), 1e-3)
