-- Walls of facts § 7 (bricks 1.0 × 0.5 m on a fixed slab, ρ 2600, E 1 GPa, ν 0.25, φ 30°) at rest with Δt 2 ms: CPU per step against a
-- peer's (Shi-type DDA in C): 10×10 0.92 ms, 20×20 11.7, 25×40 56, 50×50 325, 70×70 1210; at least 20 times as fast at 1021 blocks and 60 at 4936.
-- How many factorisations the settled start takes: 20 to 70, with states found by the splitting; 260 and more without.
-- Source: measured, facts § 7. Run: scripts/run tests/hard/speed_walls.lua -p full=true      (quick: the first two)
-- Full only.
local talus = require "talus"
local tools = require "tools"
local g = tools.g
local full = talus.param("full", false, "up to 70 x 70")
local start = talus.param("start", "settled", "settled or rest")
local stone = talus.material { name = "stone", density = 2600, young = 1e9, poisson = 0.25 }
local walls = { { 10, 10, 0.92, 100, 1 }, { 20, 20, 11.7, 30, 1 }, { 25, 40, 56, 20, 20 }, { 50, 50, 325, 8, 20 }, { 70, 70, 1210, 5, 60 } }
for i = 1, full and 5 or 2 do
  local along, up, peer, steps, faster = table.unpack(walls[i])
  local sim = talus.simulation {
    gravity = {0, -g}, contact = talus.joint { name = "bed", friction = math.rad(30) },
    regions = { talus.region { name = "slab", outline = talus.rect(-1, -1, along + 2, 0), material = stone, held = true },
                talus.region { name = "wall", material = stone,
                  blocks = talus.running_bond { at = {0, 0}, courses = up, per_course = along, length = 1, height = 0.5 } } },
    time = { mode = "dynamic", t_end = 10, dt = 2e-3, start = start },
  }
  sim:step()
  talus.check.below(string.format("wall %d x %d: factorisations to the settled start", along, up), sim.totals.factorisations, 80)
  local cpu, before = os.clock(), sim.totals.iterations
  local factors, cuts = sim.totals.factorisations, sim.totals.cuts
  for _ = 1, steps do sim:step() end
  local time = 1e3*(os.clock() - cpu)/steps
  print(string.format("COST  wall %d x %d at rest  %d blocks, %.3g ms a step, %.2f iterations, %.2f factorisations, %d cuts, peer %.3g ms",
    along, up, #sim.blocks, time, (sim.totals.iterations - before)/steps, (sim.totals.factorisations - factors)/steps, sim.totals.cuts - cuts, peer))
  talus.check.below(string.format("wall %d x %d at rest: ms a step, CPU", along, up), time, peer/faster)
  sim:stop()
end
