-- 10. Sliding across coplanar joints (hand-over from edge to edge): acceleration jump < 1 %, no snag, whatever part of the block's length a step goes.
-- From held block to held block, on the flat and down an incline. Source: Coulomb friction, v = v0 − μ g t. Ours: a corner that went more than 1 % of
-- its block's length in a step was caught by the side face of the next block: the sledge stood at dt 5 ms, and a block on an incline with automatic steps went half its way. (1 s CPU)
local talus = require "talus"
local mu, g = 0.2, 9.81
local rock = talus.material { name = "rock", density = 2500, young = 10e9, poisson = 0.2 }

-- A rectangle turned by `angle` about the origin.
local function turned(x0, y0, x1, y1, angle)
  local c, s, corners = math.cos(angle), math.sin(angle), {}
  for k, p in ipairs { {x0, y0}, {x1, y0}, {x1, y1}, {x0, y1} } do corners[k] = { c*p[1] - s*p[2], s*p[1] + c*p[2] } end
  return corners
end

-- Held blocks up to the places in `joints`.
local function floor(joints, angle)
  local blocks, from = {}, -4
  for _, to in ipairs(joints) do
    blocks[#blocks + 1] = turned(from, -1, to, 0, angle)
    from = to
  end
  return talus.region { name = "floor", blocks = blocks, material = rock, held = true }
end
local function every(pitch, first, last)
  local places = {}
  for k = 0, math.floor((last - first)/pitch) do places[k + 1] = first + pitch*k end
  places[#places + 1] = last + 10
  return places
end

for name, joints in pairs { ["one joint"] = { 1, 10 }, ["joints every 0.5 m"] = every(0.5, 0.37, 4), ["joints every 0.1 m"] = every(0.1, 1, 4) } do
  for _, dt in ipairs { 0, 1e-3, 3e-3, 5e-3, 1e-2 } do
    local sim = talus.simulation {
      gravity = {0, -g}, contact = talus.joint { name = "seat", friction = math.atan(mu) },
      regions = { floor(joints, 0), talus.region { name = "sledge", outline = talus.rect(-1, 0, 0, 0.5), material = rock, velocity = {4, 0} } },
      time = { mode = "dynamic", t_end = 1, dt = dt > 0 and dt or nil, start = "settled" },
    }
    local sledge = sim.blocks[#sim.blocks]
    local worst, before, cuts = 0, 4, 0
    for status in sim:steps() do
      local v = sledge.velocity[1]
      worst = math.max(worst, math.abs((v - before)/status.dt/(-mu*g) - 1))
      before, cuts = v, cuts + status.cuts
    end
    local label = string.format("hand-over, %s, %s: ", name, dt > 0 and dt .. " s" or "automatic")
    talus.check.below(label .. "largest jump of the deceleration, relative", worst, 0.01)
    talus.check.near(label .. "speed after 1 s, m/s", before, 4 - mu*g, { rel = 1e-6 })
    talus.check.below(label .. "way up or down, m", math.abs(sledge.uy), 1e-6)
    talus.check.equal(label .. "cuts", cuts, 0)
  end
end

-- Joints that lean, and fronts that overhang, by up to the 3 degrees within which faces count as along each other. Ours: where a corner passes the end of
-- the next block's side was asked of the foot of where it is, a step's way off it, and the side caught it (28 of 120).
for _, tangent in ipairs { -0.05, -0.02, 0.02, 0.035, 0.05 } do
  for _, of in ipairs { "joints", "front" } do
    for _, dt in ipairs { 0, 1e-3 } do
      local blocks, lean = {}, of == "joints" and tangent or 0
      for k = 0, 9 do
        local from, to = k == 0 and -4 or 0.37*k, k == 9 and 12 or 0.37*(k + 1)
        blocks[k + 1] = { {from - lean, -1}, {to - lean, -1}, {to, 0}, {from, 0} }
      end
      local over = of == "front" and 0.5*tangent or 0
      local sim = talus.simulation {
        gravity = {0, -g}, contact = talus.joint { name = "seat", friction = math.atan(mu) },
        regions = { talus.region { name = "floor", blocks = blocks, material = rock, held = true },
                    talus.region { name = "sledge", outline = { {-1, 0}, {0, 0}, {over, 0.5}, {-1 - over, 0.5} }, material = rock, velocity = {4, 0} } },
        time = { mode = "dynamic", t_end = 1, dt = dt > 0 and dt or nil, start = "settled" },
      }
      sim:run()
      talus.check.near(string.format("%s lean by %g, %s: speed after 1 s, m/s", of, tangent, dt > 0 and dt .. " s" or "automatic"),
                       sim.blocks[#sim.blocks].velocity[1], 4 - mu*g, { rel = 1e-5 })
    end
  end
end

for _, slope in ipairs { {30, 20, 1, 3}, {80, 20, 3, 2}, {30, 0, 0.3, 2} } do
  local angle, friction, pitch, t_end = math.rad(slope[1]), math.rad(slope[2]), slope[3], slope[4]
  for _, dt in ipairs { 0, 1e-3, 1e-2 } do
    local sim = talus.simulation {
      gravity = {0, -g}, contact = talus.joint { name = "seat", friction = friction },
      regions = { floor(every(pitch, -2, 30), -angle),
                  talus.region { name = "block", outline = turned(0.1, 0, 1.1, 0.5, -angle), material = rock } },
      time = { mode = "dynamic", t_end = t_end, dt = dt > 0 and dt or nil },
    }
    sim:run()
    local block = sim.blocks[#sim.blocks]
    talus.check.near(string.format("down %g degrees, friction %g, joints every %g m, %s: way over at²/2", slope[1], slope[2], pitch, dt > 0 and dt .. " s" or "automatic"),
                     math.sqrt(block.ux^2 + block.uy^2)/(g*(math.sin(angle) - math.cos(angle)*math.tan(friction))*t_end^2/2), 1, { abs = 1e-4 })
  end
end
