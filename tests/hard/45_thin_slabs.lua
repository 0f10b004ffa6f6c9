-- 45. Thin slabs on surfaces whose outline has corners in line, or nearly: nodes of meshes, polygons of many sides. They part, slide and topple as on plain ones, whatever their thickness.
-- Source: free flight; x = ½ g (sin β − cos β tan φ) t²; Timoshenko's beam on two rollers that turn towards each other, x'' = −(μ g/a) x. Ours: a slab thinner than an eighth of √area
-- of the pair was held from behind by the corner under it: its far side was taken for a face that the corner lies in. It did not part, slide or topple; on rollers of 100 sides a hundred weights pressed. (2 s CPU)
local talus = require "talus"
local g, L = 9.81, 8
local rock = talus.material { name = "rock", density = 2500, young = 20e9, poisson = 0.2 }
local in_line = {{-6, -2}, {6, -2}, {6, 0}, {0, 0}, {-6, 0}}
local function ngon(n, radius, x, y)
  local corners = {}
  for k = 0, n - 1 do corners[k + 1] = { x + radius*math.cos(math.pi/2 + 2*math.pi*k/n), y + radius*math.sin(math.pi/2 + 2*math.pi*k/n) } end
  return corners
end
local function floor(kind)
  if kind == "mesh" then return { name = "floor", outline = talus.rect(-6, -2, 6, 0), material = rock, mesh = { size = 1 } } end
  return { name = "floor", outline = kind, material = rock, held = true }
end
local function scene(under, slab, thickness, slope, friction, start)
  return talus.simulation {
    gravity = slope and { g*math.sin(slope), -g*math.cos(slope) } or {0, 0}, contact = talus.joint { friction = friction },
    regions = { talus.region(floor(under)), talus.region { name = "slab", outline = talus.rect(-L/2, 0, L/2, thickness), material = rock, velocity = slab } },
    fix = under == "mesh" and { talus.fix { region = "floor", on = "bottom" } } or nil,
    time = { t_end = 0.5, dt = 5e-3, start = start },
  }
end
local ridge = {{-6, -2}, {6, -2}, {6, -0.25}, {0, 0}, {-6, -0.25}}
for _, case in ipairs { {"corners in line", in_line}, {"a mesh", "mesh"}, {"a ridge of 0.25 m", ridge}, {"a drum of 100 sides", ngon(100, 2, 0, -2)} } do
  local label, under = case[1], case[2]
  for _, thickness in ipairs { 0.1, 0.4 } do
    local sim = scene(under, {0, 1}, thickness)
    sim:run()
    talus.check.near(string.format("slab of %g m parts from %s: way, m", thickness, label), sim.blocks[#sim.blocks].uy, 0.5, { rel = 1e-9 })
  end
end
local slope, friction = math.rad(30), math.rad(20)
for _, case in ipairs { {"corners in line", in_line}, {"a mesh", "mesh"} } do
  local label, under = case[1], case[2]
  for _, start in ipairs { "rest", "settled" } do
    local sim = scene(under, {0, 0}, 0.1, slope, friction, start)
    sim:run()
    local way = g*(math.sin(slope) - math.cos(slope)*math.tan(friction))*0.5^2/2
    talus.check.near(string.format("slab slides on %s, start = %q: way, m", label, start), sim.blocks[#sim.blocks].ux, way, { rel = 1e-3 })
  end
end
local a, mu, at = 2, 0.2, 0.3
for _, sides in ipairs { 60, 200 } do
  local rollers = {}
  for k, x in ipairs { -a, a } do
    rollers[k] = talus.region { name = k == 1 and "left" or "right", outline = ngon(sides, 0.5, x, -0.5), material = rock, order = "rigid" }
  end
  local sim = talus.simulation {
    gravity = {0, -g}, contact = talus.joint { friction = math.atan(mu) },
    regions = { rollers[1], rollers[2], talus.region { name = "beam", outline = talus.rect(-L/2 + at, 0, L/2 + at, 0.2), material = rock, order = "rigid" } },
    fix = { talus.fix { region = "left", spin = -8 }, talus.fix { region = "right", spin = 8 } },
    time = { t_end = 8, dt = 5e-3 },
  }
  local crossed, before, most = {}, at, 0
  for status in sim:steps() do
    local x = at + sim.blocks[3].ux
    if x < 0 ~= (before < 0) then crossed[#crossed + 1] = status.time - status.dt*x/(x - before) end
    if status.time > 4 then most = math.max(most, math.abs(x)) end
    before = x
  end
  local label = string.format("beam on rollers of %d sides: ", sides)
  talus.check.near(label .. "half a period, s", (crossed[2] or 0) - (crossed[1] or 0), math.pi*math.sqrt(a/(mu*g)), { rel = 0.02 })
  talus.check.near(label .. "swings as far as at first, m", most, at, { rel = 0.05 })
end
