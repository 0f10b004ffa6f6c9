-- A crater's worth of loose triangles thrown by a blast: 15 x 5 m of rock meshed with triangles, refined round a borehole at
-- (7.5, 2); what lies in the crater is loose from the start and flies off with up to 15 m/s, away from the hole and upwards,
-- and falls into a pile. The rest is held. Neither gas nor bonds: contact alone.
-- Source: energy (nothing is put in: no step may gain 1e-6 of kinetic + stored), and the figures to be reached:
-- every step accepted, at most 5 % of the steps cut, mean step at least 2e-4 s.
-- Run: scripts/run tests/hard/crater.lua -p full=true    (quick: 0.3 s of 230 blocks; -p loose=all: nothing held)
local talus = require "talus"
local tools = require "tools"
local g = tools.g
local full = talus.param("full", false, "the whole case; otherwise a coarse mesh and a short time")
local quick = not full
local size = talus.param("size", quick and 0.9 or 0.28, "edge length of the triangles far from the hole, m")
local t_end = talus.param("t_end", quick and 0.5 or 3, "s")
local loose = talus.param("loose", "crater", "crater or all")
local speed = talus.param("speed", 15, "largest speed at the start, m/s")
local friction = talus.param("friction", 45, "degrees")
local young = 55e9
local rock = talus.material { name = "rock", density = 2600, young = young, poisson = 0.3 }
local joint = talus.joint { name = "joint", friction = math.rad(friction) }
local hole = {7.5, 2}

-- The mesh, from a simulation that takes no step.
local mesh = talus.simulation {
  regions = { talus.region { name = "rock", outline = talus.rect(0, 0, 15, 5), material = rock,
    holes = { talus.circle { at = hole, radius = 0.1, sides = 12, name = "hole" } },
    mesh = { size = talus.grade { { at = "hole", size = 0.3*size }, far = size } } } },
  time = { mode = "dynamic", t_end = 1, max_steps = 1 },
}
mesh:run()
local thrown, kept, velocities = {}, {}, {}
for _, b in ipairs(mesh.blocks) do
  local x, y = b.centroid[1] - hole[1], b.centroid[2] - hole[2]
  local outline = {}
  for i, p in ipairs(b.vertices) do outline[i] = p end
  if loose == "all" or y > -0.4 and math.abs(x) < 0.7 + 1.1*(y + 0.4) then
    thrown[#thrown + 1] = outline
    local r = math.sqrt(x*x + y*y)
    local v = (y > -0.4 and math.abs(x) < 0.7 + 1.1*(y + 0.4)) and speed*math.exp(-r/4) or 0
    velocities[#velocities + 1] = { v*x/r, v*(y + 0.4*r)/r }
  else
    kept[#kept + 1] = outline
  end
end

local regions = {
  talus.region { name = "bench", material = rock, held = true,
    blocks = { talus.rect(-60, 0, -0.001, 5), talus.rect(15.001, 0, 75, 5), talus.rect(-60, -8, 75, -0.001) } },
  talus.region { name = "thrown", blocks = thrown, material = rock },
}
if #kept > 0 then regions[3] = talus.region { name = "kept", blocks = kept, material = rock, held = true } end
local sim = talus.simulation { gravity = {0, -g}, contact = joint, regions = regions,
  time = { mode = "dynamic", t_end = t_end }, output = { every = 0.1, vtk = false, picture = "speed" } }
local first = 4
for i, v in ipairs(velocities) do sim.blocks[first - 1 + i].velocity = v end

local gain, start = tools.gains(sim), sim.energy.total
local seen = tools.watch(sim, gain)
tools.cost("crater", seen, #thrown)
talus.check.near("crater: time reached, s", sim.time, t_end, { rel = 1e-9 })
talus.check.below("crater: part of the steps that were cut", seen.cut_steps/seen.steps, 0.05)
talus.check.above("crater: mean step, s", seen.mean_dt, 2e-4)
talus.check.below("crater: largest gain of energy in a step over kinetic + stored", gain(), 1e-6)
talus.check.below("crater: energy at the end over the start", sim.energy.total/start, 1 + 1e-6)
talus.check.below("crater: deepest overlap at the end over √area", tools.overlap(sim), 0.05)
