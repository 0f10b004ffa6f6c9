-- Bonded rock pressed between smooth plates under pressure at its sides: how much more it bears.
-- Run: scripts/run examples/17_biaxial.lua                (20 s CPU)
-- Teaches: talus.lab.compression with pressure, sim:plot of several curves, the failure line of bonded rock.
-- Picture: docs/pictures/17_biaxial.svg (axial stress against strain), docs/pictures/17_biaxial_line.svg (strength against pressure)
-- Source: Mohr and Coulomb: σ1 = 2 c tan(45° + φ/2) + σ3 tan²(45° + φ/2), c and φ those of the bonds.
local talus = require "talus"
local u = talus.units

local friction, cohesion = 35*u.deg, 30*u.MPa
local rock = talus.material { name = "granite", density = 2650, young = 50*u.GPa, poisson = 0.25 }
local joint = talus.joint { name = "granite", friction = friction, cohesion = cohesion, tension = 9*u.MPa }
local t = math.tan(math.pi/4 + friction/2)
local function line(pressure) return 2*cohesion*t + pressure*t^2 end

local curves, pressures, strengths, last = {}, {}, {}, nil
for _, pressure in ipairs { 0, 10*u.MPa, 20*u.MPa } do
  local test = talus.lab.compression { title = string.format("Biaxial compression, %g MPa at the sides", pressure/u.MPa), material = rock,
    joint = joint, size = 4*u.mm, width = 40*u.mm, pressure = pressure, keep = 0.9,
    output = { dir = string.format("out/biaxial_%g", pressure/u.MPa), picture = "s2" } }
  print(string.format("%g MPa at the sides: strength %.1f MPa, Mohr–Coulomb says %.1f", pressure/u.MPa, test.strength/u.MPa,
                      line(pressure)/u.MPa))
  talus.check.near(string.format("strength under %g MPa, MPa", pressure/u.MPa), test.strength/u.MPa, line(pressure)/u.MPa, { rel = 0.05 })
  curves[#curves + 1] = { name = string.format("%g MPa at the sides", pressure/u.MPa), x = test.strain, y = test.stress, markers = true }
  pressures[#pressures + 1], strengths[#strengths + 1] = pressure, test.strength
  last = test.sim
end
last:plot("stress_strain", { title = "Biaxial compression", x_label = "ε", y_label = "σ_1", y_unit = "Pa", curves })
last:plot("failure_line", { title = "Strength under pressure at the sides", x_label = "σ_3", x_unit = "Pa", y_label = "σ_1", y_unit = "Pa",
  { name = "tests", x = pressures, y = strengths, markers = true, line = false },
  { name = "Mohr–Coulomb of the bonds", x = { 0, 20*u.MPa }, y = { line(0), line(20*u.MPa) }, dashed = true } })
