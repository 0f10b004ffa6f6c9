-- A crater's worth of loose triangles, touching all round, thrown by a blast: 15 x 5 m of rock, what lies in the crater flies off
-- with up to 15 m/s away from the hole and upwards, the rest is held. The smaller Δt, the more of the shock has to go from
-- block to block within the step.
local talus = require "talus"
local shapes = require "shapes"
local seed = talus.param("seed", 1, "of the corners")
local size = talus.param("size", 0.42, "edge length, m")
local step = talus.param("step", 1, "step at which the problem is taken")
local dt = talus.param("dt", 2e-4, "s")
local loose = talus.param("loose", "crater", "crater or all")
local hole, speed = {7.5, 2}, 15
local random = shapes.random(seed)
local rock = talus.material { name = "rock", density = 2600, young = 55e9, poisson = 0.3 }

local nx, ny = math.floor(15/size), math.floor(5/size)
local node = {}
for i = 0, nx do
  node[i] = {}
  for j = 0, ny do
    local x, y = 0.5*(random() - 0.5), 0.5*(random() - 0.5)
    if i == 0 or i == nx then x = 0 end
    if j == 0 or j == ny then y = 0 end
    node[i][j] = { (i + x)*15/nx, (j + y)*5/ny }
  end
end
local regions, kept = {}, {}
local function triangle(a, b, c)
  local x = (a[1] + b[1] + c[1])/3 - hole[1]
  local y = (a[2] + b[2] + c[2])/3 - hole[2]
  local inside = y > -0.4 and math.abs(x) < 0.7 + 1.1*(y + 0.4)
  if not inside and loose ~= "all" then kept[#kept + 1] = {a, b, c} return end
  local r = math.sqrt(x*x + y*y)
  local v = inside and speed*math.exp(-r/4)/math.max(r, 0.1) or 0
  regions[#regions + 1] = talus.region { name = "block " .. #regions, outline = {a, b, c}, material = rock, velocity = { v*x, v*(y + 0.4*r) } }
end
for i = 1, nx do
  for j = 1, ny do
    local a, b, c, d = node[i - 1][j - 1], node[i][j - 1], node[i][j], node[i - 1][j]
    if random() < 0.5 then triangle(a, b, c) triangle(a, c, d) else triangle(a, b, d) triangle(b, c, d) end
  end
end
regions[#regions + 1] = talus.region { name = "bench", material = rock, held = true,
  blocks = { talus.rect(-60, 0, 0, 5), talus.rect(15, 0, 75, 5), talus.rect(-60, -8, 75, 0) } }
if #kept > 0 then regions[#regions + 1] = talus.region { name = "kept", blocks = kept, material = rock, held = true } end
talus.simulation { gravity = {0, -shapes.g}, contact = talus.joint { name = "joint", friction = math.rad(45) },
  regions = regions, time = shapes.time(step, dt) }
