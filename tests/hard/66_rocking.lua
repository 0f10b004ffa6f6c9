-- 66. Stones without friction that rock and swing gain no energy. A pendulum on a knife edge keeps its amplitude, and its period, over 20 s; a bar on a pin; what slides, a corner first,
-- along a face that turns; boxes of stones that come to rest.
-- Source: energy (no step may gain 1e-6 of kinetic + stored); the pendulum T = 4 √(I/(m g l)) K(sin a/2), K the complete elliptic integral of the first kind, by the arithmetic-geometric mean, I about the edge;
-- a step by mean velocities is late by (ωΔt)²/24 (trapezoidal rule), of which twice is allowed.
-- Ours: energy is weighed at y = X + (θ-½)Δt v, which leaves a path that bends, and was seen to rise as that turns up: by 4e-5 to 4e-4 of it a step for pendulums and corners, by up to 2e-2 in 30 of 80 boxes.
-- Run: scripts/run tests/hard/66_rocking.lua -p full=true    (40 boxes and corners; otherwise 8)
local talus = require "talus"
local tools = require "tools"
local full = talus.param("full", false, "40 boxes and corners instead of 8")
local smooth = talus.joint { name = "smooth", friction = 0 }
local rock = talus.material { name = "rock", density = 2500, young = 10e9, poisson = 0.2 }
local no_files = { vtk = false, picture = false }

local function gain_of(sim)
  local gains, most = tools.gains(sim), 0
  for _ in sim:steps() do most = gains() end
  return most
end

-- A yoke hangs by its notch on the tip of a held post.
local function pendulum(amplitude, dt)
  local c, s = math.cos(amplitude), math.sin(amplitude)
  local drawn = { {-1.1, -2}, {-0.8, -2}, {-0.8, -0.6}, {0, 0}, {0.8, -0.6}, {0.8, -2}, {1.1, -2}, {1.1, 0.3}, {-1.1, 0.3} }
  local corners = {}
  for i, p in ipairs(drawn) do corners[i] = { c*p[1] - s*p[2], s*p[1] + c*p[2] } end
  local sim = talus.simulation { gravity = {0, -tools.g}, contact = smooth, output = no_files, time = { t_end = 20, dt = dt },
    regions = { talus.region { name = "post", outline = { {-0.02, -1.5}, {0.02, -1.5}, {0, 0} }, held = true, material = rock },
                talus.region { name = "yoke", outline = corners, material = rock } } }
  return sim, drawn
end

-- Area, height of the centroid and polar moment about the origin.
local function moments(corners)
  local area, height, polar = 0, 0, 0
  for i, p in ipairs(corners) do
    local q = corners[i % #corners + 1]
    local twice = p[1]*q[2] - q[1]*p[2]
    area = area + twice/2
    height = height + twice*(p[2] + q[2])/6
    polar = polar + twice*(p[1]^2 + p[1]*q[1] + q[1]^2 + p[2]^2 + p[2]*q[2] + q[2]^2)/12
  end
  return area, height/area, polar
end

local amplitude = math.rad(20)
for _, dt in ipairs { 0.005, 0.01 } do
  local sim, drawn = pendulum(amplitude, dt)
  local yoke, gains, most, highest = sim.blocks[2], tools.gains(sim), 0, 0
  local crossings, last, before = {}, amplitude, 0
  for _ in sim:steps() do
    most = gains()
    local angle = amplitude + yoke.rotation
    if angle*last < 0 then crossings[#crossings + 1] = before + (sim.time - before)*last/(last - angle) end
    if sim.time > 15 then highest = math.max(highest, math.abs(angle)) end
    last, before = angle, sim.time
  end
  local area, height, polar = moments(drawn)
  local a, g = 1, math.cos(amplitude/2)
  for _ = 1, 8 do a, g = (a + g)/2, math.sqrt(a*g) end
  local period = 2*math.pi/a*math.sqrt(polar/(area*tools.g*-height))
  local swings = (#crossings - 1)/2
  local label = string.format("pendulum, steps of %g s: ", dt)
  talus.check.below(label .. "most that a step gains, of kinetic and stored", most, 1e-6)
  talus.check.near(label .. "amplitude after 15 s, rad", highest, amplitude, { rel = 1e-4 })
  talus.check.near(label .. "period, s", (crossings[#crossings] - crossings[1])/swings, period, { rel = (2*math.pi/period*dt)^2/12 })
end

-- A bar swings on a pin from level: gravity's work ρ A g times the fall of its middle is kinetic energy.
for _, way in ipairs { { "one block", 1 }, { "one block of second order", 2 }, { "bonded blocks", 1, { size = 0.4 } } } do
  local label, order, mesh = table.unpack(way)
  local sim = talus.simulation { gravity = {0, -tools.g}, output = no_files, time = { t_end = 2, dt = 0.005 },
    regions = { talus.region { name = "bar", outline = talus.rect(0, -0.1, 2, 0.1), material = rock, order = order, mesh = mesh } },
    fix = { talus.fix { region = "bar", on = talus.point(0, 0) } } }
  talus.check.below("bar on a pin, " .. label .. ": most that a step gains, of kinetic and stored", gain_of(sim), 1e-6)
  local fall = 0
  for _, b in ipairs(sim.blocks) do fall = fall - b.area*b.uy end
  talus.check.near("bar on a pin, " .. label .. ": kinetic energy over the work of gravity", sim.energy.kinetic/(2500*tools.g*fall), 1, { abs = 1e-4 })
end

-- A stone that spins comes down with a corner on a free block, and slides off it.
local function corner(seed, dt)
  local random = tools.random(3331*seed)
  for _ = 1, 9 do random() end
  local stone = tools.stone(random, { 0.45 + 0.2*random(), 1.35 }, 0.9, 4 + math.floor(4*random()), 0.6)
  return talus.simulation { gravity = {0, -tools.g}, contact = smooth, output = no_files, time = { t_end = 0.6, dt = dt },
    regions = { talus.region { name = "floor", outline = talus.rect(-6, -1, 6, 0), held = true, material = rock },
                talus.region { name = "block", outline = talus.rect(-0.5, 0, 0.5, 0.8), material = rock },
                talus.region { name = "stone", outline = talus.polygon(stone), material = rock, spin = -(2 + 6*random()) } } }
end

local function box(seed)
  local random = tools.random(7411*seed)
  for _ = 1, 9 do random() end
  local half = 2.4
  local regions = { talus.region { name = "box", held = true, material = rock,
    blocks = { talus.rect(-half - 1, -1, half + 1, 0), talus.rect(-half - 1, 0, -half, 9), talus.rect(half, 0, half + 1, 9) } } }
  for k = 0, 17 do
    local at = { -1.8 + 0.9*(k % 5) + 0.05*random(), 0.6 + 0.95*(k//5) }
    regions[#regions + 1] = talus.region { outline = talus.polygon(tools.stone(random, at, 0.85, 3 + math.floor(5*random()), 0.5 + 0.5*random())), material = rock }
  end
  return talus.simulation { gravity = {0, -tools.g}, contact = smooth, regions = regions, output = no_files, time = { t_end = 3 } }
end

local corners, corners_given, boxes = 0, 0, 0
for seed = 1, full and 40 or 8 do
  corners = math.max(corners, gain_of(corner(seed)))
  corners_given = math.max(corners_given, gain_of(corner(seed, 0.002)))
  boxes = math.max(boxes, gain_of(box(seed)))
end
talus.check.below("corners that slide along what turns: most that a step gains", corners, 1e-6)
talus.check.below("the same in steps of 2 ms", corners_given, 1e-6)
talus.check.below("boxes of stones: most that a step gains", boxes, 1e-6)
