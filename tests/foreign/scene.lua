-- Results for tests/foreign/run, and what must be found in them.
local talus = require "talus"
local rock = talus.material { density = 2600, young = 5e9, poisson = 0.25 }
local bond = talus.joint { friction = 0.6, cohesion = 1e5, tension = 2e4 }
local sim = talus.simulation { gravity = {0, -9.81}, probes = { tip = {3.9, 0.5} },
  regions = { talus.region { name = "beam", outline = talus.rect(0, 0, 4, 1), material = rock, joint = bond, mesh = { size = 0.5 } } },
  fix = { talus.fix { region = "beam", on = "left" } },
  time = { mode = "dynamic", t_end = 0.1, dt = 0.005 }, output = { dir = "out", every = 0.05, picture = { field = "speed", scale = 20 } } }
sim:run()
local function line(what, ...) print("=\t" .. what .. "\t" .. table.concat({ ... }, "\t")) end
line("blocks", #sim.blocks)
line("joints", #sim.joints)
for _, i in ipairs { 1, #sim.blocks } do
  local b = sim.blocks[i]
  line("block", i, b.area, b.sxx, b.velocity[1], b.velocity[2], b.centroid[1], b.centroid[2])
end
local tension = 0
for _, j in ipairs(sim.joints) do if j.mode == "tension" then tension = tension + 1 end end
line("tension", tension)
line("tip", sim.probes.tip.uy)
