-- A rock slope cut by two joint sets slides along the set that daylights: above the toe nothing holds the layer, and its
-- upper blocks move as one on an incline, g (sin a - cos a tan phi) t²/2. At 33 degrees of friction nothing slides.
-- Run: scripts/run examples/03_slope.lua -p friction=20      (2 s CPU)
-- Teaches: joint sets, real joints, contacts between the blocks of one region, automatic time step, probes. As a study over friction
-- and dip: examples/studies/slope.lua.
-- Picture: docs/pictures/03_slope.svg
local talus = require "talus"
local u = talus.units

local friction = talus.param("friction", 20, "friction angle of the joints, degrees")
local dip = talus.param("dip", 32, "of the set that daylights, degrees")*u.deg
local rock  = talus.material { name = "rock", density = 2600, young = 5*u.GPa, poisson = 0.25 }
local joint = talus.joint { name = "joint", friction = friction*u.deg }

local sim = talus.simulation {
  gravity = {0, -9.81},
  contact = joint,
  regions = {
    talus.region { name = "base", outline = { {-10, -3}, {30, -3}, {30, 0}, {-10, 0} }, material = rock, held = true },
    talus.region { name = "slope", outline = { {0, 0}, {30, 0}, {30, 14}, {12, 14} }, material = rock, joint = joint,
                   cuts = { talus.joint_set { dip = dip, spacing = 2.5, through = {0, 0}, joint = joint },
                            talus.joint_set { dip = 110*u.deg, spacing = 3.0, through = {12, 14}, joint = joint } } },
  },
  fix    = { talus.fix { region = "slope", on = talus.line(30, 0, 30, 14), y = false } },
  probes = { layer = {14, 12.9} },
  time   = { mode = "dynamic", t_end = 1.5 },
  output = { dir = "out/slope", every = 0.25, picture = "u" },
}
sim:run()

local p = sim.probes.layer
local slide = math.max(0, 0.5*9.81*(math.sin(dip) - math.cos(dip)*math.tan(friction*u.deg))*sim.time^2)
local way = math.sqrt(p.ux^2 + p.uy^2)
talus.result("way", way, "m")
-- At other dips the layer that holds the probe is another, and may lean on its neighbours; farther than a spacing, the base slows it.
if dip == 32*u.deg and slide < 3 then talus.check.near("way of the sliding layer, m", way, slide, { rel = 0.01, abs = 5e-3 }) end  -- gravity comes at once and shakes it by mm
