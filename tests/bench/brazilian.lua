-- A disc pressed on two arcs of 7 of its chords: σx at its centre against Hondros (1959), 2P/(π D t)·(sin 2a/a − 1), P = p·D·a.
local talus = require "talus"
local u = talus.units
local size, order = talus.param("size", 2*u.mm, "edge, m"), talus.param("order", 1, "of the blocks")
local radius, chords, P = 25*u.mm, 132, 40*u.kN
local points, loads, a = {}, {}, 7*math.pi/132
for k = 0, chords - 1 do
  local angle = 2*math.pi*(k + 0.5)/chords
  points[k + 1] = { radius*math.sin(angle), radius*math.cos(angle) }
end
for k = 0, chords - 1 do
  local p, q = points[k + 1], points[(k + 1) % chords + 1]
  if math.abs(p[1] + q[1])/2 < radius*math.sin(a) then
    loads[#loads + 1] = talus.pressure { region = "disc", on = talus.segment(p, q), value = P/(2*radius*a) }
  end
end
local sim = talus.simulation {
  regions = { talus.region { name = "disc", outline = talus.polygon(points), mesh = { size = size }, order = order,
                             material = talus.material { density = 2500, young = 10*u.GPa, poisson = 0.2, plane = "stress" } } },
  fix = { talus.fix { region = "disc", on = talus.point(-0.99*radius, 0) }, talus.fix { region = "disc", on = talus.point(0.99*radius, 0), y = true } },
  loads = loads, probes = { centre = {0, 0} }, time = { mode = "static" },
}
sim:run()
local expected = 2*P/(math.pi*2*radius)*(math.sin(2*a)/a - 1)
print(("BENCH %d %.6g"):format(#sim.blocks, math.abs(sim.probes.centre.sxx/expected - 1)))
