-- A bonded beam that breaks off at its support and falls. Prints, for the last frame, what picking must find.
local talus = require "talus"
local rock = talus.material { name = "rock </script> & stone", density = 2600, young = 5e9, poisson = 0.25 }
local bond = talus.joint { friction = 0.6, cohesion = 1e5, tension = 2e4 }
local sim = talus.simulation { title = "Beam </title> & </script>", gravity = {0, -9.81}, probes = { tip = {103.9, 50.5} },
  regions = { talus.region { name = "beam", outline = talus.rect(100, 50, 104, 51), material = rock, joint = bond,
                             mesh = { kind = "cross", nx = 8, ny = 2 } } },
  fix = { talus.fix { region = "beam", on = "left" } },
  time = { mode = "dynamic", t_end = 0.2, dt = 0.005 }, output = { dir = "out", every = 0.02 } }
sim:run()
for _, i in ipairs { 1, 17, 40, #sim.blocks } do
  local b = sim.blocks[i]
  print(("block\t%d\t%.9g\t%.9g\t%.9g"):format(i, b.centroid[1], b.centroid[2], b.velocity[2]))
end
local failed = 0
for _, joint in ipairs(sim.joints) do if joint.mode == "tension" or joint.mode == "shear" then failed = failed + 1 end end
print(("failed\t%d"):format(failed))
