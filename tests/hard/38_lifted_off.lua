-- 38. Restitution bounds how fast blocks rebound, and holds nothing: a block that is hoisted off a floor, that topples, or whose floor is
-- pulled away does so as with restitution 1.
-- Source: Newton's second law, a = F/m - g and free fall; for toppling the same block with restitution 1, whose contacts rebound all they can.
-- Ours: contacts that had only rested might not part at all, and held what was lifted off; a floor that went down took the block with it,
-- and gave it energy that was booked as damping. (0.3 s CPU)
local talus = require "talus"
local u = talus.units
local g = 9.81
local rock = talus.material { name = "rock", density = 2500, young = 20*u.GPa, poisson = 0.2 }
local function run(e, more)
  local regions = { talus.region { name = "floor", outline = talus.rect(-3, -1, 3, 0), held = true, material = rock },
                    talus.region { name = "block", outline = talus.rect(-0.5, 0, 0.5, more.height or 1), material = rock } }
  local sim = talus.simulation { gravity = more.gravity or {0, -g}, contact = talus.joint { friction = more.friction or 0.5, restitution = e },
    regions = regions, loads = more.loads, fix = more.fix, time = { t_end = more.t_end, dt = 1*u.ms } }
  local own, most = nil, 0
  for _ in sim:steps() do
    local energy = sim.energy
    most = math.max(most, math.abs(energy.unexplained)/energy.scale)
    own = energy
  end
  return sim.blocks[2], most, own
end
for _, e in ipairs { 0, 0.5, 0.9 } do
  local label = string.format("restitution %g, ", e)
  local weight = 2500*g
  local hoisted, rest = run(e, { t_end = 0.5, loads = { talus.point_load { region = "block", at = {0, 0.9}, force = {0, { {0, 0}, {0.05, 0}, {0.05, 1.5*weight} } } } } })
  talus.check.near(label .. "hoisted by half its weight more than it: way, m", hoisted.uy, 0.5*g*0.45^2/2, { rel = 5e-3 })
  talus.check.below(label .. "hoisted: unexplained, largest, of the scale", rest, 1e-3)
  local fallen, fall_rest, energy = run(e, { t_end = 0.3, fix = { talus.fix { region = "floor", velocity = {0, { {0, 0}, {0.1, 0}, {0.1, -8}, {9, -8} } } } } })
  talus.check.near(label .. "floor pulled away: speed of the block, m/s", fallen.velocity[2], -0.2*g, { rel = 5e-3 })
  talus.check.below(label .. "floor pulled away: unexplained, largest, of the scale", fall_rest, 1e-3)
  talus.check.above(label .. "floor pulled away: damping work, J/m", energy.damping, -1e-6)
  local dip = math.rad(25)
  local plane = { height = 3, friction = 1, t_end = 1, gravity = { g*math.sin(dip), -g*math.cos(dip) } }
  local toppled, free = run(e, plane), run(1, plane)
  talus.check.near(label .. "three times as high as wide on a plane of 25 degrees: turned, rad", toppled.rotation, free.rotation, { rel = 1e-2 })
end

-- What the impulses take is never below nothing, also of blocks that ring as they fly off, whose spin goes with their strains.
for name, outline in pairs { triangle = { {-0.5, 0.002}, {0.5, 0.152}, {-0.5, 1.002} }, slab = { {-1.53, 0.704}, {1.41, 1.3}, {1.35, 1.594}, {-1.59, 0.998} } } do
  local sim = talus.simulation { contact = talus.joint { friction = 0.3, restitution = 0 }, time = { t_end = 0.25, dt = 50*u.us }, regions = {
    talus.region { name = "floor", outline = talus.rect(-50, -5, 50, 0), held = true, material = rock },
    talus.region { name = "block", outline = talus.polygon(outline), order = 2, velocity = {1, -5},
                   material = talus.material { name = "soft", density = 2500, young = 1*u.GPa, poisson = 0.2 } } } }
  local before, taken, rise, fall = sim.energy.total, 0, 0, 0
  for _ in sim:steps() do
    local energy = sim.energy
    rise, fall = math.max(rise, energy.total - before), math.max(fall, taken - energy.damping)
    before, taken = energy.total, energy.damping
  end
  talus.check.below("second-order " .. name .. " that hits, restitution 0: largest rise of the total energy in a step, of the scale", rise/sim.energy.scale, 1e-6)
  talus.check.below("second-order " .. name .. " that hits, restitution 0: energy given back by it, of the scale", fall/sim.energy.scale, 1e-12)
end
