-- Ours. Blocks of second order, single ones and what has broken out of a body: their contacts follow their edges as they bend. They followed the mean of each edge, or its ends: a beam on two ledges bent by 0.2 to 1.8 of what it should, one that had broken out by 1.3 to 3.8, and of 930
-- random scenes 207 had one block in another by more than a hundredth of its size, needles by all of it.
-- And sides with corners that do not turn, as those blocks and what is drawn so have: in a static run two that lay on each other took turns, and there was no equilibrium; a corner that came
-- to lie on one counted twice, and stacks and cohesion were up to 1.5 times what they should, as rounding would have it. What slid over the sides of a soft meshed body of second order, which stand off each
-- other where its blocks meet, was pressed by these steps: up to 8.6 times the energy of a scene unexplained.
-- Source: a beam of constant curvature with shear (theory, § 1); the same pile without those corners; blocks and springs in a row; Coulomb; a corner is judged at y and shown at X, (θ-½)Δt v farther on, and edges are drawn by their chords (theory, § 1).
-- Run: scripts/run tests/hard/58_bent_edges.lua    (8 s CPU)
local talus = require "talus"
local u, check, tools = talus.units, talus.check, require "tools"
local quiet = { vtk = false, picture = false }

-- Sag of a beam on ledges 2x apart, over the closed form: v = ax², u = -cxy. `nub`: one is bonded to it, breaks off by its weight and falls away.
local function sag(height, x, mode, nub)
  local long, density, gravity, young = 4, 2500, 10, 10*u.GPa
  local rock = talus.material { name = "rock", density = density, young = young, poisson = 0, plane = "stress" }
  local weak = talus.joint { name = "weak", friction = 0, tension = 100, cohesion = 100, stiffness = 1000 }
  local l, dynamic = long/2, mode == "dynamic"
  local sim = talus.simulation { gravity = {0, -gravity}, contact = talus.joint { friction = 0, stiffness = 1000 }, output = quiet,
    regions = { talus.region { name = "left", outline = talus.rect(-l - 0.5, -1, -x, 0), material = rock, held = true },
                talus.region { name = "right", outline = talus.rect(x, -1, l + 0.5, 0), material = rock, held = true },
                talus.region { name = "beam", material = rock, order = 2,
                  outline = nub and { {-l, 0}, {-0.2, 0}, {-0.2, -0.3}, {0.2, -0.3}, {0.2, 0}, {l, 0}, {l, height}, {-l, height} } or talus.rect(-l, 0, l, height),
                  cuts = nub and { talus.trace { points = { {-0.2, 0}, {0.2, 0} }, joint = weak, bonded = true } } } },
    fix = { talus.fix { region = "beam", on = talus.point(0, height/2), x = true } },
    probes = { middle = {0, height/2}, left = {-l, height/2}, right = {l, height/2} },
    time = { mode = mode, start = dynamic and not nub and "settled" or nil, t_end = nub and 2 or 0.1, dt = nub and 0.01 or nil } }
  sim:run()
  local force = density*gravity*height*long*(x^2 - long^2/12)
  local a = force/(4*young*height^3/12*long) + 3*force/(young/2*height*long^3)
  return ((sim.probes.left.uy + sim.probes.right.uy)/2 - sim.probes.middle.uy)/(a*long^2/4)
end
for _, x in ipairs {1.97, 1.75, 1.5, 1.3} do
  for _, height in ipairs {1, 0.4, 0.1} do
    check.near(("beam of 4 x %g m on ledges %g m apart: sag over the closed form"):format(height, 2*x), sag(height, x, "static"), 1, { abs = 0.0015 })
  end
  check.near(("the same of 0.4 m in motion, a nub of which has broken off, %g m: sag over the closed form"):format(2*x), sag(0.4, x, "dynamic", true), 1, { abs = 0.0015 })
end
check.near("the same in motion, 0.4 m, 3 m: sag over the closed form", sag(0.4, 1.5, "dynamic"), 1, { abs = 0.0015 })

-- A square under 100 MPa from above and 80 from the side, on rollers: shortening over the elastic one. `made`: of what, fields of its region.
local function shortening_of(made)
  local young = 55*u.GPa
  made.name, made.material = "square", talus.material { name = "rock", density = 2600, young = young, poisson = 0.3, plane = "stress" }
  local sim = talus.simulation { contact = talus.joint { friction = 45*u.deg }, output = quiet, time = { mode = "static" }, regions = { talus.region(made) },
    fix = { talus.fix { region = "square", on = talus.line(0, 0, 1, 0), y = true }, talus.fix { region = "square", on = talus.line(0, 0, 0, 1), x = true } },
    loads = { talus.edge_load { region = "square", on = talus.line(0, 1, 1, 1), traction = {0, -100*u.MPa} },
              talus.edge_load { region = "square", on = talus.line(1, 0, 1, 1), traction = {-80*u.MPa, 0} } },
    probes = { top = {0.51, 0.99999} } }
  sim:run()
  return -sim.probes.top.uy*young/(76*u.MPa)
end

-- Of loose triangles, with a corner in the middle of each side or without.
local function shortening(order, n, middles)
  local blocks = {}
  local function add(...)
    local corners, outline = {...}, {}
    for k, p in ipairs(corners) do
      local q = corners[k % 3 + 1]
      outline[#outline + 1] = p
      if middles then outline[#outline + 1] = { (p[1] + q[1])/2, (p[2] + q[2])/2 } end
    end
    blocks[#blocks + 1] = outline
  end
  for i = 0, n - 1 do
    for j = 0, n - 1 do
      local a, b, c, d = {i/n, j/n}, {(i + 1)/n, j/n}, {(i + 1)/n, (j + 1)/n}, {i/n, (j + 1)/n}
      local even = (i + j) % 2 == 0
      add(a, b, even and c or d)
      add(even and a or b, c, d)
    end
  end
  return shortening_of { blocks = blocks, order = order }
end
for _, n in ipairs {6, 8, 12} do
  local plain = shortening(1, n, false)
  check.near(("%d loose triangles with corners in their sides: shortening, over that without"):format(2*n^2), shortening(1, n, true)/plain, 1, { abs = 2e-6 })
  check.near(("%d loose triangles of second order: shortening, over that of first"):format(2*n^2), shortening(2, n, false)/plain, 1, { abs = 2e-5 })
end

-- The same of a square that joints cut.
local function cut_square(order, n)
  local joint, cuts = talus.joint { friction = 45*u.deg, cohesion = 1*u.MPa }, {}
  local function cut(...) cuts[#cuts + 1] = talus.trace { points = {...}, joint = joint } end
  for k = 1, n - 1 do
    cut({k/n, -1}, {k/n, 2})
    cut({-1, k/n}, {2, k/n})
  end
  for k = 1 - n, n - 1 do cut({-1, k/n - 1}, {2, k/n + 2}) end
  return shortening_of { outline = talus.rect(0, 0, 1, 1), cuts = cuts, order = order }
end
for _, n in ipairs {4, 12} do
  check.near(("a square that joints cut into %d triangles: shortening, second order over first"):format(2*n^2), cut_square(2, n)/cut_square(1, n), 1, { abs = 5e-4 })
end

-- A stack of four on joints as soft as themselves: shortening over that of blocks and springs in a row.
local function stack(order, parts, degrees, shift)
  local c, s, young, pressure = math.cos(math.rad(degrees)), math.sin(math.rad(degrees)), 10*u.GPa, 1*u.MPa
  local function at(x, y) return { c*x - s*y + shift, s*x + c*y + shift } end
  local blocks = {}
  for k = 0, 3 do
    local outline = {}
    local function side(x, y, dx, dy) for i = 0, parts - 1 do outline[#outline + 1] = at(x + dx*i/parts, y + dy*i/parts) end end
    side(0, k, 1, 0)
    side(1, k, 0, 1)
    side(1, k + 1, -1, 0)
    side(0, k + 1, 0, -1)
    blocks[k + 1] = outline
  end
  local function line(y)
    local from, to = at(0, y), at(1, y)
    return talus.line(from[1], from[2], to[1], to[2])
  end
  local sim = talus.simulation { contact = talus.joint { friction = 0.7, stiffness = { per = "area", value = young } }, output = quiet, time = { mode = "static" },
    regions = { talus.region { name = "stack", blocks = blocks, order = order, material = talus.material { name = "rock", density = 2500, young = young, poisson = 0 } } },
    fix = { talus.fix { region = "stack", on = line(0) } }, loads = { talus.edge_load { region = "stack", on = line(4), traction = { s*pressure, -c*pressure } } } }
  sim:run()
  local top = sim.blocks[4]
  return (s*top.ux - c*top.uy)/(6.5*pressure/young)
end
for _, order in ipairs {1, 2} do
  for parts = 1, 3 do
    for _, as in ipairs { {0, 0}, {37, 0}, {0, 1e4}, {37, 1e4} } do
      check.near(("a stack of order %d, sides in %d parts, turned by %g degrees, %g m off: shortening over the closed form"):format(order, parts, as[1], as[2]), stack(order, parts, as[1], as[2]), 1, { abs = 1e-6 })
    end
  end
end

-- A column of second order that a joint with cohesion cuts at 40 degrees: what it slides in half a second, of the cohesion that holds it.
local function slid(part)
  local dip, friction, density, gravity, height = math.rad(40), math.rad(20), 2500, 9.81, 2.2
  local weight, long = density*gravity*2*(height - 0.2 - math.tan(dip)), 2/math.cos(dip)
  local joint = talus.joint { friction = friction, cohesion = part*weight*(math.sin(dip) - math.cos(dip)*math.tan(friction))/long }
  local sim = talus.simulation { gravity = {0, -gravity}, output = quiet, time = { t_end = 0.5, dt = 2e-3 },
    regions = { talus.region { name = "column", outline = talus.rect(0, 0, 2, height), order = 2, material = talus.material { name = "rock", density = density, young = 1*u.GPa, poisson = 0.2 },
                               cuts = { talus.trace { points = { {-0.5, 0.2 - 0.5*math.tan(dip)}, {2.5, 0.2 + 2.5*math.tan(dip)} }, joint = joint } } } },
    fix = { talus.fix { region = "column", on = "bottom" } } }
  sim:run()
  return math.max(sim.blocks[1].u, sim.blocks[2].u)
end
check.above("a joint with 0.95 of the cohesion that holds: slid in 0.5 s, m", slid(0.95), 0.01)
check.below("a joint with 1.05 of it: slid in 0.5 s, m", slid(1.05), 1e-3)

-- A meshed beam of second order on two legs, which a stone hits.
for _, case in ipairs { {10*u.MPa, 5e-4}, {10*u.MPa}, {20*u.MPa} } do
  local soft = talus.material { name = "soft", density = 2500, young = case[1], poisson = 0.2 }
  local sim = talus.simulation { gravity = {0, -9.81}, contact = talus.joint { friction = 0.4 }, output = quiet, time = { t_end = 0.5, dt = case[2] },
    regions = { talus.region { name = "base", outline = talus.rect(-3, -1, 3, 0), held = true, material = soft },
                talus.region { name = "beam", outline = talus.rect(-1.5, 0.3, 1.5, 0.6), order = 2, material = soft, mesh = { kind = "cross", nx = 6, ny = 1 } },
                talus.region { name = "leg 1", outline = talus.rect(-1.3, 0, -1.1, 0.3), order = 2, material = soft },
                talus.region { name = "leg 2", outline = talus.rect(1, 0, 1.2, 0.3), order = 2, material = soft },
                talus.region { name = "stone", outline = { {-0.4, 0.8}, {0.5, 0.7}, {0.3, 1.3}, {-0.3, 1.2} }, order = 2, material = soft, velocity = {0, -2} } } }
  local most = 0
  for _ in sim:steps() do most = math.max(most, math.abs(sim.energy.unexplained)/sim.energy.scale) end
  check.below(("a meshed beam of %g MPa that a stone hits, %s: unexplained energy, of the scale"):format(case[1]/u.MPa, case[2] and "dt given" or "automatic steps"), most, 0.01)
end

-- m, of the deepest corner of one outline in the other.
local function deepest(corners, outline)
  local most = 0
  for _, p in ipairs(corners) do
    local inside, near, from = false, math.huge, outline[#outline]
    for _, to in ipairs(outline) do
      if (to[2] > p[2]) ~= (from[2] > p[2]) and p[1] < (from[1] - to[1])*(p[2] - to[2])/(from[2] - to[2]) + to[1] then inside = not inside end
      local x, y = to[1] - from[1], to[2] - from[2]
      local s = math.max(0, math.min(1, ((p[1] - from[1])*x + (p[2] - from[2])*y)/(x*x + y*y)))
      near, from = math.min(near, math.sqrt((p[1] - from[1] - s*x)^2 + (p[2] - from[2] - s*y)^2)), to
    end
    if inside then most = math.max(most, near) end
  end
  return most
end

-- Plates of 1:10 to 1:40 on two ledges, that a stone hits.
local overlap, unexplained, gain = 0, 0, 0
for _, ratio in ipairs {10, 20, 40} do
  for _, young in ipairs {0.05*u.GPa, 1*u.GPa} do
    for seed = 1, 4 do
      local random, thick = tools.random(71*seed + ratio), 2/ratio
      local rock = talus.material { name = "rock", density = 2500, young = young, poisson = 0.2 }
      local sim = talus.simulation { gravity = {0, -10}, contact = talus.joint { friction = 0.3 }, output = quiet, time = { t_end = 0.4 },
        regions = { talus.region { name = "left", outline = talus.rect(-1.5, -1, -0.8, 0), material = rock, held = true },
                    talus.region { name = "right", outline = talus.rect(0.7, -1, 1.5, 0), material = rock, held = true },
                    talus.region { name = "plate", outline = talus.rect(-1, 0.02, 1, 0.02 + thick), material = rock, order = 2 },
                    talus.region { name = "stone", outline = tools.stone(random, {0.4*random() - 0.2, 0.9}, 0.25 + 0.2*random(), 5, 0.8), material = rock, order = 2,
                                   velocity = {0, -0.01*math.sqrt(young/2500)} } } }
      local before, size, gained = sim.blocks:field "vertices", math.sqrt(2*thick), tools.gains(sim)
      for _ in sim:steps() do
        local now, way = sim.blocks:field "vertices", 0
        for k, outline in ipairs(now) do
          for v, p in ipairs(outline) do way = math.max(way, math.sqrt((p[1] - before[k][v][1])^2 + (p[2] - before[k][v][2])^2)) end
        end
        for _, other in ipairs {1, 2, 4} do
          overlap = math.max(overlap, (math.max(deepest(now[3], now[other]), deepest(now[other], now[3])) - way/4 - thick/20)/size)
        end
        before = now
        unexplained = math.max(unexplained, math.abs(sim.energy.unexplained)/sim.energy.scale)
        gain = math.max(gain, gained())
      end
    end
  end
end
check.below("plates that stones hit: deepest overlap beyond a quarter of the way in a step and a twentieth of the thickness, of the plate's size", overlap, 0.01)
check.below("plates that stones hit: unexplained energy, of the scale", unexplained, 0.01)
check.below("plates that stones hit: largest gain in a step, of what moves and is stored", gain, 1e-4)

-- A block pushed along a joint that only cohesion holds, k times as much as it takes, and pressed so that no end of it opens: it stands from k = 1 on. Where a look for equilibrium had
-- moved it by more than what corners in one place may be apart, and back, a quarter of the face no longer counted: it slid by 4 mm, or away, below k = 1.33.
local function pushed(order, k)
  local push = 1*u.MPa
  local joint = talus.joint { friction = 0, cohesion = k*push, tension = 0 }
  local sim = talus.simulation { contact = talus.joint { friction = 0 }, output = quiet, time = { mode = "static", steps = 10, t_end = 1 }, probes = { top = {0.5, 0.75} },
    regions = { talus.region { name = "rock", outline = talus.rect(0, 0, 1, 1), order = order, material = talus.material { name = "rock", density = 2500, young = 10*u.GPa, poisson = 0.2 },
                  cuts = { talus.trace { points = { {-1, 0.5}, {2, 0.5} }, joint = joint, bonded = false } } } },
    fix = { talus.fix { region = "rock", on = talus.line(0, 0, 1, 0) } },
    loads = { talus.edge_load { region = "rock", on = talus.line(0, 0.5, 0, 1), traction = { { {0, 0}, {1, 2*push} }, 0 } },
              talus.edge_load { region = "rock", on = talus.line(0, 1, 1, 1), traction = {0, -2*push} } } }
  local stands = pcall(function() sim:run() end)
  return stands and sim.probes.top.ux or math.huge
end
for _, order in ipairs {1, 2} do
  check.between(("pushed against 1.02 times the cohesion it takes, order %d: way over that against three times"):format(order), pushed(order, 1.02)/pushed(order, 3), 1, 1.3)
  check.near(("pushed against 0.98 times it, order %d: part that slides away"):format(order), pushed(order, 0.98) == math.huge and 1 or 0, 1, { abs = 0 })
end
