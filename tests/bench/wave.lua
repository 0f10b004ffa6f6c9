-- A pulse of 2 m along a bar of 6 m, blocks in a row: velocities when it is in the middle, against d'Alembert's p(t - x/c)/(ρc).
local talus = require "talus"
local u = talus.units
local order, h = talus.param("order", 1, "of the blocks"), talus.param("size", 0.1, "of a block, m")
local theta, integrator = talus.param("theta", 0.75, "of the scheme"), talus.param("integrator", "theta", "theta or newmark")
local dt, tolerance = talus.param("dt", 1e-5, "time step, s"), talus.param("tolerance", 0, "in place of dt")
local c, length = 2000, 6
local n = math.floor(length/h + 0.5)
local cuts, width = {}, math.min(h, 0.1)
for i = 1, n - 1 do cuts[i] = talus.trace { points = { {i*h, 0}, {i*h, width} }, bonded = true } end
local function push(t) return t > 0 and t < 1*u.ms and 1e6*math.sin(math.pi*t/(1*u.ms))^2 or 0 end
local sim = talus.simulation {
  regions = { talus.region { name = "bar", outline = talus.rect(0, 0, length, width), cuts = cuts, order = order,
                             material = talus.material { density = 2500, young = 10*u.GPa, poisson = 0 } } },
  fix = talus.fix { region = "bar", on = {"top", "bottom"}, y = true },
  loads = talus.edge_load { region = "bar", on = "left", traction = { push, 0 } },
  numerics = { theta = integrator == "theta" and theta or nil, integrator = integrator, recovery = false },
  time = { mode = "dynamic", t_end = 2*u.ms, dt = tolerance == 0 and dt or nil, tolerance = tolerance > 0 and tolerance or nil,
           displacement_ratio = 0.1 },
}
sim:run()
local off, whole = 0, 0
for _, b in ipairs(sim.blocks) do
  local exact = 0  -- the mean over the block, which its velocity is
  for k = 1, 8 do exact = exact + push(sim.time - (b.centroid[1] + ((k - 0.5)/8 - 0.5)*h)/c)/(2500*c)/8 end
  off, whole = off + (b.velocity[1] - exact)^2, whole + exact^2
end
print(("BENCH %d %.6g"):format(#sim.blocks, math.sqrt(off/whole)))
