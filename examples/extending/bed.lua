-- A slab on an elastic bed of 10 MPa/m: how far it settles under its weight, and how fast it swings when it is let go.
-- Run: bed bed.lua      (docs/extending.md says how it is built)
local talus = require "talus"
local rock = talus.material { density = 2500, young = 2e10, poisson = 0.2 }
local weight, k = 2500*9.81*1, 1e7  -- Pa, Pa/m

local function slab(fields)
  fields.gravity = { 0, -9.81 }
  fields.regions = { talus.region { name = "slab", outline = talus.rect(0, 0, 4, 1), material = rock, order = fields.order,
                                    mesh = fields.mesh, joint = fields.mesh and talus.joint { friction = 0.6, cohesion = 1e9, tension = 1e9 } } }
  fields.probes, fields.order, fields.mesh = { low = { 2, 0 } }, nil, nil
  return talus.simulation(fields)
end

for _, order in ipairs { "rigid", 1, 2 } do
  local sim = slab { order = order, time = { mode = "static" } }
  sim:run()
  talus.check.near(("settles, order %s"):format(order), sim.probes.low.uy, -weight/k, { rel = 2e-4 })
end
local sim = slab { mesh = { size = 0.5 }, time = { mode = "static" } }
sim:run()
talus.check.near("settles, of bonded blocks", sim.probes.low.uy, -weight/k, { rel = 1e-3 })

-- Let go at rest: uy = -(weight/k)(1 - cos ωt), ω² = k/(ρ h); half a period on it is deepest.
local omega = math.sqrt(k/2500)
sim = slab { order = "rigid", time = { mode = "dynamic", t_end = math.pi/omega, dt = 1e-4 }, numerics = { theta = 0.5 } }
sim:run()
talus.check.near("swings, after half a period", sim.probes.low.uy, -2*weight/k, { rel = 1e-4 })
talus.check.below("energy that is not explained, of the work of the weight", math.abs(sim.energy.unexplained/sim.energy.scale), 1e-6)
