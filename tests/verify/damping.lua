-- Damping laws: k(|v|, dt) of its velocity is left to a block after each step. In free flight against the closed form; the energy
-- taken stands in the ledger, contacts and both integrators included.
-- Source: v = v0 exp(-rate t); dv/dt = -b v^2 gives v = v0/(1 + b v0 t); energy taken is what is missing.
local talus = require "talus"
local u = talus.units
local rock = talus.material { name = "rock", density = 2500, young = 1*u.GPa, poisson = 0.2 }

local function fly(damping, integrator, dt)
  local sim = talus.simulation {
    regions = { talus.region { name = "block", outline = talus.rect(0, 0, 1, 1), material = rock, velocity = {3, 4}, spin = 0.1 } },
    time = { mode = "dynamic", t_end = 1, dt = dt, displacement_ratio = 0.1 },
    numerics = { damping = damping, integrator = integrator },
  }
  local start = sim.energy.kinetic
  sim:run()
  local v = sim.blocks[1].velocity
  return math.sqrt(v[1]^2 + v[2]^2), sim, start
end

for _, integrator in ipairs { "theta", "newmark" } do
  for _, dt in ipairs { 1e-3, 1e-2 } do
    local name = ("%s, dt %g: "):format(integrator, dt)
    local speed, sim, start = fly(talus.damping.velocity { rate = 2 }, integrator, dt)
    talus.check.near(name .. "speed after 1 s, m/s", speed, 5*math.exp(-2), { rel = 1e-9 })
    talus.check.near(name .. "energy taken", sim.energy.damping/start, 1 - math.exp(-4), { rel = 1e-6 })
    talus.check.below(name .. "unexplained energy", math.abs(sim.energy.unexplained)/sim.energy.scale, 1e-6)
  end
end
local speed = fly(function(v, dt) return 1/(1 + 0.4*v*dt) end, "theta", 1e-2)
talus.check.near("drag with the square of speed: speed after 1 s, m/s", speed, 5/(1 + 0.4*5), { rel = 1e-9 })

-- A stack dropped on a floor.
local regions = { talus.region { name = "floor", outline = talus.rect(-5, -1, 5, 0), material = rock, held = true } }
for i = 1, 4 do
  regions[#regions + 1] = talus.region { name = "block " .. i, material = rock,
    outline = talus.rect(0.05*(i % 2), 1.05*(i - 1) + 0.05, 0.05*(i % 2) + 1, 1.05*i) }
end
local stack = talus.simulation { gravity = {0, -9.81}, regions = regions, numerics = { damping = talus.damping.velocity { rate = 5 } },
                                 time = { mode = "dynamic", t_end = 1, dt = 1e-3 } }
stack:run()
talus.check.above("stack: taken by damping, of the work of gravity", -stack.energy.damping/stack.energy.gravity, 0.05)
talus.check.below("stack: unexplained energy", math.abs(stack.energy.unexplained)/stack.energy.scale, 1e-3)

-- Restitution: what met at v parts at e v where the step alone would leave more (0.67 of v for this block at 0.1 ms, 0.2 at 5 ms), and the
-- energy is damping. On a held floor, on a corner, of second order; two free blocks keep their momentum.
local function impact(e, dt, shape)
  local joint = talus.joint { friction = 0, restitution = e }
  local outline = shape == "corner" and { {0, 0}, {0.7, 0.7}, {0, 1.4}, {-0.7, 0.7} } or talus.rect(-0.5, 0, 0.5, 1)
  local sim = talus.simulation {
    contact = joint,
    regions = { talus.region { name = "lower", outline = talus.rect(-1, -1, 1, -0.01), material = rock, held = shape ~= "free" },
                talus.region { name = "upper", outline = outline, material = rock, velocity = {0, -2}, order = shape == "order 2" and 2 or 1 } },
    time = { mode = "dynamic", t_end = 0.1, dt = dt, displacement_ratio = 0.1 },
  }
  local kinetic = sim.energy.kinetic
  sim:run()
  local below, above = sim.blocks[1], sim.blocks[2]
  return (above.velocity[2] - below.velocity[2])/2, sim, kinetic, above.mass*above.velocity[2] + below.mass*below.velocity[2] + 2*above.mass
end

for _, shape in ipairs { "face", "corner", "order 2", "free" } do
  for _, e in ipairs { 0, 0.2, 0.6 } do
    local part, sim, kinetic, momentum = impact(e, 1e-4, shape)
    local name = ("restitution %g, %s: "):format(e, shape)
    talus.check.near(name .. "parts at, of the speed before", part, e, { abs = 1e-6 })
    talus.check.above(name .. "taken by damping, of the kinetic energy", sim.energy.damping/kinetic, 0.01)
    talus.check.below(name .. "unexplained energy, of it", math.abs(sim.energy.unexplained)/kinetic, 1e-6)
    if shape == "free" then talus.check.below(name .. "momentum, of that before", math.abs(momentum)/(2*sim.blocks[2].mass), 1e-12) end
  end
end
local left = impact(1, 5e-3, "face")
talus.check.near("restitution 0.6, steps of 5 ms: as the step leaves it", impact(0.6, 5e-3, "face"), left, { abs = 1e-12 })
talus.check.near("restitution 0.1, steps of 5 ms: parts at, of the speed before", impact(0.1, 5e-3, "face"), 0.1, { abs = 1e-6 })

-- A ball that bounces: the height after the first bounce is e² of that before.
local ball = talus.simulation { gravity = {0, -9.81}, contact = talus.joint { friction = 0, restitution = 0.5 },
  regions = { talus.region { name = "floor", outline = talus.rect(-1, -1, 1, 0), material = rock, held = true },
              talus.region { name = "ball", outline = talus.rect(-0.5, 0.5, 0.5, 1.5), material = rock } },
  time = { mode = "dynamic", t_end = 0.65, dt = 1e-4 } }
local hit, apex = false, 0
for _ in ball:steps() do
  hit = hit or ball.blocks[2].velocity[2] > 0
  if hit then apex = math.max(apex, ball.blocks[2].centroid[2] - 0.5) end
end
talus.check.near("bouncing: height after the first bounce, m", apex, 0.125, { rel = 5e-3 })  -- two steps at 3.1 m/s, of its height

-- In the very step in which one block strikes another falls asleep, which puts the contacts in another order: the same to the bit.
local function strike(sleeping)
  local sim = talus.simulation { contact = talus.joint { friction = 0, restitution = 0.5 },
    regions = { talus.region { name = "floor", outline = talus.rect(-1, -1, 5, 0), material = rock, held = true },
                talus.region { name = "striking", outline = talus.rect(-0.5, 1e-5, 0.5, 1), material = rock, velocity = {0, -2} },
                talus.region { name = "at rest", outline = talus.rect(3, 0, 4, 1), material = rock } },
    time = { mode = "dynamic", t_end = 0.05, dt = 1e-4 }, numerics = { sleeping = sleeping } }
  sim:step()
  sim:step()  -- what sleeps is counted from the step after
  local asleep = sim.totals.islands.asleep
  sim:run()
  return sim.blocks[2].velocity[2], asleep
end
local awake, beside, asleep = strike(false), strike(true)
talus.check.near("restitution beside what stays awake: parts at, of the speed before", awake/2, 0.5, { abs = 1e-6 })
talus.check.equal("restitution beside what falls asleep: parts at, m/s", beside, awake)
talus.check.equal("restitution: asleep after the step of the blow", asleep, 1)
