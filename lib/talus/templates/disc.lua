-- A disc between two plates (Brazilian test): it splits along the loaded diameter; its load gives the tensile strength.
-- Run: talus disc.lua                   results in out/disc: load_displacement.svg, pictures, cracks.pvd for ParaView
--      talus disc.lua -p size=2         a finer mesh
--      talus check disc.lua             what it would take, without running it
local talus = require "talus"
local u = talus.units  -- SI everywhere: multiply by a unit, 25*u.mm, 10*u.GPa

-- Parameters can be given on the command line with -p name=value.
local size = talus.param("size", 4, "triangle edge, mm")*u.mm

local radius, flat = 25*u.mm, 0.06  -- of the disc; half the angle of the flats on which the plates press
local rock = talus.material { name = "rock", density = 2500, young = 10*u.GPa, poisson = 0.2 }
-- Bonds between the triangles fail where traction passes these strengths.
local bond = talus.joint { name = "rock", friction = 35*u.deg, cohesion = 4*u.MPa, tension = 0.5*u.MPa }

local outline = {}
for _, side in ipairs { 0, math.pi } do
  for i = 0, 20 do
    local angle = side + flat + (math.pi - 2*flat)*i/20
    outline[#outline + 1] = { radius*math.sin(angle), radius*math.cos(angle) }
  end
end
local top, half = radius*math.cos(flat), radius*math.sin(flat)

local largest = 0
local sim = talus.simulation {
  contact = talus.joint { name = "smooth", friction = 0 },
  regions = {
    talus.region { name = "disc", outline = outline, material = rock, joint = bond, mesh = { size = size } },
    talus.region { name = "upper plate", outline = talus.rect(-2*half, top, 2*half, top + 2*half), material = rock, order = "rigid" },
    talus.region { name = "lower plate", outline = talus.rect(-2*half, -top - 2*half, 2*half, -top), material = rock, held = true },
  },
  -- The upper plate comes down: displacement over the time of the load, 0 to 1.
  fix    = { talus.fix { name = "press", region = "upper plate", on = "top", displacement = { 0, { {0, 0}, {1, -0.1*u.mm} } } } },
  time   = { mode = "static", steps = 10 },
  output = { dir = "out/disc", every = 0.1, picture = "s1" },
  -- Called where bonds have failed; the list tells which, and how.
  on_fracture = function(sim) largest = math.max(largest, -sim.reactions.press[2]) end,
  -- The run ends where this is true: when a crack as long as the radius has run through.
  stop = function(sim) return sim.cracks.tension > 1.4*radius end,
}
sim:run()

print(("largest load %.1f kN per metre: tensile strength %.2f MPa by 2P/(πD)"):format(largest/u.kN, largest/(math.pi*radius)/u.MPa))
