-- A hole under explosion gas: first in rock that breaks; then in rock that does not, against Lamé's solution.
-- Run: scripts/run examples/10_borehole.lua                    (3 s CPU; pictures in out/borehole)
--      scripts/run examples/10_borehole.lua -p t_end=1e-3      longer cracks (12 s)
-- Teaches: talus.charge, equations of state, viscous boundaries, sim.charges, on_gas, what gas, cracks and boundary take.
-- Source: Lamé: u = P a (1 + ν)/E at the wall of a hole of radius a in an infinite plate.
local talus = require "talus"
local u = talus.units

local t_end = talus.param("t_end", 4e-5, "end of the run with cracks, s")
local a, P = 0.1, 20*u.MPa
local E, nu = 55*u.GPa, 0.3
local rock = talus.material { name = "rock", density = 2600, young = E, poisson = nu }
local hole = talus.circle { at = {0, 0}, radius = a, sides = 64, name = "hole" }

-- 1. Bonds that break: cracks begin at the wall, where the rock is pulled apart round the hole.
local joint = talus.joint { name = "rock bonds", friction = 45*u.deg, cohesion = 20*u.MPa, tension = 5*u.MPa,
                            residual = { cohesion = 0.05*u.MPa } }
local sim = talus.simulation {
  title = "Cracks round a hole under gas",
  regions = { talus.region { name = "plate", outline = talus.rect(-1, -1, 1, 1), material = rock, joint = joint,
                             holes = { talus.circle { at = {0, 0}, radius = a, sides = 32, name = "hole" } },
                             mesh = { size = talus.grade { { at = "hole", size = 0.03 }, far = 0.15 } } } },
  boundaries = { talus.viscous { region = "plate", on = {"left", "right", "bottom", "top"} } },
  charges = { talus.charge { hole = "hole", eos = talus.eos.polytropic { pressure = 100*u.MPa, gamma = 1.4 }, gas_speed = 200 } },
  time = { t_end = t_end, dt_max = 4e-6, displacement_ratio = 0.002 },
  output = { dir = "out/borehole", picture = "s1" },
  on_gas = function(sim, events)
    for _, event in ipairs(events) do
      sim:log("%s: %.3g m3, %.4g MPa", event.kind, event.volume, event.pressure/u.MPa)
    end
  end,
}
sim:run()
local charge, energy = sim.charges[1], sim.energy
sim:log("%d bonds failed; hole %.2f times its volume, %.1f MPa; the gas gave %.3g J/m", sim.totals.failures,
  charge.volume/charge.first_volume, charge.pressure/u.MPa, energy.gas)
talus.check.near("pressure by the law", charge.pressure, 100*u.MPa*(charge.first_volume/charge.volume)^1.4, { rel = 1e-10 })
talus.check.near("work on the wall against the law's", energy.gas, charge.work, { rel = 0.01 })
talus.check.near("ledger", energy.unexplained, 0, { abs = 0.01*energy.scale })

-- 2. Bonds that hold: the pressure comes at once, waves run out through the edges, and the hole stays as Lamé has it.
do
  local sim = talus.simulation {
    regions = { talus.region { name = "plate", outline = talus.rect(-3, -3, 3, 3), material = rock, holes = { hole },
                               mesh = { size = talus.grade { { at = "hole", size = 0.0075 }, far = 0.5 } } } },
    boundaries = { talus.viscous { region = "plate", on = {"left", "right", "bottom", "top"} } },
    charges = { talus.charge { hole = "hole", eos = function() return P end, gas_speed = 0 } },
    probes = { wall = {a + 1e-4, 0} },
    time = { t_end = 6e-3, dt = 4e-5 },
  }
  sim:run()
  talus.check.near("Lamé: displacement of the wall", sim.probes.wall.ux, P*a*(1 + nu)/E, { rel = 0.01 })
end
