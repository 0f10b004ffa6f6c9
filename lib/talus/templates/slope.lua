-- A slope cut by two sets of joints: what daylights above the toe slides, where friction does not hold it.
-- Run: talus slope.lua                    results in out/slope: history.csv, pictures, blocks.pvd for ParaView
--      talus slope.lua -p friction=33     with another value of a parameter
--      talus check slope.lua              what it would take, without running it
local talus = require "talus"
local u = talus.units  -- SI everywhere: multiply by a unit, 5*u.GPa, 20*u.deg

-- Parameters can be given on the command line with -p name=value.
local friction = talus.param("friction", 20, "friction angle of the joints, degrees")

local rock  = talus.material { name = "rock", density = 2600, young = 5*u.GPa, poisson = 0.25 }
local joint = talus.joint { name = "joint", friction = friction*u.deg }

local sim = talus.simulation {
  gravity = {0, -9.81},
  contact = joint,  -- between regions
  regions = {
    talus.region { name = "base", outline = talus.rect(-10, -3, 30, 0), material = rock, held = true },
    -- Joint sets cut the slope into blocks: dip from the x axis, distance between joints, a point that one goes through.
    talus.region { name = "slope", outline = { {0, 0}, {30, 0}, {30, 14}, {12, 14} }, material = rock, joint = joint,
                   cuts = { talus.joint_set { dip = 32*u.deg, spacing = 2.5, through = {0, 0}, joint = joint },
                            talus.joint_set { dip = 110*u.deg, spacing = 3, through = {12, 14}, joint = joint } } },
  },
  fix    = { talus.fix { region = "slope", on = "right", y = false } },  -- the back may sink, not move sideways
  probes = { crest = {14, 12.9} },
  time   = { mode = "dynamic", t_end = 1 },
  output = { dir = "out/slope", every = 0.1, picture = "u" },
}
sim:run()

local crest = sim.probes.crest
print(("the crest has moved %.3f m in %.1f s"):format(math.sqrt(crest.ux^2 + crest.uy^2), sim.time))
