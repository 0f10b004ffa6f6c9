-- Ours. Blocks that are not convex against thin tips, found by random scenes of loose L, U, V, T, C, hooks, combs and stars among needles and plates.
-- A corner of an L that presses 1e-3 of its size deep into a tip no thicker than that was let go, and nothing saw it go through: blocks in each other were looked for among convex ones.
-- An L whose sole lies in one line with the underside of a tip of less than 3° moved on through it, and now rides up on it. What flew past the outside of an arm no thicker than a quarter of its √area
-- was stopped there in the air by the arm's inner side.
-- Source: the same with the foot of the L alone, a rectangle, which is convex; a corner is judged at y and shown at X, (θ-½)Δt v farther on, and what comes by at less than a hundredth of √area is met in the step after.
-- Run: scripts/run tests/hard/57_arms.lua    (1 s CPU)
local talus = require "talus"
local check = talus.check
local quiet = { vtk = false, picture = false }

local function rock(young) return talus.material { name = "rock", density = 2500, young = young, poisson = 0.2 } end
local L = { {0, 0}, {0.8, 0}, {0.8, 0.2}, {0.2, 0.2}, {0.2, 0.8}, {0, 0.8} }
local foot = { {0, 0}, {0.8, 0}, {0.8, 0.2}, {0, 0.2} }
local function placed(outline, x, y, angle)
  local c, s, points = math.cos(angle), math.sin(angle), {}
  for k, p in ipairs(outline) do points[k] = { x + c*p[1] - s*p[2], y + s*p[1] + c*p[2] } end
  return points
end

-- Comes down at 2 m/s on a held needle of 2.3°, its corner near the needle's end. True where it has bounced.
local function dropped_on_a_tip(outline, young, from_end, angle)
  local sim = talus.simulation { contact = talus.joint { friction = 0 }, output = quiet, time = { t_end = 0.11, dt = 1e-3 },
    regions = { talus.region { name = "needle", outline = { {0, 0}, {2, -0.04}, {2, 0.04} }, material = rock(young), held = true },
                talus.region { name = "falls", outline = placed(outline, from_end, from_end*0.02 + 5e-4, angle), material = rock(young), velocity = {0, -2}, spin = 2 } } }
  sim:run()
  local p = sim.blocks[2].vertices[1]
  return p[2] > 0.02*p[1] or sim.blocks[2].velocity[2] > 0
end
for _, young in ipairs {5e7, 1e9} do
  local held = { [L] = 0, [foot] = 0 }
  for _, from_end in ipairs {0.005, 0.01, 0.02, 0.05} do
    for _, degrees in ipairs {2, 5, 10} do
      for _, outline in ipairs {L, foot} do
        if dropped_on_a_tip(outline, young, from_end, math.rad(degrees)) then held[outline] = held[outline] + 1 end
      end
    end
  end
  check.equal(string.format("dropped on a tip, %g MPa: an L held, of 12", young/1e6), held[L], 12)
  check.equal(string.format("dropped on a tip, %g MPa: its foot held, of 12", young/1e6), held[foot], 12)
end

-- Slides towards the tip, its sole in line with the tip's underside, and rides up on it.
for _, degrees in ipairs {1, 2, 2.77} do
  for _, speed in ipairs {1, 6} do
    local deepest, dt, ahead, slope = 0, 2e-3, 3e-3, math.tan(math.rad(degrees))
    local sim = talus.simulation { contact = talus.joint { friction = 0 }, output = quiet, time = { t_end = 0.1/speed, dt = dt },
      regions = { talus.region { name = "needle", outline = { {0, 0}, {2, 0}, {2, 2*slope} }, material = rock(1e10), held = true },
                  talus.region { name = "L", outline = placed({ {0, 0}, {1, 0}, {1, 0.2}, {0.3, 0.2}, {0.3, 0.8}, {0, 0.8} }, -1 - ahead, 0, 0), material = rock(1e10), velocity = {speed, 0} } } }
    for _ in sim:steps() do
      local front = sim.blocks[2].vertices[2]
      deepest = math.max(deepest, slope*front[1] - front[2])
    end
    check.below(string.format("L against a tip of %g degrees at %g m/s: deepest in it, of its way in a step", degrees, speed), deepest/(slope*dt*speed), 1.25)
  end
end

-- Flies down beside the arm of an L, 0.05 m thick.
for _, clear in ipairs {0.001, 0.01, 0.02} do
  for _, held in ipairs {true, false} do
    local sim = talus.simulation { contact = talus.joint { friction = 0 }, output = quiet, time = { t_end = 0.4, dt = 2e-3 },
      regions = { talus.region { name = "L", outline = { {0, 0}, {1, 0}, {1, 0.05}, {0.05, 0.05}, {0.05, 1}, {0, 1} }, material = rock(1e10), held = held },
                  talus.region { name = "chip", outline = { {-clear, 0.5}, {-clear, 0.8}, {-clear - 0.4, 0.8} }, material = rock(1e10), velocity = {0, -2} } } }
    sim:run()
    local v = sim.blocks[2].velocity
    check.near(string.format("beside the arm of %s L, %g m off: speed", held and "a held" or "a loose", clear), math.sqrt(v[1]^2 + v[2]^2)/2, 1, { abs = 1e-9 })
  end
end
