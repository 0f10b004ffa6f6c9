-- Ours. Meshed bodies of breakable bonds that two plates crush in a static run, by 10 to 70 times the strain of their strength: wedges between cracks slip out at once, with turns of some hundredths.
-- What the rock gives off in such a jump was the work of the forces before and after along all of the way, and a body that turns by φ so gave off -φ²/2 Σ f·r, which its stresses do not:
-- up to 12 % of the work put in was unexplained, now at most 0.6 % in 120 random scenes of both orders.
-- Source: the ledger, each term integrated on its own; Clapeyron's theorem in the axes of each block (theory, § 12).
-- Run: scripts/run tests/hard/59_crushed.lua -p full=true    (7 scenes, a minute of CPU; otherwise 2)
local talus = require "talus"
local tools = require "tools"
local full = talus.param("full", false, "7 scenes instead of 2")

local kinds = { "triangles", "voronoi", "cross" }
local function crush(seed, order)
  local random = tools.random(991*seed + 7)
  local young = 10^(8.5 + 2*random())
  local rock = talus.material { name = "rock", density = 2500, young = young, poisson = 0.25 }
  local strength = young*10^(-4 + random())
  local bond = talus.joint { name = "bond", friction = 0.3 + 0.4*random(), tension = strength, cohesion = 2*strength, residual = { friction = 0.2 + 0.4*random() } }
  local kind = kinds[1 + math.floor(3*random())]
  local w, h = 0.5 + random(), 0.5 + random()
  local mesh = kind == "cross" and { kind = kind, nx = 3, ny = 3 } or { kind = kind, size = 0.25 + 0.1*random() }
  local press = strength/young*h*(5 + 30*random())*2
  local sim = talus.simulation { contact = talus.joint { friction = 0.4*random() },
    regions = { talus.region { name = "body", outline = talus.rect(-w/2, 0, w/2, h), mesh = mesh, order = order, material = rock, joint = bond },
                talus.region { name = "bottom", outline = talus.rect(-2, -0.5, 2, 0), material = rock, held = true },
                talus.region { name = "top", outline = talus.rect(-2, h, 2, h + 0.5), material = rock, held = true } },
    fix = { talus.fix { region = "top", displacement = { 0, { {0, 0}, {1, -press} } } } },
    time = { mode = "static", steps = 20, t_end = 1 }, output = { vtk = false, picture = false } }
  sim:run()
  local failed = #sim.joints:select(function(j) return j.state == "failed" end)
  return math.abs(sim.energy.unexplained)/sim.energy.scale, failed
end

for _, case in ipairs(full and { {47, 2}, {4, 1}, {1, 2}, {16, 2}, {42, 2}, {4, 2}, {33, 1} } or { {47, 2}, {33, 1} }) do
  local seed, order = table.unpack(case)
  local rest, failed = crush(seed, order)
  local label = ("crushed, seed %d, order %d: "):format(seed, order)
  talus.check.below(label .. "energy unexplained, of the work put in", rest, 0.01)
  talus.check.between(label .. "bonds that failed", failed, 5, 60)
end
