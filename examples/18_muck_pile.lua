-- A jointed bench thrown off its place, and what a blasting engineer asks of the pile: sizes, profile, throw, swell, cast, flyrock.
-- Run: scripts/run examples/18_muck_pile.lua                  (10 s CPU)
--      scripts/run examples/18_muck_pile.lua -p speed=9      a stronger blast
-- Teaches: talus.blast, sim.highest, a run that stops when it has come to rest, sleeping.
-- Picture: docs/pictures/18_muck_pile.svg (at rest), docs/pictures/18_muck_pile_profile.svg, docs/pictures/18_muck_pile_sizes.svg
-- The charge is not computed: rows of rock start with the velocities that a blast may give them, the front row fastest, so that the
-- scene takes seconds; rock is cut by two joint sets and does not break further, so that its blocks are the fragments.
-- Source: free flight for the highest rise; what is thrown keeps its area.
local talus = require "talus"
local u = talus.units

local speed = talus.param("speed", 6, "of the front row, m/s")
local rock = talus.material { name = "limestone", density = 2600, young = 20*u.GPa, poisson = 0.25 }
local joint = talus.joint { name = "joints", friction = 35*u.deg }
local cuts = { talus.joint_set { dip = 75*u.deg, spacing = 0.6, spacing_scatter = 0.4, seed = 3 },
               talus.joint_set { dip = -12*u.deg, spacing = 0.5, spacing_scatter = 0.4, seed = 5 } }
local function row(number, x, share)
  return talus.region { name = "row " .. number, outline = talus.rect(x, 0, x + 2.5, 6), material = rock, joint = joint, cuts = cuts,
                        velocity = { share*speed, share*speed/2 } }
end

local sim = talus.simulation {
  title   = "Muck pile of a bench in two rows",
  gravity = {0, -9.81},
  regions = { talus.region { name = "floor", outline = talus.rect(-8, -1, 45, 0), material = rock, held = true },
              talus.region { name = "wall", outline = talus.rect(-8, 0, 0, 6), material = rock, held = true },
              row(1, 2.5, 1), row(2, 0, 0.6) },
  contact = joint,
  numerics = { sleeping = true },
  time    = { t_end = 6 },
  stop    = function(sim) return sim.time > 2 and sim.energy.kinetic < 1e-6*sim.state.most end,
  on_step = function(sim) sim.state.most = math.max(sim.state.most or 0, sim.energy.kinetic) end,
  output  = { dir = "out/muck_pile", every = 1, picture = "speed" },
}
sim:run()

local rows = { "row 1", "row 2" }
local sizes = talus.blast.fragmentation(sim, { regions = rows, file = "sizes" })
local pile = talus.blast.pile(sim, { regions = rows, line = 5, file = "profile" })
local front = talus.blast.pile(sim, { regions = {"row 1"}, line = 5 })

print(string.format("%d fragments: x20 %.2f, x50 %.2f, x80 %.2f m; Rosin–Rammler n = %.2f, off by %.3f; Swebrec b = %.2f, off by %.3f",
  sizes.count, sizes.x20, sizes.x50, sizes.x80, sizes.rosin_rammler.n, sizes.rosin_rammler.residual, sizes.swebrec.b,
  sizes.swebrec.residual))
print(string.format("pile: %.2f m high at x = %.1f m, toe %.1f m from the face, farthest rock %.1f m; swell %.2f; %.0f %% cast;"
  .. " the centroid of the front row went %.1f m, of all %.1f m", pile.height, pile.crest, pile.throw, pile.farthest.distance, pile.swell,
  100*pile.cast, front.shift[1], pile.shift[1]))
print(string.format("highest rise %.2f m, at %.2f s", pile.highest.rise, pile.highest.time))
talus.check.near("area thrown, m2", pile.solid, 30, { rel = 1e-3 })
talus.check.above("swell", pile.swell, 1)
talus.check.above("the front row goes farther, m", front.shift[1] - pile.shift[1], 0)
talus.check.above("highest rise, at least that of free flight of the front row, m", pile.highest.rise, 0.95*(speed/2)^2/(2*9.81))
talus.check.near("ledger: unexplained, of the work put in", sim.energy.unexplained/sim.energy.scale, 0, { abs = 0.01 })
