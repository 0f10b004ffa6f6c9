-- Three holes behind the face of a bench, seen from above, fired one after the other: what they cost in fragments, vibration, back-break.
-- Run: scripts/run examples/12_bench_delays.lua                     (20 s CPU; pictures in out/bench_delays)
--      scripts/run examples/12_bench_delays.lua -p size=0.15 -p far=0.4 -p t_end=0.02   finer and longer (many minutes)
--      scripts/run examples/12_bench_delays.lua -p delay=0          all at once
-- Teaches: charges by explosive, density and diameter, delays that scatter, an orifice, talus.blast for a row of holes.
-- Picture: docs/pictures/12_bench_delays.svg
-- Cartridges of 70 mm in holes of 200 mm: the rock round a hole that ANFO fills would be crushed, which blocks of this size cannot show.
-- Source: none for the numbers: a mesh this coarse shows the order of things. Checked is what must hold on any mesh.
local talus = require "talus"
local u = talus.units

local size = talus.param("size", 0.25, "triangle edge near the holes, m")
local far = talus.param("far", 0.6, "triangle edge far from them, m")
local delay = talus.param("delay", 2e-3, "from hole to hole, s")
local scatter = talus.param("scatter", 1e-4, "standard deviation of each delay, s")
local t_end = talus.param("t_end", 12e-3, "end of the run, s")

local burden, spacing, radius = 1.5, 2, 0.1
local rock = talus.material { name = "limestone", density = 2600, young = 30*u.GPa, poisson = 0.25 }
local joint = talus.joint { name = "rock bonds", friction = 40*u.deg, cohesion = 20*u.MPa, tension = 6*u.MPa }

local holes, charges, grade = {}, {}, { far = far }
for i = 1, 3 do
  local name = "hole " .. i
  holes[i] = talus.circle { at = {(i - 2)*spacing, -burden}, radius = radius, sides = 12, name = name }
  grade[i] = { at = name, size = size }
  charges[i] = talus.charge { name = "charge " .. i, hole = name, explosive = "ANFO", density = 850, diameter = 70*u.mm,
                              delay = (i - 1)*delay, delay_scatter = scatter, seed = 12, gas_speed = 250,
                              venting = talus.venting.orifice {} }
end

local fired = {}
local sim = talus.simulation {
  title = "Three holes with delays, seen from above",
  regions = { talus.region { name = "bench", outline = talus.rect(-5, -5, 5, 0), material = rock, joint = joint, holes = holes,
                             mesh = { size = talus.grade(grade) } } },
  boundaries = { talus.viscous { region = "bench", on = {"left", "right", "bottom"} } },
  charges = charges,
  probes = { near = {0, -2.5}, middle = {0, -3.5}, far = {0, -4.8} },
  time = { t_end = t_end, dt_max = 5e-5 },
  output = { dir = "out/bench_delays", every = t_end/6, picture = "speed" },
  on_gas = function(sim, events)
    for _, event in ipairs(events) do
      if event.kind == "detonation" then fired[#fired + 1] = event.time end
      sim:log("%s of %s: %.3g m3, %.4g MPa", event.kind, event.charge, event.volume, event.pressure/u.MPa)
    end
  end,
}
sim:run()

local sizes = talus.blast.fragmentation(sim, { file = "sizes" })
local vibration = talus.blast.vibration(sim, { at = "charge 2", file = "vibration" })
local line = -burden - radius
local behind = talus.blast.backbreak(sim, { line = talus.line(-5, line, 5, line), behind = "right", file = "backbreak" })
local broken = 0
for _, crack in ipairs(sim.cracks) do broken = broken + crack.length end
local energy, charge, points = sim.energy, sim.charges[1], vibration.points

-- kg/m and momentum towards the face, in front of the row and behind it
local front, back = { mass = 0, momentum = 0 }, { mass = 0, momentum = 0 }
for _, block in ipairs(sim.blocks) do
  local part = block.centroid[2] - block.uy > -burden and front or back
  part.mass, part.momentum = part.mass + block.mass, part.momentum + block.mass*block.velocity[2]
end

print(string.format("%d fragments that have come free, x50 %.2f m (half of the mesh is below %.2f m)", sizes.count, sizes.x50, sizes.floor))
print(string.format("%.2f kg/m a hole; peak velocity %.2f m/s at %.1f m, %.2f m/s at %.1f m: PPV = %.2f (R/√W)^-%.2f", charge.mass,
  points[1].ppv, points[1].distance, points[#points].ppv, points[#points].distance, vibration.K, vibration.beta))
print(string.format("back-break %.1f m of %.1f m of cracks, as far as %.1f m behind the row", behind.length, broken, behind.depth))
print(string.format("the gas gave %.2f MJ/m; of the first charge's gas %.0f %% has not escaped; the burden moves at %.1f m/s", energy.gas/1e6,
  100*charge.left, front.momentum/front.mass))

talus.check.near("mass of a charge, kg/m", charge.mass, 850*math.pi/4*0.07^2, { rel = 1e-12 })
talus.check.equal("charges that went off", #fired, 3)
local due = { sim.charges[1].delay, sim.charges[2].delay, sim.charges[3].delay }
table.sort(due)
for i = 1, 3 do talus.check.near(("detonation %d, s"):format(i), fired[i] or -1, due[i], { abs = 1e-6 }) end
talus.check.above("velocity towards the face: of the burden, beside that behind the row", front.momentum/front.mass,
  10*math.abs(back.momentum/back.mass))
talus.check.above("cracks in front of the row, beside those behind it, m", broken - behind.length, behind.length)
talus.check.above("vibration falls with distance: β", vibration.beta, 0)
talus.check.between("part of the first charge's gas left", charge.left, 0, 1)
local work, chambers = 0, {}  -- charges whose chambers have merged have one, with one volume and work
for i = 1, 3 do
  local chamber = sim.charges[i]
  if not chambers[chamber.volume] then work = work + chamber.work end
  chambers[chamber.volume] = true
end
talus.check.near("gas's work on the rock against its law's", energy.gas, work, { rel = 0.005 })
talus.check.near("ledger: unexplained, of the gas's work", energy.unexplained/energy.gas, 0, { abs = 0.01 })
