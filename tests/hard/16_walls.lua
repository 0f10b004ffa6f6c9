-- 16. Running-bond walls of 10×10 and 30×30 bricks (facts, § 7: 1.0 × 0.5 m, ρ 2600, E 1 GPa, ν 0.25, φ 30°), 10 s at Δt 1, 2, 5 ms:
-- stand, row-mean σyy within 1e-4 of ρg·depth.
-- Source: equilibrium of a row. Run: scripts/run tests/hard/16_walls.lua -p full=true     (quick: 10×10, 1 s at 2 and 5 ms)
local talus = require "talus"
local tools = require "tools"
local g = tools.g
local full = talus.param("full", false, "30×30 too, 10 s")
local density, h = 2600, 0.5
local stone = talus.material { name = "stone", density = density, young = 1e9, poisson = 0.25 }
for _, n in ipairs(full and { 10, 30 } or { 10 }) do
  for _, dt in ipairs(full and { 1e-3, 2e-3, 5e-3 } or { 2e-3, 5e-3 }) do
    local sim = talus.simulation {
      gravity = {0, -g}, contact = talus.joint { name = "bed", friction = math.rad(30) },
      regions = { talus.region { name = "slab", outline = talus.rect(-1, -1, n + 2, 0), material = stone, held = true },
                  talus.region { name = "wall", material = stone,
                    blocks = talus.running_bond { at = {0, 0}, courses = n, per_course = n, length = 1, height = h } } },
      time = { mode = "dynamic", t_end = full and 10 or 1, dt = dt, start = "settled" },
    }
    local courses = {}
    for _, b in ipairs(sim.blocks:where { region = "wall" }) do courses[b.id] = math.floor(b.centroid[2]/h) + 1 end
    local seen = tools.watch(sim)
    local label = string.format("wall %d x %d, dt %g ms", n, n, dt*1e3)
    tools.cost(label, seen, #sim.blocks)
    local force, width, moved = {}, {}, 0
    for id, course in pairs(courses) do
      local b = sim.blocks[id]
      force[course], width[course] = (force[course] or 0) + b.syy*b.area, (width[course] or 0) + b.area
      moved = math.max(moved, math.abs(b.ux), math.abs(b.uy))
    end
    local off = 0
    for course = 1, n do off = math.max(off, math.abs(force[course]/width[course]/(-density*g*(n - course + 0.5)*h) - 1)) end
    talus.check.near(label .. ": time reached, s", sim.time, full and 10 or 1, { rel = 1e-9 })
    talus.check.below(label .. ": row means of syy, largest error", off, 1e-4)
    -- A wall that stands goes down by its elastic shortening, here ρgH²/2E, and sideways by less.
    talus.check.below(label .. ": largest way of a brick over the elastic one", moved/(density*g*(n*h)^2/2/1e9), 1.2)
  end
end
