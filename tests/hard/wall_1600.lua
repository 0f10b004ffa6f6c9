-- Wall of 40 × 40 bricks, 1.0 × 0.5 m in running bond on a fixed slab, ρ 2500, μ 0.6, E 1 GPa and 30 GPa, from zero gaps with gravity put
-- on at once: after 1 s settled by the elastic shortening and at most 0.05 mm more; over 10 s nothing moves once at rest, plastic slip < 1e-9 m.
-- Source: rod under its weight, mean over the top course ρgH²/2E (half a brick less, whose middle is measured), less by 1 - ν² where the
-- bricks beside and the beds do not let a brick expand; the mean over the last fifth of the time, as the shock dies slowly at short steps.
-- Run: scripts/run tests/hard/wall_1600.lua -p full=true      (quick: 10 × 10)
local talus = require "talus"
local tools = require "tools"
local g = tools.g
local full = talus.param("full", false, "40 x 40, 1 s and 10 s; otherwise 10 x 10 and 0.2 s, 1 s")
local n = talus.param("n", full and 40 or 10, "bricks along and up")
local dt = talus.param("dt", 0, "time step, s; 0: automatic")
local long = talus.param("long", full and 10 or 1, "end of the second run, s")
local density, h = 2500, 0.5
for _, young in ipairs { 1e9, 30e9 } do
  local stone = talus.material { name = "stone", density = density, young = young, poisson = 0.25 }
  local label = string.format("wall %d x %d, E %g GPa", n, n, young/1e9)
  for _, case in ipairs { { start = "rest", t_end = full and 1 or 0.2 }, { start = "settled", t_end = long } } do
    local time = { mode = "dynamic", t_end = case.t_end, start = case.start }
    if dt > 0 then time.dt = dt end
    local sim = talus.simulation {
      gravity = {0, -g}, contact = talus.joint { name = "bed", friction = math.atan(0.6) },
      regions = { talus.region { name = "slab", outline = talus.rect(-2, -1, n + 3, 0), material = stone, held = true },
                  talus.region { name = "wall", material = stone,
                    blocks = talus.running_bond { at = {0, 0}, courses = n, per_course = n, length = 1, height = h } } },
      time = time,
    }
    local top = sim.blocks:select(function(b) return b.centroid[2] > (n - 1)*h end)
    local function settlement()
      local sum = 0
      for _, b in ipairs(top) do sum = sum - b.uy end
      return sum/#top
    end
    local H = n*h
    -- middle of the top brick: strain to its middle, and the contacts' penalty, N h/(100 E) a joint
    local elastic = density*g*(H^2 - (h/2)^2)/2/young
    local mean, weight, places = 0, 0, nil
    local seen = tools.watch(sim, function(_, status)
      if sim.time > 0.8*case.t_end then mean, weight = mean + settlement()*status.dt, weight + status.dt end
      if not places and sim.time > 0.1*case.t_end then
        places = {}
        for _, b in ipairs(sim.blocks) do places[b.id] = b.displacement end
      end
    end)
    tools.cost(label .. ", " .. case.start, seen, #sim.blocks)
    talus.check.near(label .. ", " .. case.start .. ": time reached, s", sim.time, case.t_end, { rel = 1e-9 })
    if case.start == "rest" then
      talus.check.between(label .. ": settlement after the shock, mm", 1e3*mean/weight, 1e3*elastic*(1 - 0.25^2), 1e3*elastic + 0.05)
    else
      local moved, slip = 0, 0
      for _, b in ipairs(sim.blocks) do
        local d, p = b.displacement, places and places[b.id] or {0, 0}
        moved = math.max(moved, math.abs(d[1] - p[1]), math.abs(d[2] - p[2]))
      end
      for _, s in ipairs(sim.contacts:field "slip") do slip = math.max(slip, math.abs(s)) end
      talus.check.below(label .. ", at rest: largest motion of a brick, m", moved, 1e-9)
      talus.check.below(label .. ", at rest: largest plastic slip, m", slip, 1e-9)
    end
  end
end
