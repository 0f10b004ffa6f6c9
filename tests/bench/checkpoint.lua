-- What a checkpoint of 10⁴ bricks in contact costs: the least CPU time of sim:save of ten, ms.
local talus = require "talus"
local u = talus.units
local n = 100
local brick = talus.material { name = "brick", density = 2600, young = 5*u.GPa, poisson = 0.25 }
local sim = talus.simulation {
  gravity = {0, -9.81}, contact = talus.joint { name = "bed", friction = 35*u.deg },
  regions = {
    talus.region { name = "ground", outline = talus.rect(-1, -1, n + 1, 0), material = brick, held = true },
    talus.region { name = "wall", material = brick, blocks = talus.running_bond { at = {0, 0}, courses = n, per_course = n, length = 1, height = 0.5 } },
  },
  time = { start = "rest", t_end = 1, dt = 1e-5 }, output = { dir = "build/bench/checkpoint", vtk = false, picture = false },
}
sim:step()
local least = math.huge
for _ = 1, 10 do
  local before = os.clock()
  sim:save("build/bench/checkpoint/bricks.state")
  least = math.min(least, os.clock() - before)
end
sim:stop()
print(("BENCH %d %.4g"):format(#sim.blocks, 1e3*least))
