-- Tracked cracks (fracture.path) go where rock without a mesh would crack: the straight path of an edge crack, to less than a mesh
-- size on every mesh and at first order, and the wings of a slanted one (15 s CPU; a minute with full=true).
-- Source: by symmetry an edge crack goes straight on; a crack of 45 degrees under tension kinks by 53.1 degrees (Erdogan & Sih 1963),
-- which is 8.1 degrees beyond the horizontal, and then turns to it as mode I takes over.
local talus = require "talus"
local u = talus.units
local joint = talus.joint { name = "rock", friction = 35*u.deg, cohesion = 4*u.MPa, tension = 0.5*u.MPa }
local open = talus.joint { name = "crack", friction = 0 }

local turned = { scale = 1, angle = 0, shift = {0, 0} }
-- A plate from (x0, y0) to (x1, y1) with a crack, pulled apart along y by its top until enough(cracks) is true. `way` scales, turns and
-- shifts it. Back: middles of what failed, as if it had not been; the highest load, N/m; blocks.
local function torn(plate, way)
  way = way or turned
  local k, c, s = way.scale, math.cos(way.angle), math.sin(way.angle)
  local function at(x, y) return { k*(c*x - s*y) + way.shift[1], k*(s*x + c*y) + way.shift[2] } end
  local function back(p)
    local x, y = (p[1] - way.shift[1])/k, (p[2] - way.shift[2])/k
    return { c*x + s*y, -s*x + c*y }
  end
  local x0, y0, x1, y1 = table.unpack(plate.box)
  local pull = 0.05*u.mm*(y1 - y0)*k
  local size = plate.size
  if type(size) == "function" then
    size = function(x, y) local p = back { x, y } return k*plate.size(p[1], p[2]) end
  else
    size = k*size
  end
  local crack = {}
  for i, p in ipairs(plate.crack) do crack[i] = at(p[1], p[2]) end
  local sim = talus.simulation {
    regions  = { talus.region { name = "plate", outline = talus.polygon { at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1) },
                                material = talus.material { name = "rock", density = 2500, young = 10*u.GPa, poisson = 0.2 },
                                mesh = { size = size }, joint = joint, cuts = { talus.trace { points = crack, joint = open } } } },
    fix      = { talus.fix { region = "plate", on = talus.segment(at(x0, y0), at(x1, y0)) },
                 talus.fix { name = "pull", region = "plate", on = talus.segment(at(x0, y1), at(x1, y1)),
                             displacement = { {{0, 0}, {1, -s*pull}}, {{0, 0}, {1, c*pull}} } } },
    time     = { mode = "static", steps = 5 },
    fracture = { path = "tracked" },
  }
  local failed, most = {}, 0
  for _ in sim:steps() do
    local force = sim.reactions.pull
    most = math.max(most, (-s*force[1] + c*force[2])/k)
    failed = {}
    for _, one in ipairs(sim.cracks) do
      for _, j in ipairs(one.joints) do failed[#failed + 1] = back(sim.joints[j].mid) end
    end
    if plate.enough(failed) then break end
  end
  return failed, most, #sim.blocks
end

local function edge_crack(h, width, size, way)
  local failed, most, blocks = torn({
    box = {0, -0.5, width, 0.5}, crack = { {0, 0}, {0.3, 0} }, size = size or h,
    enough = function(failed)
      for _, p in ipairs(failed) do if p[1] > width - h then return true end end
    end }, way)
  local largest, square = 0, 0
  for _, p in ipairs(failed) do largest, square = math.max(largest, math.abs(p[2])/h), square + (p[2]/h)^2 end
  return { largest = largest, mean = math.sqrt(square/#failed), load = most, blocks = blocks, failed = failed }
end

-- Widths that differ by millimetres make meshes that have nothing in common. The largest of n distances grows with n, and n with 1/h:
-- the rate is that of the root of their mean square.
local full = talus.param("full", false, "finer meshes too")
local sizes, widths = { 0.12, 0.1, 0.085, 0.07, 0.05, 0.04 }, { 1, 1.003, 1.006, 1.009 }
if full then table.move({ 0.03, 0.025 }, 1, 2, #sizes + 1, sizes) end
local loads, points = {}, {}
for _, h in ipairs(sizes) do
  local mean, worst, load = 0, 0, 0
  for _, width in ipairs(widths) do
    local crack = edge_crack(h, width)
    mean, worst, load = mean + crack.mean/#widths, math.max(worst, crack.largest), load + crack.load/#widths
  end
  loads[h], points[#points + 1] = load, { math.log(h), math.log(mean*h) }
  talus.check.below(string.format("edge crack, h = %g m, %d meshes: largest distance from the straight path, mesh sizes", h, #widths), worst, 1)
end
local x, y = 0, 0
for _, p in ipairs(points) do x, y = x + p[1]/#points, y + p[2]/#points end
local over, under = 0, 0
for _, p in ipairs(points) do over, under = over + (p[1] - x)*(p[2] - y), under + (p[1] - x)^2 end
talus.check.above("edge crack: rate at which the distance from the straight path falls with h", over/under, 0.8)

-- Refined only near the path, at the same h there.
for _, h in ipairs { 0.05, 0.04 } do
  local near = edge_crack(h, 1, function(px, py) return math.min(0.12, h + 0.3*math.max(0, math.abs(py) - 2*h, 0.3 - 2*h - px)) end)
  talus.check.below(string.format("edge crack, h = %g m near the path: largest distance from it, mesh sizes", h), near.largest, 1)
  talus.check.near(string.format("edge crack, h = %g m near the path: load, of that of meshes of this h", h), near.load/loads[h], 1,
                   { rel = 0.2 })
end

-- A crack of 45 degrees in a wide plate.
local a, h = 0.15*math.sqrt(0.5), 0.02
local failed = torn {
  box = {-1, -1, 1, 1}, crack = { {-a, -a}, {a, a} },
  size = function(px, py) return math.min(0.2, h + 0.2*math.max(0, math.sqrt(px^2 + py^2) - 0.25)) end,
  enough = function(list) return #list >= 12 end }
local off, kinked = 0, 0
for _, p in ipairs(failed) do
  local along, across = math.abs(p[1]) - a, (p[2] - (p[1] > 0 and a or -a))*(p[1] > 0 and 1 or -1)
  off, kinked = math.max(off, math.abs(across)/h), kinked + (along > 0 and 1 or 0)
end
talus.check.equal("slanted crack: bonds that failed beyond its tips", kinked, #failed)
talus.check.below("slanted crack: largest distance of its wings from the horizontals through its tips, mesh sizes", off, 1)

-- Nothing depends on place or scale. A plate that is turned has another mesh.
local reference = edge_crack(0.07, 1)
for name, way in pairs { ["scaled by 1000"] = { scale = 1000, angle = 0, shift = {0, 0} },
                         ["shifted by 10 km"] = { scale = 1, angle = 0, shift = {1e4, -1e4} } } do
  local other = edge_crack(0.07, 1, nil, way)
  local off = #other.failed == #reference.failed and math.abs(other.load/reference.load - 1) or 1
  for k, p in ipairs(other.failed) do
    local q = reference.failed[k] or p
    off = math.max(off, math.abs(p[1] - q[1]), math.abs(p[2] - q[2]))
  end
  talus.check.below("edge crack, " .. name .. ": difference of its bonds and its load", off, 1e-6)
end
talus.check.below("edge crack, turned by 37 degrees: largest distance from the straight path, mesh sizes",
                  edge_crack(0.07, 1, nil, { scale = 1, angle = 37*u.deg, shift = {0, 0} }).largest, 1)

-- In motion: the plate is pulled apart in 2 ms.
local function fast_crack(h, width)
  local ramp = { {0, 0}, {2*u.ms, 0.4*u.MPa} }
  local sim = talus.simulation {
    regions = { talus.region { name = "plate", outline = talus.rect(0, -0.5, width, 0.5), mesh = { size = h }, joint = joint,
                               material = talus.material { name = "rock", density = 2500, young = 10*u.GPa, poisson = 0.2 },
                               cuts = { talus.trace { points = { {0, 0}, {0.3, 0} }, joint = open } } } },
    loads   = { talus.edge_load { region = "plate", on = "top", traction = {0, ramp} },
                talus.edge_load { region = "plate", on = "bottom", traction = {0, { {0, 0}, {2*u.ms, -0.4*u.MPa} }} } },
    time    = { mode = "dynamic", t_end = 3*u.ms, dt = 2e-5 },
    fracture = { path = "tracked" },
  }
  local reached, square, count = 0, 0, 0
  for _ in sim:steps() do
    square, count = 0, 0
    for _, crack in ipairs(sim.cracks) do
      for _, j in ipairs(crack.joints) do
        local mid = sim.joints[j].mid
        square, count, reached = square + (mid[2]/h)^2, count + 1, math.max(reached, mid[1])
      end
    end
    if reached > width - h then break end
  end
  return math.sqrt(square/count)
end
local worst = 0
for _, h in ipairs { 0.1, 0.05 } do
  for _, width in ipairs { 1, 1.003 } do worst = math.max(worst, fast_crack(h, width)) end
end
talus.check.below("fast edge crack, 4 meshes: root mean square distance from the straight path, mesh sizes", worst, 0.5)
