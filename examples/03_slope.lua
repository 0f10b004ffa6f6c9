-- A rock slope cut by two joint sets slides along the set that daylights.
-- Run: scripts/run examples/03_slope.lua      (about 10 s)
-- Teaches: joint sets, real joints, contacts between the blocks of one region, automatic time step.
local talus = require "talus"
local u = talus.units

local friction = talus.param("friction", 20, "friction angle of the joints, degrees")
local rock  = talus.material { name = "rock", density = 2600, young = 5*u.GPa, poisson = 0.25 }
local joint = talus.joint { name = "joint", friction = friction*u.deg }

local sim = talus.simulation {
  gravity = {0, -9.81},
  contact = joint,
  regions = {
    talus.region { name = "base", outline = { {-10, -3}, {30, -3}, {30, 0}, {-10, 0} }, material = rock, held = true },
    talus.region { name = "slope", outline = { {0, 0}, {30, 0}, {30, 14}, {12, 14} }, material = rock, joint = joint,
                   cuts = { talus.joint_set { dip = 32*u.deg, spacing = 2.5, through = {0, 0}, joint = joint },
                            talus.joint_set { dip = 110*u.deg, spacing = 3.0, through = {12, 14}, joint = joint } } },
  },
  fix    = { talus.fix { region = "slope", on = talus.line(30, 0, 30, 14), y = false } },
  time   = { mode = "dynamic", t_end = 1.5 },
  output = { dir = "out/slope", every = 0.25, picture = "u" },
}
sim:run()
talus.check.above("largest displacement, m", math.max(table.unpack(sim.blocks:field("u"))), 0.5)
