-- What an explosive gives: ANFO by JWL that fills its hole, ANFO in a cartridge (decoupled), and the polytrope of the cast blast, each
-- between two blocks of rock that it drives apart.
-- Run: scripts/run examples/14_jwl.lua                    (1 s CPU; pictures in out/jwl)
--      scripts/run examples/14_jwl.lua -p diameter=0.15   a thicker cartridge, m
-- Teaches: charges by explosive and diameter, talus.eos, where the energy of a charge goes, sim:plot.
-- Picture: docs/pictures/14_jwl.svg (pressure over expansion)
-- Source: energy stored in a hole of 0.1 m radius: ANFO E = 2.484 GJ/m3 (Dobratz & Crawford 1985), 78.0 MJ/m; P0 V0/(γ - 1) of 1 GPa and
-- γ 1.4 (Ning et al. 2011), 78.5 MJ/m. To V/V0 = 129.65, where the paper's chamber vents: 67.6 and 67.3 MJ/m, by ∫P dV.
-- A cartridge begins where its gas has as much room as the hole: the work of getting there, on nothing but air, is missing in what it gives.
-- The gas fills the joint between the blocks as it opens and does not vent; so the rock takes all that the gas gives.
local talus = require "talus"
local u = talus.units

local diameter = talus.param("diameter", 0.1, "of the cartridge, m")
local radius, expansion = 0.1, 129.65
local rock = talus.material { name = "rock", density = 2600, young = 55*u.GPa, poisson = 0.3 }

-- `tail`: γ - 1 of what is left of the pressure in the end, ω of JWL.
local function drive(charge, tail, stored, expected)
  charge.hole, charge.gas_speed, charge.venting = "hole", 1e6, function() return 1 end
  local sim = talus.simulation {
    title = charge.name,
    regions = { talus.region { name = "blocks", outline = talus.rect(-3, -2, 3, 2), material = rock,
      holes = { talus.circle { at = {0, 0}, radius = radius, sides = 64, name = "hole" } },
      cuts = { talus.trace { points = { {0, -3}, {0, 3} } } } } },
    charges = { talus.charge(charge) },
    numerics = { theta = 0.5 },  -- keeps the energy of the blocks' vibration
    time = { t_end = 0.1, dt = 2e-5 },
    output = { dir = "out/jwl/" .. charge.name:gsub("%W", "_"), every = 1 },
    stop = function(sim) return sim.charges[1].volume > expansion*sim.charges[1].first_volume end,
  }
  local curve = { name = charge.name, x = {}, y = {} }
  for _ in sim:steps() do
    local c = sim.charges[1]
    curve.x[#curve.x + 1], curve.y[#curve.y + 1] = c.volume/c.first_volume, c.pressure
  end
  local c, energy = sim.charges[1], sim.energy
  local speed = math.abs(sim.blocks[1].velocity[1])
  print(string.format("%-15s %7.1f MPa at first, %5.2f MJ/m to V/V0 = %.1f, blocks at %.1f m/s%s", c.name, curve.y[1]/u.MPa, c.work/1e6,
    c.volume/c.first_volume, speed, c.mass and string.format(", %.2f kg/m", c.mass) or ""))
  -- What is left is P V/tail, as P V^(1+tail) hardly changes any more.
  talus.check.near(c.name .. ": work and what is left in the gas, MJ/m", (c.work + c.pressure*c.volume/tail)/1e6, stored, { rel = 0.005 })
  talus.check.near(c.name .. ": work, MJ/m", c.work/1e6, expected, { rel = 0.01 })
  talus.check.near(c.name .. ": work on the rock against the law's", energy.gas, c.work, { rel = 2e-3 })
  talus.check.near(c.name .. ": energy of the rock against the gas's work", energy.kinetic + energy.strain, energy.gas, { rel = 0.01 })
  return curve, sim
end

-- ∫P dV, MJ/m, along the isentrope of a mass of ANFO from the room it has in the hole to `last` times that.
local function anfo_work(mass, last)
  local e = talus.explosives.ANFO
  local first = mass/e.density
  local tail = e.E - e.A/e.R1*math.exp(-e.R1) - e.B/e.R2*math.exp(-e.R2)
  local function energy(w) return e.A/e.R1*math.exp(-e.R1*w) + e.B/e.R2*math.exp(-e.R2*w) + tail*w^-e.omega end
  local hole = 64/2*radius^2*math.sin(2*math.pi/64)
  return first*(energy(hole/first) - energy(last*hole/first))/1e6
end

local omega = talus.explosives.ANFO.omega
local mass = 931*math.pi/4*diameter^2
local full = drive({ name = "ANFO", explosive = "ANFO" }, omega, 78.0, 67.6)
local cartridge, sim = drive({ name = "ANFO, decoupled", explosive = "ANFO", diameter = diameter }, omega,
  anfo_work(mass, math.huge), anfo_work(mass, expansion))
local polytrope = drive({ name = "polytrope 1 GPa", eos = talus.eos.polytropic { pressure = 1*u.GPa, gamma = 1.4 } }, 0.4, 78.5, 67.3)
print(string.format("of the %.1f MJ/m in the cartridge the gap takes %.1f", 2484*mass/931, 2484*mass/931 - anfo_work(mass, math.huge)))
talus.check.below("pressure at first in the wider hole, beside the cartridge's part of it times the full hole's", cartridge.y[1],
  full.y[1]*(diameter/(2*radius))^2)

sim:plot("pressure", { title = "Pressure of the gas as it expands", x_label = "V/V_0", y_label = "P", y_unit = "Pa", log_x = true, log_y = true,
                       full, cartridge, polytrope })
