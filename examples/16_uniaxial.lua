-- Bonded rock pressed between smooth plates until it breaks; and joint values found for the strengths that a laboratory measured.
-- Run: scripts/run examples/16_uniaxial.lua                  (15 s CPU)
--      scripts/run examples/16_uniaxial.lua -p friction=45   another friction of the joints
-- Teaches: talus.lab.compression, talus.lab.brazilian, talus.calibrate, what strengths of bonds make of the strength of rock.
-- Picture: docs/pictures/16_uniaxial.svg (broken), docs/pictures/16_uniaxial_curve.svg (axial stress against strain)
-- Source: Mohr and Coulomb: between smooth plates the stress is uniform, and the first bond fails, on the worst of all inclinations, at
-- 2 c tan(45° + φ/2); a brittle specimen bears little more. On a coarse mesh no bond may lie on that inclination: some per cent.
local talus = require "talus"
local u = talus.units

local friction = talus.param("friction", 35, "friction angle of the joints, degrees")*u.deg
local size = talus.param("size", 4*u.mm, "triangle edge, m")
local rock = talus.material { name = "granite", density = 2650, young = 50*u.GPa, poisson = 0.25 }

-- 1. A specimen of 40 × 80 mm with joint values as they may come.
local cohesion = 30*u.MPa
local joint = talus.joint { name = "granite", friction = friction, cohesion = cohesion, tension = 9*u.MPa }
local test = talus.lab.compression { title = "Uniaxial compression", material = rock, joint = joint, size = size, width = 40*u.mm,
                                     output = { dir = "out/uniaxial", picture = "s2" }, file = "stress_strain" }
local expected = 2*cohesion*math.tan(math.pi/4 + friction/2)
print(string.format("uniaxial strength %.1f MPa, Mohr–Coulomb says %.1f; %.2f GPa; %d bonds failed", test.strength/u.MPa, expected/u.MPa,
                    test.young/u.GPa, test.sim.totals.failures))
talus.check.truth("it broke", test.broke)
talus.check.near("Young's modulus of the specimen, GPa", test.young/u.GPa, 50, { rel = 0.01 })
talus.check.near("uniaxial strength, MPa", test.strength/u.MPa, expected/u.MPa, { rel = 0.05 })

-- 2. The laboratory has 120 MPa in compression and 9 MPa by Brazilian tests. Joint values that give them on this mesh size:
local wanted = { ucs = 120*u.MPa, tensile = 9*u.MPa }
local found = talus.calibrate { material = rock, ucs = wanted.ucs, tensile = wanted.tensile, size = size, friction = friction }
print(string.format("cohesion %.2f MPa, tension %.2f MPa give %.1f and %.2f MPa, after %d rounds", found.joint.cohesion/u.MPa,
                    found.joint.tension/u.MPa, found.reached.ucs/u.MPa, found.reached.tensile/u.MPa, found.rounds))
talus.check.truth("calibrated", found.converged)

-- 3. They hold for another mesh of that size, but for the scatter of a brittle law.
local other = talus.lab.compression { material = rock, joint = talus.joint(found.joint), size = 0.95*size, width = 50*u.mm, keep = 0.9 }
talus.check.near("uniaxial strength of a larger specimen with these values, MPa", other.strength/u.MPa, wanted.ucs/u.MPa, { rel = 0.08 })
