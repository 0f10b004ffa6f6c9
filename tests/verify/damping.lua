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
