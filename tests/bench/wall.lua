-- A running-bond wall, settled and then left standing; row means of the vertical stress against rho g depth.
local talus = require "talus"
local u = talus.units
local courses = talus.param("courses", 10, "layers, and bricks in a layer")
local steps = talus.param("steps", 20, "steps after settling")
local g, h = 9.81, 0.5
local brick = talus.material { name = "brick", density = 2600, young = 5*u.GPa, poisson = 0.25 }
local sim = talus.simulation {
  gravity = {0, -g}, contact = talus.joint { name = "bed", friction = 35*u.deg },
  regions = {
    talus.region { name = "ground", outline = talus.rect(-1, -1, courses + 1, 0), material = brick, held = true },
    talus.region { name = "wall", material = brick,
                   blocks = talus.running_bond { at = {0, 0}, courses = courses, per_course = courses, length = 1, height = h } },
  },
  time = { mode = "dynamic", t_end = 0.002*steps, dt = 0.002, start = "settled" },
}
sim:run()
local sums, counts = {}, {}
for _, b in ipairs(sim.blocks:where { region = "wall" }) do
  local row = math.floor(b.centroid[2]/h) + 1
  sums[row] = (sums[row] or 0) + b.syy*b.area
  counts[row] = (counts[row] or 0) + b.area
end
local off = 0
for row = 1, courses do
  off = math.max(off, math.abs(sums[row]/counts[row]/(-2600*g*h*(courses - row + 0.5)) - 1))
end
print(string.format("BENCH | %d | %d | row means of syy %.2g, largest speed %.1g m/s", #sim.blocks, sim.totals.steps, off,
                    math.max(table.unpack(sim.blocks:field("speed")))))
