-- Hard cases of contact: a heavy block on a light one, a corner dropped on a corner, a block dropped into a V, a leaning
-- column a little before and after its tipping point, an impact at 300 m/s, a long rest.
-- Source: equilibrium, mirror symmetry, energy, tan(lean) = width/height, conservation of momentum.
local talus = require "talus"
local g = 9.81
local function rock(density, young)
  return talus.material { name = "rock " .. density, density = density, young = young or 10e9, poisson = 0.2 }
end
local function joint(friction) return talus.joint { name = "contact", friction = friction } end
local function floor() return talus.region { name = "floor", outline = talus.rect(-2, -1, 3, 0), material = rock(2500), held = true } end

-- Mass ratio 1e6, the light block below.
local pair = talus.simulation {
  gravity = {0, -g}, contact = joint(0.5),
  regions = { floor(), talus.region { name = "light", outline = talus.rect(0, 0, 1, 1), material = rock(2.5) },
              talus.region { name = "heavy", outline = talus.rect(0, 1, 1, 2), material = rock(2.5e6) } },
  time = { mode = "dynamic", t_end = 0.5, dt = 1e-3, start = "settled" },
}
local most = 0
for status in pair:steps() do most = math.max(most, status.iterations) end
local force = 0
for _, c in ipairs(pair.contacts) do
  if c.block_i == 3 or c.block_j == 3 then force = force + c.normal_force end
end
talus.check.near("mass ratio 1e6: contact force over weight", force/(2.5e6*g), 1, { rel = 1e-6 })
talus.check.below("mass ratio 1e6: most iterations of a step", most, 6.5)

-- A square corner falls on a square corner, mirrored.
local function corners(offset)
  local s, deepest = math.sqrt(2)/2, 0
  local sim = talus.simulation {
    gravity = {0, -g}, contact = joint(0.5),
    regions = {
      talus.region { name = "anvil", outline = talus.polygon { {0, 0}, {-s, -s}, {0, -2*s}, {s, -s} }, material = rock(2500), held = true },
      talus.region { name = "hammer", outline = talus.polygon { {offset, 0.1}, {offset + s, 0.1 + s}, {offset, 0.1 + 2*s}, {offset - s, 0.1 + s} },
                     material = rock(2500) } },
    time = { mode = "dynamic", t_end = 0.6, dt = 1e-3 },
  }
  for _ in sim:steps() do
    for _, c in ipairs(sim.contacts) do deepest = math.max(deepest, -c.gap) end
  end
  return sim.blocks[2], deepest
end
for _, offset in ipairs { 1e-9, 1e-3 } do
  local right, deep = corners(offset)
  local left = corners(-offset)
  talus.check.below(string.format("corner on corner, offset %g: mirrored runs differ by, m", offset),
                    math.abs(right.ux + left.ux) + math.abs(right.uy - left.uy), 1e-10)
  talus.check.below(string.format("corner on corner, offset %g: penetration, m", offset), deep, 1e-3)
end

-- Dropped into a 60 degree V without friction.
local a = math.rad(60)
local v = talus.simulation {
  gravity = {0, -g}, contact = joint(0),
  regions = {
    talus.region { name = "v", outline = talus.polygon { {-3, -1}, {3, -1}, {3, 3*math.tan(a)}, {0, 0}, {-3, 3*math.tan(a)} },
                   material = rock(2500), held = true },
    talus.region { name = "wedge", outline = talus.polygon { {0, 0.5}, {0.8, 0.5 + 0.8*math.tan(a)}, {-0.8, 0.5 + 0.8*math.tan(a)} },
                   material = rock(2500) } },
  time = { mode = "dynamic", t_end = 3, dt = 1e-3 },
}
local fastest = 0
for _ in v:steps() do fastest = math.max(fastest, v.blocks[2].speed) end
local lift = 0
for _, c in ipairs(v.contacts) do lift = lift + c.normal_force*math.cos(a) end
talus.check.near("V of 60 degrees: reaction over weight", lift/(v.blocks[2].mass*g), 1, { rel = 1e-4 })
talus.check.below("V of 60 degrees: largest speed over that of the drop", fastest/math.sqrt(2*g*0.5), 1.01)

-- A column of 50 blocks, leaning by atan(1/50) less and more 0.5 %.
local function lean(part)
  local blocks, tilt = {}, math.atan(1/50)*part
  for i = 1, 50 do blocks[i] = talus.rect(0, i - 1, 1, i) end
  local sim = talus.simulation {
    gravity = {-g*math.sin(tilt), -g*math.cos(tilt)}, contact = joint(0.6),
    regions = { floor(), talus.region { name = "column", blocks = blocks, material = rock(2500, 55e9) } },
    time = { mode = "dynamic", t_end = 10, dt = 5e-3, start = "settled" },
  }
  sim:run()
  return -sim.blocks[51].ux/50
end
talus.check.below("column at 0.995 of its lean: top over height", lean(0.995), 1e-4)
talus.check.above("column at 1.005 of its lean: top over height", lean(1.005), 1e-2)

-- A block of 0.1 m hits a free wall of 0.1 m at 300 m/s.
for _, dt in ipairs { 1e-2, 1e-3, 1e-5 } do
  local hit = talus.simulation {
    contact = joint(0.5),
    regions = { talus.region { name = "wall", outline = talus.rect(0, -1, 0.1, 1), material = rock(2600, 55e9) },
                talus.region { name = "ball", outline = talus.rect(-0.35, -0.05, -0.25, 0.05), material = rock(2600, 55e9), velocity = {300, 0} } },
    time = { mode = "dynamic", t_end = 3e-3, dt = dt },
  }
  local most_energy = 0
  for _ in hit:steps() do
    most_energy = math.max(most_energy, hit.energy.kinetic + hit.energy.strain)
  end
  local wall, ball = hit.blocks[1], hit.blocks[2]
  local start = ball.mass*300
  talus.check.near(string.format("impact, dt %g s: momentum", dt), (wall.mass*wall.velocity[1] + ball.mass*ball.velocity[1])/start, 1, { rel = 1e-11 })
  talus.check.above(string.format("impact, dt %g s: the ball is in front, m", dt), wall.centroid[1] - ball.centroid[1], 0.09)
  talus.check.below(string.format("impact, dt %g s: largest energy over the first", dt), most_energy/(0.5*start*300), 1 + 1e-6)
end

-- Ten blocks at rest for 20 000 steps.
local stones = {}
for i = 1, 10 do stones[i] = talus.rect(0, i - 1, 1, i) end
local rest = talus.simulation {
  gravity = {0, -g}, contact = joint(0.5),
  regions = { floor(), talus.region { name = "stack", blocks = stones, material = rock(2500) } },
  time = { mode = "dynamic", t_end = 20, dt = 1e-3, start = "settled" },
}
rest:step()
local x, y = rest.blocks[11].ux, rest.blocks[11].uy
rest:run()
talus.check.below("stack at rest: drift of the top block, m", math.abs(rest.blocks[11].ux - x) + math.abs(rest.blocks[11].uy - y), 1e-9)
talus.check.below("stack at rest: kinetic energy over m g h", rest.energy.kinetic/(10*2500*g*10), 1e-10)
