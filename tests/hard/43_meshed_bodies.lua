-- 43. Bodies of bonded blocks, whose corner belongs to two of them, against what is met at that corner: slide from one flush slab to the next
-- (vx to 1e-5), over a loose tip that comes out between two (case 10's friction), rest on a short bearing (no thrust, the sag of the same beam on pins), fall past a table that they touch.
-- Source: momentum; statics; Timoshenko & Goodier, § 22, with the shear of a rectangle, 6/5; free fall. Ours: the side face of the corner's other block was
-- taken for a wall: bodies stopped at the joint at every step, ledges thrust at beams by three times their weight, and what touched a table hung on it. (5 s CPU)
-- Run: scripts/run tests/hard/43_meshed_bodies.lua -p full=true      (quick: fewer meshes and steps)
local talus = require "talus"
local full = talus.param("full", false, "all meshes and steps")
local g = 9.81
local rock = talus.material { name = "rock", density = 2500, young = 30e9, poisson = 0.2 }
local smooth = talus.joint { name = "smooth", friction = 0 }
local A, B, C, D, M = {-1.5, 0}, {-0.5, 0}, {-0.5, 1}, {-1.5, 1}, {-1, 0.5}
local bodies = {
  ["two triangles, one whole at the corner"] = { blocks = { {A, B, C}, {A, C, D} }, bonded = true },
  ["two triangles that share the corner"] = { blocks = { {A, B, D}, {B, C, D} }, bonded = true },
  ["four triangles"] = { blocks = { {A, B, M}, {B, C, M}, {C, D, M}, {D, A, M} }, bonded = true },
  ["triangles of 0.3 m"] = { outline = {A, B, C, D}, mesh = { size = 0.3 } },
}
if full then
  for _, kind in ipairs { "cross", "diagonal", "alternating" } do bodies[kind] = { outline = {A, B, C, D}, mesh = { kind = kind, nx = 3, ny = 3 } } end
  bodies.voronoi = { outline = {A, B, C, D}, mesh = { kind = "voronoi", size = 0.3 } }
end
local names = {}
for name in pairs(bodies) do names[#names + 1] = name end
table.sort(names)

local function body(name, more)
  local region = { name = "body", material = rock }
  for key, value in pairs(bodies[name]) do region[key] = value end
  for key, value in pairs(more) do region[key] = value end
  return talus.region(region)
end
local function mean_speed(sim)
  local mass, momentum = 0, 0
  for k = 1, #sim.blocks do
    local b = sim.blocks[k]
    if b.region == "body" then mass, momentum = mass + b.mass, momentum + b.mass*b.velocity[1] end
  end
  return momentum/mass
end

for _, name in ipairs(names) do
  local slowest, rest, cuts = 1, 0, 0
  for _, meshed in ipairs { false, true } do
    for _, gap in ipairs(full and { 0, 1e-6, 1e-3, 0.1 } or { 0, 1e-3 }) do
      for _, order in ipairs(full and { "rigid", 1, 2 } or { "rigid", 2 }) do
        for _, dt in ipairs(full and { 1e-2, 1e-3 } or { 5e-3 }) do
          local sim = talus.simulation {
            gravity = {0, -g}, contact = smooth,
            regions = { body(name, { velocity = {1, 0}, order = order }),
                        talus.region { name = "slab", outline = talus.rect(-4, -1, 0, 0), material = rock, held = true, mesh = meshed and { kind = "cross", nx = 4, ny = 1 } or nil },
                        talus.region { name = "next", outline = talus.rect(gap, -1, 4, 0), material = rock, held = true, mesh = meshed and { kind = "cross", nx = 4, ny = 1 } or nil } },
            time = { mode = "dynamic", t_end = 0.8, dt = dt, start = "settled" },
          }
          sim:run()
          slowest = math.min(slowest, mean_speed(sim))
          rest, cuts = math.max(rest, math.abs(sim.energy.unexplained/sim.energy.scale)), math.max(cuts, sim.totals.cuts)
        end
      end
    end
  end
  talus.check.near("slide over a joint, " .. name .. ": slowest of all at the end, m/s", slowest, 1, { abs = 1e-5 })
  talus.check.below("slide over a joint, " .. name .. ": energy unexplained", rest, 1e-3)
  talus.check.below("slide over a joint, " .. name .. ": cuts of a run", cuts, 2)
end

-- Over a piece between open joints that has only its tip in the surface, as where cracks come out: Coulomb, v = v0 − μ g t.
local mu = 0.2
local rough = talus.joint { name = "rough", friction = math.atan(mu) }
for _, tip in ipairs { { "upright", 0, 1 }, { "leaning", 1, 0.2 }, { "symmetrical", 0.5, 0.5 }, { "blunt", 1, 1 } } do
  local label, left, right = table.unpack(tip)  -- m, of its sides at 1 m below
  local off, cuts = 0, 0
  for _, gap in ipairs { 0, 1e-6, 1e-3 } do
    for _, order in ipairs { "rigid", 1 } do
      for _, dt in ipairs { 1e-3, 5e-3 } do
        for _, name in ipairs { "two triangles that share the corner", "triangles of 0.3 m" } do
          local sim = talus.simulation {
            gravity = {0, -g}, contact = rough,
            regions = { body(name, { velocity = {2, 0}, order = order }),
                        talus.region { name = "slab", blocks = { { {-4, -1}, {-left, -1}, {0, 0}, {-4, 0} } }, material = rock, held = true },
                        talus.region { name = "tip", blocks = { { {gap, 0}, {gap - left, -1}, {gap + right, -1} } }, material = rock, held = true },
                        talus.region { name = "next", blocks = { { {2*gap, 0}, {2*gap + right, -1}, {4, -1}, {4, 0} } }, material = rock, held = true } },
            time = { mode = "dynamic", t_end = 0.6, dt = dt, start = "settled" },
          }
          sim:run()
          off, cuts = math.max(off, math.abs(mean_speed(sim) - (2 - mu*g*0.6))), math.max(cuts, sim.totals.cuts)
        end
      end
    end
  end
  talus.check.below("slide over a loose tip, " .. label .. ": speed off, m/s", off, 1e-4)
  talus.check.below("slide over a loose tip, " .. label .. ": cuts of a run", cuts, 2)
end

-- A square on two ledges: their forces are its weight, and nothing along them.
for _, name in ipairs(names) do
  local thrust, off = 0, 0
  for _, bearing in ipairs { 1e-3, 0.02, 0.1 } do
    local sim = talus.simulation {
      gravity = {0, -g}, contact = smooth,
      regions = { body(name, {}), talus.region { name = "left", outline = talus.rect(-1.8, -0.3, -1.5 + bearing, 0), material = rock, held = true },
                  talus.region { name = "right", outline = talus.rect(-0.5 - bearing, -0.3, -0.2, 0), material = rock, held = true } },
      fix = { talus.fix { name = "left", region = "left" }, talus.fix { name = "right", region = "right" },
              talus.fix { name = "middle", region = "body", on = talus.point(D[1], D[2]), x = true } }, time = { mode = "static" },
    }
    sim:run()
    local l, r = sim.reactions.left, sim.reactions.right
    thrust = math.max(thrust, math.abs(l[1]), math.abs(r[1]))
    off = math.max(off, math.abs(l[2] + r[2] - 2500*g))
  end
  talus.check.below("on two ledges, " .. name .. ": thrust over the weight (its faces tilt as it bends)", thrust/(2500*g), 1e-5)
  talus.check.below("on two ledges, " .. name .. ": forces less the weight over the weight", off/(2500*g), 1e-5)
end

-- A beam of 4 x 0.2 m on ledges: 5wL⁴/384EI and, by shear, 6/5 wL²/8GA, plane stress; a corner bears in its first point, whatever the ledge's length.
local function sag(mesh, bearing)
  local E, nu, w, h, L = 30e9, 0.2, 2500*g*0.2, 0.2, 4 - 2*bearing
  local sim = talus.simulation {
    gravity = {0, -g}, contact = smooth,
    regions = { talus.region { name = "beam", outline = talus.rect(0, 0, 4, h), material = rock, order = 2, mesh = mesh },
                talus.region { name = "left", outline = talus.rect(-0.3, -0.3, bearing, 0), material = rock, held = true },
                talus.region { name = "right", outline = talus.rect(4 - bearing, -0.3, 4.3, 0), material = rock, held = true } },
    fix = { talus.fix { region = "beam", on = talus.point(2, 0), x = true } },
    probes = { middle = { at = {2, h/2}, region = "beam" } }, time = { mode = "static" },
  }
  sim:run()
  local bending, shear = (5*w*L^4/384 - w*bearing^2/2*L^2/8)/(E*h^3/12), 1.2*w*L^2/8/(E/(2*(1 + nu))*h)
  return -sim.probes.middle.uy/(bending + shear)
end
local meshes = { ["triangles of 0.1 m"] = { size = 0.1 }, ["cross"] = { kind = "cross", nx = 16, ny = 1 }, ["diagonal"] = { kind = "diagonal", nx = 32, ny = 2 } }
for _, name in ipairs { "triangles of 0.1 m", "cross", "diagonal" } do
  for _, bearing in ipairs(full and { 1e-3, 5e-3, 0.02, 0.05, 0.1 } or { 1e-3, 0.02 }) do
    talus.check.near(string.format("beam on bearings of %g mm, %s: sag over that of the theory", 1e3*bearing, name), sag(meshes[name], bearing), 1, { abs = 2e-3 })
  end
end

-- Past a table, touching it: free fall.
for _, name in ipairs(names) do
  local least, turn = math.huge, 0
  for _, clearance in ipairs { 0, 1e-7, 1e-3 } do
    local sim = talus.simulation {
      gravity = {0, -g}, contact = smooth,
      regions = { body(name, {}), talus.region { name = "table", outline = talus.rect(-4, -4, -1.5 - clearance, -0.05), material = rock, held = true } },
      time = { mode = "dynamic", t_end = 0.6, dt = 1e-3 }, probes = { centre = { at = {-1.01, 0.49}, region = "body" } },
    }
    sim:run()
    least, turn = math.min(least, -sim.probes.centre.uy), math.max(turn, math.abs(sim.blocks[1].rotation))
  end
  talus.check.near("past a table, " .. name .. ": fell least of all, m", least, g*0.6^2/2, { rel = 1e-9 })
  talus.check.below("past a table, " .. name .. ": turned, rad", turn, 1e-9)
end
