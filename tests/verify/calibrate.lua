-- Joint values for wanted strengths: friction too where a confined strength is given; and what cannot be reached is told.
-- Source: Mohr and Coulomb: a strength that grows by N under a pressure of 1 is that of a friction angle of 2 (atan √N - 45°). (8 s CPU)
local talus = require "talus"
local u = talus.units
local rock = talus.material { density = 2650, young = 50*u.GPa, poisson = 0.25 }

local wanted = { ucs = 120*u.MPa, tensile = 9*u.MPa, confined = 180*u.MPa }
local found = talus.calibrate { material = rock, ucs = wanted.ucs, tensile = wanted.tensile, size = 5*u.mm, across = 8,
                                confined = { pressure = 10*u.MPa, strength = wanted.confined } }
talus.check.truth("calibrated, with friction", found.converged)
for _, name in ipairs { "ucs", "tensile", "confined" } do
  talus.check.near("calibrated: " .. name .. ", MPa", found.reached[name]/u.MPa, wanted[name]/u.MPa, { rel = 0.03 })
end
talus.check.near("calibrated: friction, degrees", math.deg(found.joint.friction), 2*(math.deg(math.atan(math.sqrt(6))) - 45), { rel = 0.03 })
talus.check.near("calibrated: Young's modulus, GPa", found.reached.young/u.GPa, 50, { rel = 0.01 })

-- Discs of rock that bears five times as much in compression as in tension are crushed at the flats.
local beyond = talus.calibrate { material = rock, ucs = 50*u.MPa, tensile = 10*u.MPa, size = 5*u.mm, across = 8, most = 2 }
talus.check.equal("beyond reach: converged", beyond.converged, false)
talus.check.near("beyond reach: uniaxial strength, MPa", beyond.reached.ucs/u.MPa, 50, { rel = 0.05 })
talus.check.below("beyond reach: Brazilian strength, MPa", beyond.reached.tensile/u.MPa, 7)
