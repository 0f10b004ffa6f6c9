-- 18. Under-constrained static scene: names the free body, or gives a = F/m to 1e-10.
-- Static: an unheld block alone, one beside a held one, one pulled off a floor, and a bonded body of two. Dynamic: an off-centre force.
-- Source: a = F/m, α = M/I. (0.1 s CPU)
local talus = require "talus"
local rock = talus.material { name = "rock", density = 2500, young = 10e9, poisson = 0.2 }
local function static(regions, loads, gravity)
  local sim = talus.simulation { regions = regions, loads = loads, gravity = gravity, time = { mode = "static" } }
  local ok, message = pcall(sim.run, sim)
  return ok, tostring(message)
end
local function names(case, region, ok, message)
  print("MESSAGE  " .. case .. ": " .. message)
  talus.check.truth("free body, " .. case .. ": refused, and named", not ok and message:find(region, 1, true) ~= nil)
end
local function push(region, x, y) return { talus.point_load { region = region, at = {x, y}, force = {1e3, 0} } } end
local held = talus.region { name = "ground", outline = talus.rect(-5, -1, 5, 0), material = rock, held = true }
names("alone", "stray", static({ talus.region { name = "stray", outline = talus.rect(0, 0, 1, 1), material = rock } }, push("stray", 0.5, 0.5)))
names("beside a held one", "stray", static({ held, talus.region { name = "stray", outline = talus.rect(0, 2, 1, 3), material = rock } }, push("stray", 0.5, 2.5)))
names("on a floor, lifted", "stray", static({ held, talus.region { name = "stray", outline = talus.rect(0, 0, 1, 1), material = rock } },
      { talus.point_load { region = "stray", at = {0.5, 0.5}, force = {0, 1e5} } }, {0, -9.81}))
names("bonded body of eight", "stray", static({ held, talus.region { name = "stray", outline = talus.rect(0, 2, 2, 3), material = rock,
      mesh = { kind = "cross", nx = 2, ny = 1 } } }, push("stray", 1, 2.5)))

-- A first-order block's spin swings with its strain at first; the rigid one has neither.
for _, order in ipairs { 1, "rigid" } do
  local sim = talus.simulation {
    regions = { talus.region { name = "free", outline = talus.rect(0, 0, 2, 1), material = rock, order = order } },
    loads = { talus.point_load { region = "free", at = {2, 0.5}, force = {3e3, 4e3} } },
    time = { mode = "dynamic", t_end = 1, dt = 1e-4 },
  }
  sim:step()
  sim:stop()
  local b = sim.blocks[1]
  talus.check.near("free body, order " .. order .. ": acceleration along x over F/m", b.velocity[1]/1e-4/(3e3/5000), 1, { rel = 1e-10 })
  talus.check.near("free body, order " .. order .. ": acceleration along y over F/m", b.velocity[2]/1e-4/(4e3/5000), 1, { rel = 1e-10 })
  if order == "rigid" then
    talus.check.near("free body, rigid: angular acceleration over M/I", b.spin/1e-4/(4e3*1/(5000*(4 + 1)/12)), 1, { rel = 1e-10 })
  end
end
