-- A block on an incline, for tests of `talus sweep`: some tenths of a second of motion in some hundredths of one.
local talus = require "talus"
local part = require "slide_part"

local angle = talus.param("angle", 20, "of the incline, degrees")
local friction = talus.param("friction", 30, "degrees")
local seed = talus.param("seed", 1)
local note = talus.param("note", "", "what to do besides: refuse, fail, wait, loop")
local steps = talus.param("steps", 20)

if note == "refuse" then error("this variant is refused") end
local rock = talus.material { density = 2500, young = 1e9, poisson = 0.25 }
local sim = talus.simulation {
  gravity = {0, -9.81},
  contact = talus.joint { friction = math.rad(friction) },
  regions = { talus.region { name = "base", outline = part.box(angle, -5, -1, 5, 0), material = rock, held = true },
              talus.region { name = "block", outline = part.box(angle, 0, 0, 1, 1), material = rock } },
  probes = { top = part.turn(angle, 0.5, 0.9) },
  time = { t_end = 0.01*steps, dt = 0.01 },
  output = { every = 0.02, vtk = false, picture = false },
}
while note == "loop" do end
if note == "wait" then
  local until_then = os.time() + 30
  while os.time() < until_then do end
end
sim:run()
talus.result("way", math.sqrt(sim.probes.top.ux^2 + sim.probes.top.uy^2) + 1e-9*(seed - 1), "m")
talus.check.truth("told to pass", note ~= "fail")
