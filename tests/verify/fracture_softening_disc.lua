-- Softening by a given G_I: how much a body bears does not depend on the size of its blocks once these are a fifth of
-- the characteristic length l = E G_I/ft² or less. The flattened disc of Ning et al. (2011), Fig. 6, driven to its split,
-- and a plate with an edge crack (20 s CPU; three minutes with full=true).
-- Source: Hillerborg, Modéer & Petersson (1976): with a fracture energy the strength of a body follows from E, ft and G_I.
-- Discs with a path for the crack in the mesh, bonded like all else, and discs without one, over whose zigzag of edges the
-- crack has a path of its own (theory, section 12).
local talus = require "talus"
local u = talus.units
local disc = require "parts.flattened_disc"
local full = talus.param("full", false, "the cracked plate to a quarter of its coarsest size")
local young, strength = 10*u.GPa, 0.5*u.MPa

-- Over the median; and the median.
local function spread(values)
  table.sort(values)
  local median = values[(#values + 1)//2]
  return (values[#values] - values[1])/median, median
end

-- l = 20 mm, of a disc of 50 mm.
local energy = 0.5
local loads = {}
for _, size in ipairs { 3.6, 2.8, 2.2, 1.8 } do
  local joint = disc.joint { reduction = talus.laws.softening { G_I = energy } }
  local path = talus.trace { points = { {0, -disc.half_height}, {0, disc.half_height} }, bonded = true, joint = joint }
  local body = talus.region { name = "disc", outline = disc.outline(size*u.mm), material = disc.rock,
                              mesh = { size = size*u.mm }, joint = joint, cuts = { path } }
  local sim, seen = disc.break_up(body, nil, { until_through = true })
  local label = string.format("softening disc of %d blocks: ", #sim.blocks)
  talus.check.below(label .. "block size, of the characteristic length", size*u.mm/(young*energy/strength^2), 0.2)
  talus.check.truth(label .. "split", seen.split)
  talus.check.above(label .. "failed length within 0.1 D of the loaded diameter",
                    disc.share(seen, function(x) return math.abs(x) < 0.2*disc.radius end), 0.95)
  talus.check.below(label .. "solves a failed bond", sim.totals.iterations/sim.totals.failures, 15)
  talus.check.below(label .. "unexplained energy, of the work put in",
                    math.abs(sim.energy.unexplained)/sim.energy.scale, 1e-3)
  loads[#loads + 1] = seen.splitting
end
local of_path, along_path = spread(loads)
talus.check.below("softening discs: spread of the splitting load, of their median", of_path, 0.03)

-- The five meshes of fracture_disc, without a path; l = 10 and 20 mm.
for _, energy in ipairs(full and { 0.25, 0.5 } or { 0.5 }) do
  loads = {}
  for _, size in ipairs(full and { 1.72, 1.76, 1.8, 1.84, 1.88 } or { 1.72, 1.8, 1.88 }) do
    local body = talus.region { name = "disc", outline = disc.outline(size*u.mm), material = disc.rock, mesh = { size = size*u.mm },
                                joint = disc.joint { reduction = talus.laws.softening { G_I = energy } } }
    local most = 0
    local sim = disc.break_up(body, {
      on_step = function(sim) most = math.max(most, disc.load(sim)) end,
      stop = function(sim) return disc.load(sim) < 0.95*most end,
    })
    local label = string.format("softening disc of %d blocks without a path, G_I %g J/m2: ", #sim.blocks, energy)
    talus.check.truth(label .. "past the load it bears", disc.load(sim) < 0.95*most or sim.collapsed)
    talus.check.below(label .. "solves a failed bond", sim.totals.iterations/sim.totals.failures, 50)
    talus.check.below(label .. "unexplained energy, of the work put in", math.abs(sim.energy.unexplained)/sim.energy.scale, 1e-3)
    loads[#loads + 1] = most
  end
  local of_mesh, without = spread(loads)
  local label = string.format("softening discs without a path, G_I %g J/m2: ", energy)
  talus.check.below(label .. "spread of the splitting load, of their median", of_mesh, 0.03)
  talus.check.near(label .. "median splitting load, of that along a path", without/along_path, 1, { rel = 0.05 })
end

-- A plate of 1 m with a crack of 0.3 m, pulled apart; l = 0.5 m. Three meshes.
local function most_load(size)
  local joint = talus.joint { name = "bond", friction = 35*u.deg, cohesion = 4*u.MPa, tension = strength,
                              reduction = talus.laws.softening { G_I = 12.5 } }
  local cuts = { talus.trace { points = { {0, 0.5}, {0.3, 0.5} }, joint = talus.joint { name = "crack", friction = 0 } },
                 talus.trace { points = { {0.3, 0.5}, {1, 0.5} }, bonded = true, joint = joint } }
  local most = 0
  local sim = talus.simulation {
    regions = { talus.region { name = "plate", outline = talus.rect(0, 0, 1, 1), material = disc.rock,
                               mesh = { size = size }, cuts = cuts, joint = joint } },
    fix = { talus.fix { region = "plate", on = "bottom" },
            talus.fix { name = "pull", region = "plate", on = "top",
                        displacement = {0, {{0, 0}, {1, 0.12*u.mm}}} } },
    time = { mode = "static", steps = 20 },
    on_step = function(sim) most = math.max(most, sim.reactions.pull[2]) end,
    stop = function(sim) return sim.reactions.pull[2] < 0.9*most end,
  }
  sim:run()
  talus.check.truth(string.format("cracked plate, size %g: past the load it bears", size),
                    sim.reactions.pull[2] < 0.9*most)
  return most
end
local reference
for _, size in ipairs(full and { 0.1, 0.05, 0.025 } or { 0.1, 0.07, 0.05 }) do
  local most = most_load(size)
  reference = reference or most
  talus.check.near(string.format("cracked plate, size %g: most load, of that at 0.1", size), most/reference, 1,
                   { rel = 0.03 })
end
