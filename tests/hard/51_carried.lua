-- 51. What is carried by something that moves is at rest on it, however steps change: on a floor that gets faster along or downwards, on a lift at a steady
-- speed, on a meshed base whose edge is driven, and two blocks that press on each other and drift. And what begins with the floor's speed stays with it.
-- Source: mechanics is the same in a frame that moves steadily, and in one that gets faster weight is m (g + a) (Galileo; d'Alembert). A driven edge puts in the
-- momentum of what it drives. Ours: a change of the step moved what lies by (θ − ½) of the change times its own velocity, where what it lay on stayed: 2 mm ahead
-- of a floor with 0.05 m/s2, 1 mm above one that sank, N from 0 to 11 times the weight on a lift, with no slip, no friction, and nothing of it in the ledger. The
-- contacts of the first step took the floor for one that had just started, and threw ahead what moved with it. And supports began with the way that a driven
-- edge has ahead of it as a gap: reactions of 3e6 times the force, and a scale of the ledger of 1.5 MJ for 446 J; and an edge that jumped to 1 m/s
-- threw its block at 5.6 m/s, or at 461 m/s where steps were cut. A roller was ground in its free direction too. (2 s CPU)
local talus = require "talus"
local g = 9.81
local rock = talus.material { name = "rock", density = 2500, young = 20e9, poisson = 0.2 }
local joint = talus.joint { name = "rough", friction = math.atan(0.6) }

-- A floor of velocities vx, vy (numbers or tables) with a block of 1 m2 on it that begins with `velocity`.
local function carried(vx, vy, velocity, time, every)
  time.start = "settled"
  return talus.simulation { gravity = {0, -g}, contact = joint,
    regions = { talus.region { name = "floor", outline = talus.rect(-20, -1, 20, 0), held = true, material = rock },
                talus.region { name = "block", outline = talus.rect(-1, 0, 1, 0.5), material = rock, velocity = velocity } },
    fix = { talus.fix { region = "floor", velocity = {vx, vy} } }, time = time,
    output = every and { every = every, vtk = false, picture = false } or nil }
end
-- Farthest off, m, along and across; how far the normal force is from `weight`, as part of it; what friction has taken, J.
local function follow(sim, weight)
  local along, across, pressed = 0, 0, 0
  local floor, block = sim.blocks[1], sim.blocks[2]
  for _ in sim:steps() do
    local n = 0
    for _, c in ipairs(sim.contacts) do n = n + c.normal_force end
    along, across = math.max(along, math.abs(block.ux - floor.ux)), math.max(across, math.abs(block.uy - floor.uy))
    pressed = math.max(pressed, math.abs(n/weight - 1))
  end
  return along, across, pressed
end
local mass = 2500
for name, a in pairs { ["along, 0.05 m/s2"] = {0.05, 0}, ["downwards, 0.05 m/s2"] = {0, -0.05}, ["downwards, 0.5 m/s2"] = {0, -0.5} } do
  local function ramp(rate) return rate ~= 0 and { {0, 0}, {10, 10*rate} } or 0 end
  local sim = carried(ramp(a[1]), ramp(a[2]), {0, 0}, { t_end = 10 })
  local along, across, pressed = follow(sim, mass*(g + a[2]))
  talus.check.below("floor that gets faster " .. name .. ": block off along it, m", along, 1e-8)
  talus.check.below("floor that gets faster " .. name .. ": block off across, m", across, 1e-7)  -- of 0.9e-7, its weight in the springs
  talus.check.below("floor that gets faster " .. name .. ": normal force off m (g + a)", pressed, 1e-3)
end
for _, speed in ipairs { 1, -1, -5, 5 } do
  local _, across, pressed = follow(carried(0, speed, {0, speed}, { t_end = 1 }, 0.0137), mass*g)
  talus.check.below(string.format("lift at %g m/s: block off it, m", speed), across, 1e-7)
  talus.check.below(string.format("lift at %g m/s: normal force off the weight", speed), pressed, 1e-6)
end
for _, dt in ipairs { 2e-3, 2e-2 } do
  local sim = carried(1, 0, {1, 0}, { t_end = 1, dt = dt })
  talus.check.below(string.format("begun with the floor at 1 m/s, dt %g s: block off it, m", dt), (follow(sim, mass*g)), 1e-12)
  talus.check.below(string.format("begun with the floor at 1 m/s, dt %g s: taken by friction, J", dt), sim.energy.friction, 1e-9)
end

local v = 0.02
local pair = talus.simulation { contact = joint, time = { t_end = 4 }, regions = {
  talus.region { name = "left", outline = talus.rect(-1, 0, 0, 1), material = rock, velocity = {v, 0}, body_force = {2e4, 0} },
  talus.region { name = "right", outline = talus.rect(0, 0, 1, 1), material = rock, velocity = {v, 0}, body_force = {-2e4, 0} } } }
local off = 0
for step in pair:steps() do off = math.max(off, math.abs((pair.blocks[1].ux + pair.blocks[2].ux)/2 - v*step.time)) end
talus.check.below("two blocks that press and drift: centroid off v t, m", off, 1e-12)

-- A block, bonded or whole, whose lower edge is driven along x at A t: ∫ R dt = M v.
for name, mesh in pairs { whole = false, meshed = { size = 0.5 } } do
  local sim = talus.simulation { time = { t_end = 2 },
    regions = { talus.region { name = "block", outline = talus.rect(0, 0, 2, 1), material = rock, mesh = mesh or nil, joint = joint } },
    fix = { talus.fix { name = "drive", region = "block", on = "bottom", velocity = { { {0, 0}, {2, 0.6} }, 0 } } } }
  local impulse = 0
  for step in sim:steps() do impulse = impulse + step.dt*sim.reactions.drive[1] end
  talus.check.near("driven edge, " .. name .. ": impulse of the reaction over momentum", impulse/(5000*0.6), 1, { rel = 1e-3 })
  talus.check.below("driven edge, " .. name .. ": scale of the ledger over kinetic energy", sim.energy.scale/sim.energy.kinetic, 1.02)
end

-- An edge that jumps to 1 m/s, at once or in 1 ms, may give what it drives twice that in the first step at most, and does work M v² in all, of which the
-- hit takes half. Source: momentum, and energy in the frame of the edge.
local jumps = { ["from the start"] = 1, ["in 1 ms, from the start"] = { {0, 0}, {1e-3, 1}, {1, 1} }, ["in 1 ms at 0.2 s"] = { {0, 0}, {0.2, 0}, {0.201, 1}, {1, 1} } }
for name, velocity in pairs(jumps) do
  for shape, mesh in pairs { whole = false, meshed = { size = 0.5 } } do
    local sim = talus.simulation { time = { t_end = 0.5 },
      regions = { talus.region { name = "block", outline = talus.rect(0, 0, 2, 1), material = rock, mesh = mesh or nil, joint = joint } },
      fix = { talus.fix { region = "block", on = "bottom", velocity = {velocity, 0} } } }
    local fastest = 0
    for _ in sim:steps() do
      for _, b in ipairs(sim.blocks) do fastest = math.max(fastest, b.speed) end
    end
    local e, label = sim.energy, ("edge that jumps to 1 m/s %s, %s: "):format(name, shape)
    talus.check.below(label .. "fastest block, m/s", fastest, 2)
    talus.check.near(label .. "kinetic energy, of M v2/2", e.kinetic/2500, 1, { rel = 1e-3 })
    talus.check.below(label .. "scale of the ledger over kinetic energy", e.scale/e.kinetic, 4)
  end
end

for name, mesh in pairs { whole = false, meshed = { size = 0.5 } } do
  local sim = talus.simulation { time = { t_end = 1 }, output = { every = 0.0137, vtk = false, picture = false },
    regions = { talus.region { name = "block", outline = talus.rect(0, 0, 2, 1), material = rock, mesh = mesh or nil, joint = joint, velocity = {1, 0} } },
    fix = { talus.fix { region = "block", on = "bottom", y = true } } }
  local off = 0
  for step in sim:steps() do off = math.max(off, math.abs(sim.blocks[1].ux - step.time)) end
  talus.check.below("on rollers at 1 m/s, " .. name .. ": off v t, m", off, 1e-12)
end

-- A step much shorter than the one before, which a row of some table asks for: what is driven smoothly goes on as before. Source: M v²/2 of the edge's
-- velocity. Ours: X moved back by what the look-ahead of a driven edge lost, and was caught up with within the short step: 17 m/s for 1, 462 m/s for 3.
local function shaken(order, mesh, theta, drive)
  local rows = { {0, 0} }
  for i = 1, 8 do rows[#rows + 1] = {i*0.1037, i - 1}; rows[#rows + 1] = {i*0.1037 + 1e-5, i} end
  local fix = {}
  for i, on in ipairs(drive == "points" and { talus.point(0, 0), talus.point(2, 0) } or { "bottom" }) do
    fix[i] = talus.fix { region = "block", on = on, velocity = { function(t) return math.sin(2*math.pi*t) end, 0 } }
  end
  return talus.simulation { regions = { talus.region { name = "block", outline = talus.rect(0, 0, 2, 1), material = rock, order = order, mesh = mesh, joint = joint } }, fix = fix,
    loads = { talus.point_load { at = {1, 0.5}, force = {0, rows} } }, numerics = { theta = theta }, time = { t_end = 1, dt_max = 5e-3 } }
end
for _, case in ipairs { {"rigid"}, {1}, {2}, {1, { size = 0.5 }}, {1, nil, 0.5}, {1, nil, 1}, {"rigid", nil, nil, "points"} } do
  local order, mesh, theta, drive = case[1], case[2], case[3], case[4]
  local sim, fastest = shaken(order, mesh, theta, drive), 0
  for _ in sim:steps() do
    for _, b in ipairs(sim.blocks) do fastest = math.max(fastest, b.speed) end
  end
  local label = ("shaken by 1 m/s%s%s, order %s%s: "):format(drive and " at points" or "", mesh and ", meshed" or "", order, theta and ", theta " .. theta or "")
  talus.check.near(label .. "fastest block, m/s", fastest, 1, { rel = 5e-3 })
  talus.check.below(label .. "unexplained", math.abs(sim.energy.unexplained)/sim.energy.scale, 1e-6)
end

-- A displacement that jumps, from the start on or in 0.1 ms as a step of 10 ms begins, does the work that it gives: R over its way.
for name, displacement in pairs { ["from the start"] = 1e-3, ["at 0.3 s"] = { {0, 0}, {0.3, 0}, {0.3001, 1e-3}, {1, 1e-3} } } do
  local sim = talus.simulation { time = { t_end = 1, dt = 0.01 }, regions = { talus.region { name = "block", outline = talus.rect(0, 0, 2, 1), material = rock } },
    fix = { talus.fix { region = "block", on = "bottom", displacement = {displacement, 0} } } }
  local most = 0
  for _ in sim:steps() do most = math.max(most, sim.energy.kinetic) end
  talus.check.above("edge put 1 mm aside " .. name .. ": work over the most kinetic energy", sim.energy.boundary/most, 1)
  talus.check.below("edge put 1 mm aside " .. name .. ": unexplained", math.abs(sim.energy.unexplained)/sim.energy.scale, 1e-6)
end
