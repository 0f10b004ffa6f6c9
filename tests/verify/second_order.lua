-- Second-order blocks: the paper's cantilever against 2D elasticity (quadratic finite elements, converged to the digits given), blocks
-- of all orders in one plate, a spinning disc (Timoshenko & Goodier, § 32) and a P wave (c = sqrt(E/rho)). Rates of convergence on a
-- smooth solution are tests/unit/test_convergence.cpp. (12 s CPU)
local talus = require "talus"
local u = talus.units
local patience = talus.param("full", false, "hold times to their bounds") and 1 or 2
local rock = talus.material { name = "rock", density = 2500, young = 35*u.GPa, poisson = 0.3, plane = "stress" }
local xs = { 1, 2, 3, 4, 5, 6, 7, 7.9 }
local tip, elastic_s = -2.845853e-4, { 2.069918e5, 1.77e5, 1.47e5, 1.17e5, 8.700005e4, 5.699389e4, 2.734290e4 }
local elastic_t = { -7526.165, -7499.98, -7499.996, -7499.997, -7499.998, -7499.99, -7516.864 }

local function cantilever(size, order, penalty)
  local probes = {}
  for i, x in ipairs(xs) do
    probes["a" .. i] = {x, 0.5}
    probes["t" .. i] = {x, 1}
  end
  local sim = talus.simulation {
    regions = { talus.region { name = "beam", outline = talus.rect(0, 0, 8, 1), material = rock, mesh = { size = size }, order = order,
                               joint = talus.joint { name = "bond", penalty = penalty } } },
    fix = { talus.fix { region = "beam", on = "left" } },
    loads = { talus.point_load { at = {7.9, 1}, force = {0, -5*u.kN} } },
    probes = probes, time = { mode = "static" },
  }
  sim:run()
  return sim
end
local function tip_error(sim) return sim.probes.a8.uy/tip - 1 end
-- The CPU time of one assembly, and of one factor and solve, of the few that an equilibrium of a body that also turns takes.
local function seconds_of(sim)
  local all = sim.totals.seconds
  return all.assembly/sim.totals.factorisations, all["open-close and solve"]/sim.totals.factorisations
end

local function check_stress(label, sim, bound_s, bound_t)
  for i = 1, 7 do
    talus.check.near(label .. "sigma x at " .. xs[i], sim.probes["t" .. i].sxx, elastic_s[i], { rel = bound_s })
    talus.check.near(label .. "tau at " .. xs[i], sim.probes["a" .. i].sxy, elastic_t[i], { rel = bound_t })
  end
end
local fine, coarse = cantilever(0.12, 2), cantilever(0.25, 2)
talus.check.near("1378 blocks: tip deflection, m", fine.probes.a8.uy, tip, { rel = 2e-4 })
check_stress("1378 blocks: ", fine, 0.0025, 0.0015)
talus.check.near("316 blocks: tip deflection, m", coarse.probes.a8.uy, tip, { rel = 6e-4 })
check_stress("316 blocks: ", coarse, 0.003, 0.026)

-- CPU times: the least of three. Beside other tests, on a machine that may be another, twice the bound is allowed.
local function least_seconds(size, order)
  local assembly, solve, sim = math.huge, math.huge, nil
  for _ = 1, 3 do
    sim = cantilever(size, order)
    local a, s = seconds_of(sim)
    assembly, solve = math.min(assembly, a), math.min(solve, s)
  end
  return solve, assembly + solve, sim
end
local first_solve, second_solve = least_seconds(0.12, 1), least_seconds(0.12, 2)
local _, few_seconds = least_seconds(0.25, 2)
talus.check.below("1378 blocks of first order: factor and solve, ms", 1e3*first_solve, 15*patience)
talus.check.below("1378 blocks: factor and solve, ms", 1e3*second_solve, 60*patience)
talus.check.below("316 blocks: assembly, factor and solve, ms", 1e3*few_seconds, 30*patience)

for _, times in ipairs { 10, 100, 1000 } do
  local stiff = cantilever(0.12, 2, 1.1*times)
  talus.check.near(("penalty x %d: tip deflection against that at the default"):format(times), stiff.probes.a8.uy/fine.probes.a8.uy, 1,
                   { abs = 5e-4 })
end

-- To 0.1 % in the tip: first-order blocks of 0.04 m are at the edge of it.
local _, slow_seconds, slow = least_seconds(0.04, 1)
talus.check.above("first order at 0.04 m: tip error", math.abs(tip_error(slow)), 0.0009)
talus.check.below("second order at 0.25 m: tip error", math.abs(tip_error(coarse)), 0.001)
talus.check.above("time to 0.1 %, first order over second", slow_seconds/few_seconds, 20/patience)

-- Rigid, first- and second-order blocks mixed. Under one stress those that deform are exact, whatever lies beside; with no rigid
-- ones among them that holds of the whole plate.
local soft = talus.material { density = 2500, young = 1*u.GPa, poisson = 0.25 }
local plate = talus.simulation {
  regions = { talus.region { name = "plate", outline = talus.polygon { {0, 0}, {2, 0}, {2, 1}, {0, 1} }, material = soft, mesh = { size = 0.2 },
                             order = function(x, y) return math.floor(7*x + 11*y) % 2 + 1 end } },
  fix = { talus.fix { region = "plate", on = "left", x = true }, talus.fix { region = "plate", on = "bottom", y = true } },
  loads = { talus.edge_load { region = "plate", on = "right", traction = {200, 0} }, talus.edge_load { region = "plate", on = "top", traction = {0, -100} } },
  time = { mode = "static" },
}
plate:run()
local off, orders = 0, { 0, 0 }
for _, block in ipairs(plate.blocks) do
  orders[block.order] = orders[block.order] + 1
  off = math.max(off, math.abs(block.sxx - 200), math.abs(block.syy + 100), math.abs(block.sxy))
end
talus.check.above("mixed plate: blocks of each order", math.min(orders[1], orders[2]), 40)
talus.check.below("mixed plate: largest error of a stress, of 200 Pa", off/200, 2e-6)

-- Loose triangles, halved squares, pressed together: under one stress blocks of any order are as stiff as the bodies that they are of,
-- but for their contacts, which are as many and as stiff at both orders. By corner forces on bent corners they were 2.6 times as soft.
local function pressed(order, n)
  local young, poisson, down, side = 55*u.GPa, 0.3, 100*u.MPa, 80*u.MPa
  local halves = {}
  for i = 0, n - 1 do
    for j = 0, n - 1 do
      local a, b, c, d = {i/n, j/n}, {(i + 1)/n, j/n}, {(i + 1)/n, (j + 1)/n}, {i/n, (j + 1)/n}
      local even = (i + j) % 2 == 0
      halves[#halves + 1] = even and {a, b, c} or {a, b, d}
      halves[#halves + 1] = even and {a, c, d} or {b, c, d}
    end
  end
  local sim = talus.simulation {
    regions = { talus.region { name = "square", blocks = halves, order = order,
                               material = talus.material { density = 2600, young = young, poisson = poisson, plane = "stress" } } },
    contact = talus.joint { friction = 45*u.deg },
    fix = { talus.fix { region = "square", on = talus.line(0, 0, 1, 0), y = true }, talus.fix { region = "square", on = talus.line(0, 0, 0, 1), x = true } },
    loads = { talus.edge_load { region = "square", on = talus.line(0, 1, 1, 1), traction = {0, -down} },
              talus.edge_load { region = "square", on = talus.line(1, 0, 1, 1), traction = {-side, 0} } },
    probes = { top = {0.51, 0.99999} }, time = { mode = "static" } }
  sim:run()
  return sim.probes.top.uy/(-(down - poisson*side)/young)
end
for _, n in ipairs { 4, 16 } do
  local first, second = pressed(1, n), pressed(2, n)
  -- Contacts of 100 E/h add h/100 E a joint, and between halves of squares there are two joints in the way h: a part of 0.02, or by a half
  -- more where the mean size of the blocks, not their height, is h.
  talus.check.between(("%d loose triangles of first order: shortening over the elastic one"):format(2*n^2), first, 1, 1.03)
  talus.check.near(("%d loose triangles: shortening, second order over first"):format(2*n^2), second/first, 1, { abs = 2e-5 })
end

-- A free disc for ten turns; the outline has 32 sides, and its own area is taken for that of the disc.
local radius, spin, density, poisson = 1, 50, 2500, 0.25
local turn = 2*math.pi/spin
local disc = talus.simulation {
  regions = { talus.region { name = "disc", outline = talus.circle { at = {0, 0}, radius = radius, sides = 32 }, order = 2, spin = spin,
                             material = talus.material { density = density, young = 20*u.GPa, poisson = poisson }, mesh = { size = 0.4 } } },
  probes = { centre = {0, 0} }, time = { mode = "dynamic", t_end = 10*turn, dt = turn/200 },
}
local function area()
  local sum = 0
  for _, a in ipairs(disc.blocks:field "area") do sum = sum + a end
  return sum
end
local first_area, means, sum, count, areas = area(), {}, 0, 0, {}
for _ in disc:steps() do
  sum, count = sum + (disc.probes.centre.sxx + disc.probes.centre.syy)/2, count + 1
  if count == 200 then
    means[#means + 1], areas[#areas + 1] = sum/count, area()
    sum, count = 0, 0
  end
end
talus.check.near("disc of 60 blocks, 10th turn: mean stress at the centre, Pa", means[10],
                 (3 + poisson)/8*density*spin^2*first_area/math.pi, { rel = 0.002 })
talus.check.near("disc: stress of the 10th turn against the 3rd", means[10]/means[3], 1, { abs = 1e-9 })
talus.check.near("disc: area after the 10th turn against the 3rd", areas[10]/areas[3], 1, { abs = 1e-12 })

-- A sine along a bar, as in waves.lua: 6 and 12 blocks a wavelength do what 24 and 48 of first order do not.
local h, steps = 0.1, 160
local bar_rock = talus.material { density = 2500, young = 10*u.GPa, poisson = 0 }
local c = math.sqrt(10*u.GPa/2500)
local function phase(seen)
  local a, b = 0, 0
  for i = 1, steps do
    local v, angle = seen[#seen - steps + i], 2*math.pi*i/steps
    a, b = a + v*math.cos(angle), b + v*math.sin(angle)
  end
  return math.atan(b, a)
end
local function phase_speed(per_length)
  local length = per_length*h
  local period, blocks = length/c, 4*per_length
  local cuts = {}
  for i = 1, blocks - 1 do cuts[i] = talus.trace { points = { {i*h, 0}, {i*h, h} }, bonded = true } end
  local function push(t) return 1e6*math.sin(math.pi/2*math.min(t/(2*period), 1))^2*math.sin(2*math.pi*t/period) end
  local sim = talus.simulation {
    regions = { talus.region { name = "bar", outline = talus.rect(0, 0, blocks*h, h), material = bar_rock, cuts = cuts, order = 2 } },
    fix = talus.fix { region = "bar", on = {"top", "bottom"}, y = true },
    loads = talus.edge_load { region = "bar", on = "left", traction = { push, 0 } },
    boundaries = talus.viscous { region = "bar", on = "right" },
    probes = { near = {length, h/2}, far = {3*length, h/2} }, numerics = { theta = 0.5, recovery = false },
    time = { mode = "dynamic", t_end = 8*period, dt = period/steps, displacement_ratio = 0.1 },
  }
  local near, far = {}, {}
  for _ in sim:steps() do near[#near + 1], far[#far + 1] = sim.probes.near.vx, sim.probes.far.vx end
  local late = (phase(far) - phase(near) + math.pi) % (2*math.pi) - math.pi
  return 1/(1 + late/(4*math.pi))
end
talus.check.near("P wave, 6 blocks a wavelength: phase speed over c", phase_speed(6), 1, { abs = 1e-3 })
talus.check.near("P wave, 12 blocks a wavelength: phase speed over c", phase_speed(12), 1, { abs = 2e-4 })
