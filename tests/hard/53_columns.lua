-- Own case 53: a block drawn to and fro over a row of separate elastic columns, which give way under it one by one. Each hands its corners over to
-- the next, which is not pressed yet and stands higher. That height was an offset of the contact for good: the block sank by a fifth of the columns' compression at each joint, and in the end a corner
-- caught on a column's side: at 1 GPa it jumped by 0.8 mm in the first pass, a quarter of the work put in was gone, friction was 1 % off.
-- Under loads that compress the columns by 1e-4 to 2e-3 of their size each was a ledge on which the block caught: lifted by twice the compression, friction 2 to 4 % off.
-- Bounds: friction is μN, and the path's height within what the columns give way to (between a block on four of them and one on five, and the pitch of its shear): a third of
-- the compression σh/E. Unexplained at most 1 %, in motion 0.1 %. Fast ones, a tenth and a third of their length a step, come to the speed that μ g leaves; their steps are cut no more than 5 %. (9 s CPU)
local talus = require "talus"
local check = talus.check
local g, density, mu, width, long = 9.81, 2500, 0.3, 0.25, 1

local function scene(young, depth, friction, shift, time, drive, pressure)
  local rock = talus.material { name = "rock", density = density, young = young, poisson = 0.2 }
  local columns = {}
  for k = 0, 23 do columns[k + 1] = talus.rect(shift - 3 + k*width, -depth, shift - 3 + (k + 1)*width, 0) end
  return talus.simulation {
    gravity = {0, -g}, contact = talus.joint { name = "seat", friction = math.atan(friction) },
    regions = { talus.region { name = "floor", blocks = columns, material = rock },
                talus.region { name = "sled", outline = talus.rect(shift - 2.5, 0, shift - 1.5, 0.5*long), material = rock } },
    loads = { pressure and talus.edge_load { region = "sled", on = "top", traction = {0, -pressure} } },
    fix = { talus.fix { region = "floor", on = "bottom" }, talus.fix(drive) }, time = time,
  }
end

local function follow(sim)
  local sled = sim.blocks[#sim.blocks]
  local start, x, seen = nil, sled.centroid[1], { way = 0, high = 0, low = 0, unexplained = 0 }
  for _ in sim:steps() do
    start = start or sled.uy
    local rise, e = sled.uy - start, sim.energy
    seen.way, x = seen.way + math.abs(sled.centroid[1] - x), sled.centroid[1]
    seen.high, seen.low = math.max(seen.high, rise), math.min(seen.low, rise)
    seen.unexplained = math.max(seen.unexplained, math.abs(e.unexplained)/e.scale)
  end
  return seen
end

for _, case in ipairs { {1e10, 1, mu, 0}, {1e9, 1, mu, 0}, {1e9, 4, mu, 0}, {1e10, 1, 0, 0}, {1e10, 1, mu, 1e4},
                        {1e9, 1, mu, 0, 5e4}, {1e10, 1, mu, 0, 1e6}, {1e9, 1, mu, 0, 1e6} } do
  local young, depth, friction, shift, pressure = table.unpack(case)
  local bears = density*g*0.5*long + (pressure or 0)
  local passes, way = 4, 3.5
  local sim = scene(young, depth, friction, shift, { mode = "dynamic", t_end = passes, dt = 1e-3, start = "settled" },
    { region = "sled", on = "left", x = true, velocity = { function(t) return way/2*math.pi*math.sin(math.pi*t) end, 0 } }, pressure)
  local seen = follow(sim)
  local compression = bears*depth/young
  local label = string.format("drawn over columns of %g GPa, %g m high, friction %g%s%s: ", young/1e9, depth, friction,
    pressure and string.format(", under %g kPa", pressure/1e3) or "", shift > 0 and ", 10 km off" or "")
  if friction > 0 then
    check.near(label .. "work of friction, of the weight's", sim.energy.friction/(friction*bears*long*seen.way), 1, { rel = math.max(1e-4, compression) })
  end
  check.below(label .. "highest, of the columns' compression", seen.high/compression, 0.35)
  check.below(label .. "deepest, of it", -seen.low/compression, 0.35)
  check.below(label .. "unexplained, largest, of the scale", seen.unexplained, 1e-3)
  check.equal(label .. "cuts", sim.totals.cuts, 0)
end

for _, case in ipairs { {1e10, mu}, {1e9, mu}, {1e9, mu, 5e4}, {1e9, mu, 1e6}, {1e9, 0}, {1e9, 0, 1e6}, {1e9, 1e-5} } do
  local young, friction, pressure = table.unpack(case)
  local sim = scene(young, 1, friction, 0, { mode = "static", t_end = 3, steps = 200 },
    { region = "sled", on = "left", x = true, displacement = { {{0, 0}, {0.02, 0}, {1, 2}, {2, 0}, {3, 2}}, 0 } }, pressure)
  local seen = follow(sim)
  local compression = (density*g*0.5*long + (pressure or 0))/young
  local label = string.format("drawn over columns of %g GPa%s%s, static: ", young/1e9, friction ~= mu and string.format(", friction %g", friction) or "",
    pressure and string.format(", under %g kPa", pressure/1e3) or "")
  check.below(label .. "highest, of the columns' compression", seen.high/compression, 0.35)
  check.below(label .. "deepest, of it", -seen.low/compression, 0.35)
  check.below(label .. "unexplained, largest, of the scale", seen.unexplained, 0.01)
end

-- Slid from four places.
for _, speed in ipairs { 3, 10 } do
  local steps, cuts, off = 0, 0, 0
  for place = 0, 3 do
    local rock = talus.material { name = "rock", density = density, young = 50e9, poisson = 0.2 }
    local columns, x = {}, -2.5 + 0.0137*place
    for k = 0, 43 do columns[k + 1] = talus.rect(-3 + k*width, -1, -3 + (k + 1)*width, 0) end
    local sim = talus.simulation {
      gravity = {0, -g}, contact = talus.joint { name = "seat", friction = math.atan(mu) },
      regions = { talus.region { name = "floor", blocks = columns, material = rock },
                  talus.region { name = "sled", outline = talus.rect(x, 0, x + 0.3, 0.3), material = rock, velocity = {speed, 0} } },
      fix = { talus.fix { region = "floor", on = "bottom" } },
      time = { mode = "dynamic", t_end = 0.6, dt = 1e-2, start = "settled" },
    }
    sim:run()
    steps, cuts = steps + sim.totals.steps, cuts + sim.totals.cuts
    off = math.max(off, math.abs(sim.blocks[#sim.blocks].velocity[1] - (speed - mu*g*0.6)))
  end
  local label = string.format("slid over columns at %g m/s: ", speed)
  check.below(label .. "steps cut, part of all", cuts/steps, 0.05)
  check.below(label .. "speed off, m/s", off, 1e-4)
end
