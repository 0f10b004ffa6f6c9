-- 67. Bonds that break while their faces are pressed make no energy. Squares of Voronoi grains and of triangles, of either
-- order, some small, some large and far off, thrown at a floor and burst by their spin; brittle and softening.
-- Source: energy is not made (no step may raise the total by 1e-6 of it), and fracture takes it: the work of fracture never falls.
-- Ours: a grain that is stretched into its neighbours pulls its bonds apart by its stress while all of them overlap; one that
-- failed left more energy than there was, 1.5e-2 of it in a step. (3 s CPU)
local talus = require "talus"
local u = talus.units
local no_files = { vtk = false, picture = false }

local function burst(case)
  local size, speed, at = case.size or 1, case.speed or 5, case.at or 0
  local joint = talus.joint { name = "bond", friction = 35*u.deg, cohesion = 4*u.MPa, tension = 1*u.MPa,
    reduction = case.energy and talus.laws.softening { G_I = case.energy, G_II = 10*case.energy } }
  local rock = talus.material { name = "rock", density = 2500, young = case.young, poisson = 0.2 }
  local regions = {
    talus.region { name = "square", outline = talus.rect(at, 0.004*size, at + size, 1.004*size), material = rock, joint = joint,
      mesh = { size = 0.28*size, kind = case.kind }, order = case.order,
      velocity = case.spin and {0, 0} or {0.3*speed, -speed}, spin = case.spin } }
  if not case.spin then
    regions[2] = talus.region { name = "floor", outline = talus.rect(at - 2*size, -size, at + 3*size, 0), material = rock, held = true }
  end
  local sim = talus.simulation { contact = talus.joint { name = "faces", friction = 0.6 }, regions = regions, output = no_files,
    time = { t_end = (case.t_end or 8*u.ms)*size, dt = case.dt*size } }
  local before, rise, falls = sim.energy, 0, 0
  for _ in sim:steps() do
    local now = sim.energy
    rise = math.max(rise, (now.total - before.total)/before.total)
    falls = math.max(falls, (before.fracture - now.fracture)/before.total)
    before = now
  end
  return sim, rise, falls
end

local cases = {
  { "grains, 1 GPa", kind = "voronoi", young = 1*u.GPa, dt = 1e-5 },
  { "grains, 10 GPa, 2 m/s", kind = "voronoi", young = 10*u.GPa, speed = 2, dt = 1e-5 },
  { "grains of 30 m, far off", kind = "voronoi", young = 1*u.GPa, size = 30, at = 10*u.km, dt = 5e-5 },
  { "grains of second order", kind = "voronoi", young = 1*u.GPa, order = 2, dt = 2e-5 },
  { "grains that soften", kind = "voronoi", young = 1*u.GPa, energy = 2000, dt = 1e-5 },
  { "triangles", young = 1*u.GPa, dt = 1e-5 },
  { "triangles of a centimetre, long steps", young = 10*u.GPa, size = 0.01, dt = 2e-4 },
  { "grains that spin", kind = "voronoi", young = 10*u.GPa, spin = 80, t_end = 20*u.ms, dt = 2e-5 },
}
for _, case in ipairs(cases) do
  local sim, rise, falls = burst(case)
  local label = case[1] .. ": "
  talus.check.above(label .. "bonds that failed", sim.totals.failures, 10)
  talus.check.below(label .. "largest rise of the total energy in a step, of it", rise, 1e-6)
  talus.check.below(label .. "largest fall of the work of fracture in a step, of the energy", falls, 1e-9)
  talus.check.below(label .. "unexplained, of the energy at the start", math.abs(sim.energy.unexplained)/sim.energy.scale, 0.01)
end
