-- What is made of a blast afterwards, against numbers known beforehand: fits to curves of given parameters, a pile of three blocks in
-- flight, moved probes, one failed bond, the gas in a joint.
-- Sources: Rosin & Rammler (1933); Ouchterlony (2005), the Swebrec function; free flight.
local talus = require "talus"
local u = talus.units
local check, blast = talus.check, talus.blast
local rock = talus.material { density = 2600, young = 20*u.GPa, poisson = 0.25 }

-- Sizes at which a curve has passed 1/m, 2/m, …: pieces of equal weight.
local function pieces_of(m, size_at)
  local sizes, weights = {}, {}
  for i = 1, m do sizes[i], weights[i] = size_at(i/m), 1 end
  return blast.distribution { sizes = sizes, weights = weights }
end

do
  local x50, n = 0.3, 1.2
  local found = pieces_of(4000, function(p) return x50*(-math.log(1 - math.min(p, 1 - 1e-9), 2))^(1/n) end)
  check.near("Rosin–Rammler curve: x50 of the fit, m", found.rosin_rammler.x50, x50, { rel = 1e-4 })
  check.near("Rosin–Rammler curve: n", found.rosin_rammler.n, n, { rel = 1e-4 })
  check.below("Rosin–Rammler curve: residual", found.rosin_rammler.residual, 1e-5)
  check.near("Rosin–Rammler curve: x20, m", found.x20, x50*(-math.log(0.8, 2))^(1/n), { rel = 1e-3 })
  check.near("Rosin–Rammler curve: x80, m", found.x80, x50*(-math.log(0.2, 2))^(1/n), { rel = 1e-3 })
  check.above("Rosin–Rammler curve: residual of the other law", found.swebrec.residual, 1e-3)
end

do
  local x50, xmax, b = 0.25, 2, 2.4
  local found = pieces_of(4000, function(p) return xmax*math.exp(-math.log(xmax/x50)*(1/p - 1)^(1/b)) end)
  check.near("Swebrec curve: x50 of the fit, m", found.swebrec.x50, x50, { rel = 1e-6 })
  check.near("Swebrec curve: b", found.swebrec.b, b, { rel = 1e-6 })
  check.near("Swebrec curve: xmax, m", found.swebrec.xmax, xmax, { rel = 1e-12 })
  check.below("Swebrec curve: residual", found.swebrec.residual, 1e-6)
  check.near("Swebrec curve: x50 by the curve itself, m", found.x50, x50, { rel = 1e-3 })
end

-- Three squares in flight over a floor, half a second after they left: shift (vx·t, vy·t − g·t²/2).
do
  local g, t, v = 10, 0.5, { {1, 3}, {2, 3}, {4, 2} }
  local function shift(k) return { v[k][1]*t, v[k][2]*t - g*t^2/2 } end
  local regions = { talus.region { name = "floor", outline = talus.rect(-5, -1, 12, 0), material = rock, held = true } }
  for k = 1, 3 do
    regions[k + 1] = talus.region { name = "rock " .. k, outline = talus.rect(2*k - 2, 0.5, 2*k - 1, 1.5), material = rock, velocity = v[k] }
  end
  local sim = talus.simulation { gravity = {0, -g}, regions = regions, time = { t_end = t, dt = 1*u.ms },
                                 numerics = { theta = 0.5 }, output = { dir = "out/blast_results" } }
  sim:run()
  local pile = blast.pile(sim, { line = 5.5, spacing = 1e-3, file = "pile" })
  check.near("three squares: height, m", pile.height, 1.5 + shift(1)[2], { abs = 1e-6 })
  check.near("three squares: solid area, m2", pile.solid, 3, { rel = 1e-6 })
  -- Squares lie at 0.5–1.5, 3–4, 6–7; of the last all lies beyond 5.5, of the others none.
  local mean = (2*shift(1)[2] + shift(3)[2])/3
  check.near("three squares: bulk area, m2", pile.bulk, 3*1.5 + 3*mean, { rel = 2e-3 })
  check.near("three squares: swell", pile.swell, 1.5 + mean, { rel = 2e-3 })
  check.near("three squares: centroid shift along x, m", pile.shift[1], 7/6, { rel = 1e-6 })
  check.near("three squares: centroid shift along y, m", pile.shift[2], mean, { rel = 1e-6 })
  check.near("three squares: cast beyond 5.5 m", pile.cast, 1/3, { abs = 1e-9 })
  check.near("three squares: cast beyond 6.25 m", blast.pile(sim, { line = 6.25 }).cast, 0.25, { abs = 1e-6 })
  check.near("three squares: toe of what hangs together with the crest, m", pile.toe, 1.5, { abs = 2e-3 })
  check.near("three squares: farthest beyond the face, m", pile.farthest.distance, 6.5 - 5, { abs = 1e-6 })
  check.near("three squares: highest rise, m", pile.highest.rise, 3^2/(2*g), { rel = 1e-3 })
  check.near("three squares: when, s", pile.highest.time, 3/g, { abs = 2*u.ms })
  check.near("only the last: shift, m", blast.pile(sim, { regions = {"rock 3"} }).shift[1], 2, { rel = 1e-6 })
  check.near("only what moved 1.5 m or more: solid area, m2", blast.pile(sim, { moved = 1.5 }).solid, 1, { rel = 1e-6 })

  local sizes = blast.fragmentation(sim)
  check.equal("three squares: fragments", sizes.count, 3)
  check.near("three squares: size √(4A/π), m", sizes.x50, math.sqrt(4/math.pi), { rel = 1e-6 })
  check.near("three squares: part in fragments of one block", sizes.single, 1, { abs = 1e-12 })
  check.equal("the floor is held", blast.fragmentation(sim, { regions = {"floor"} }).count, 0)
  check.equal("unless it is asked for", blast.fragmentation(sim, { regions = {"floor"}, where = function() return true end }).count, 1)
end

-- Probes on regions that are shaken with v = K·(R/√W)^-β·sin(2π t).
do
  local K, beta, W = 0.8, 1.6, 25
  local regions, fixes, probes = {}, {}, {}
  for k, R in ipairs { 2, 4, 8, 16 } do
    local name = "part " .. k
    regions[k] = talus.region { name = name, outline = talus.rect(R - 0.5, -0.5, R + 0.5, 0.5), material = rock }
    fixes[k] = talus.fix { region = name, velocity = { function(t) return K*(R/math.sqrt(W))^-beta*math.sin(2*math.pi*t) end, 0 } }
    probes["p" .. k] = { R, 0 }
  end
  local sim = talus.simulation { regions = regions, fix = fixes, probes = probes, time = { t_end = 0.6, dt = 5*u.ms },
                                 output = { dir = "out/blast_shaken" } }
  sim:run()
  local found = blast.vibration(sim, { at = {0, 0}, mass = W, file = "vibration" })
  check.near("shaken probes: K, m/s", found.K, K, { rel = 0.01 })
  check.near("shaken probes: β", found.beta, beta, { rel = 1e-6 })
  check.near("shaken probes: when the first was fastest, s", found.points[1].time, 0.25, { abs = 10*u.ms })
end

-- A bar of two squares that meet in one bond, pulled apart: the bond lies 0.2 m behind the line.
do
  local bond = talus.joint { friction = 0.5, cohesion = 2*u.MPa, tension = 1*u.MPa }
  local sim = talus.simulation {
    regions = { talus.region { name = "bar", outline = talus.rect(0, 0, 2, 1), material = rock, joint = bond,
                               cuts = { talus.trace { points = { {1, 0}, {1, 1} }, bonded = true } } } },
    fix = { talus.fix { region = "bar", on = "left" } },
    loads = { talus.edge_load { region = "bar", on = "right", traction = { {{0, 0}, {1, 2*u.MPa}}, 0 } } },
    time = { mode = "static", steps = 4 }, output = { dir = "out/blast_bar" } }
  sim:run()
  local behind = blast.backbreak(sim, { line = 1.2, file = "backbreak" })
  check.near("back-break: length of failed bonds, m", behind.length, 1, { rel = 1e-9 })
  check.near("back-break: in tension, m", behind.tension, 1, { rel = 1e-9 })
  check.near("back-break: depth, m", behind.depth, 0.2, { abs = 1e-3 })
  check.near("back-break: area beside them, m2", behind.area, 2, { rel = 1e-3 })
  check.near("behind a line drawn the other way", blast.backbreak(sim, { line = talus.line(1.2, 2, 1.2, -1), behind = "right" }).depth,
             0.2, { abs = 1e-3 })
  check.equal("on the other side", blast.backbreak(sim, { line = 1.2, behind = "right" }).length, 0)
end

-- Bonds behind a line are those that lay there: one of three bonds of a plate parts, 2 m in front of it, and a half flies 5 m away.
for _, v in ipairs { { 0, 10 }, { -10, 0 } } do
  local sim = talus.simulation {
    regions = { talus.region { name = "plate", outline = talus.rect(-1, 0, 5, 2), material = rock, mesh = { size = 3 },
                               joint = talus.joint { friction = 0.5, cohesion = 1e3, tension = 1e3 } } },
    time = { t_end = 0.5, dt = 1e-3 }, output = { dir = ("out/blast_parted_%d"):format(v[2]) } }
  for _, block in ipairs(sim.blocks) do block.velocity = { v[block.centroid[1] > 1.5 and 2 or 1], 0 } end
  sim:run()
  check.above("parted: bonds that failed", sim.totals.failures, 0)
  check.equal("parted: behind the line", blast.backbreak(sim, { line = 0 }).length, 0)
  check.near("parted: behind a line 2.5 m farther, m", blast.backbreak(sim, { line = 2.5 }).depth, 2, { rel = 1e-9 })
end

-- Gas on its way along a joint: from the hole's wall to its front on both sides.
do
  local speed, t, radius = 50, 5*u.ms, 0.05
  local sim = talus.simulation {
    regions = { talus.region { name = "halves", outline = talus.rect(0, 0, 2, 1), material = rock,
      holes = { talus.circle { at = {1, 0.5}, radius = radius, name = "hole" } }, cuts = { talus.trace { points = {{1, -1}, {1, 2}} } } } },
    charges = { talus.charge { hole = "hole", eos = talus.eos.polytropic { pressure = 5*u.MPa }, gas_speed = speed } },
    time = { t_end = t, dt = 0.1*u.ms }, output = { dir = "out/blast_gas" } }
  sim:run()
  local charge = sim.charges[1]
  check.near("gas in the joint, m", charge.reach, 2*(speed*t - radius), { rel = 0.01 })
  check.equal("joints that it has entered", #charge.reached, 2)
  check.near("centre of the hole, m", charge.x, 1, { abs = 1e-12 })
end
