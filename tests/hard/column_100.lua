-- Column of 100 blocks, 1.0 × 0.5 m, E 55 GPa, static start: stands, top drift < 0.1 mm beyond elastic in 10 s.
-- Source: rod under its weight, ρgH²/2E, and the penalty of its joints, N h/(100 E) each. (1 s CPU)
local talus = require "talus"
local tools = require "tools"
local g = tools.g
local dt = talus.param("dt", 2e-3, "time step, s; 0: automatic")
local density, young, h, n = 2500, 55e9, 0.5, 100
local stone = talus.material { name = "stone", density = density, young = young, poisson = 0.25 }
local blocks, elastic = {}, 0
for i = 1, n do
  blocks[i] = talus.rect(0, (i - 1)*h, 1, i*h)
  local load = density*g*(n - i + 1)*h                     -- on the joint below block i
  elastic = elastic + load*math.sqrt(h)/(100*young) + density*g*(n - i + 0.5)*h*h/young
end
for _, start in ipairs { "settled", "rest" } do
  local time = { mode = "dynamic", t_end = 10, start = start }
  if dt > 0 then time.dt = dt end
  local sim = talus.simulation {
    gravity = {0, -g}, contact = talus.joint { name = "bed", friction = math.atan(0.6) },
    regions = { talus.region { name = "slab", outline = talus.rect(-2, -1, 3, 0), material = stone, held = true },
                talus.region { name = "column", blocks = blocks, material = stone } },
    time = time,
  }
  local seen = tools.watch(sim)
  tools.cost("column of 100, " .. start, seen, n)
  talus.check.near("column of 100, from " .. start .. ": time reached, s", sim.time, 10, { rel = 1e-9 })
  talus.check.below("column of 100, from " .. start .. ": drift of the top sideways, mm", 1e3*math.abs(sim.blocks[n + 1].ux), 0.1)
  talus.check.near("column of 100, from " .. start .. ": settlement of the top, mm", -1e3*sim.blocks[n + 1].uy, 1e3*elastic, { abs = 0.1 })
end
