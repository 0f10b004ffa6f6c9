-- 65. A jointed slope that comes to rest under gravity put on at once, shifted by 10 km, turned, and in another unit: the same steps, displacements to 1e-6.
-- Source: nothing in the equations knows where the origin is. Ours: automatic steps grew by what their solutions took, 5 iterations here and 10 there for the
-- same forces: 10 or 12 steps, displacements 0.1 to 17 % apart in 4 of 12 scenes of some 30 blocks. (1 s CPU)
local talus = require "talus"

local function slope(seed, way)
  local k, angle, from = way.unit or 1, way.turn or 0, way.from or {0, 0}
  local c, s = math.cos(angle), math.sin(angle)
  local function at(x, y) return { from[1] + k*(c*x - s*y), from[2] + k*(s*x + c*y) } end
  local function polygon(corners)
    local placed = {}
    for i, p in ipairs(corners) do placed[i] = at(p[1], p[2]) end
    return placed
  end
  local function rect(x0, y0, x1, y1) return polygon { {x0, y0}, {x1, y0}, {x1, y1}, {x0, y1} } end
  local joint = talus.joint { friction = math.rad(15) }
  local rock = talus.material { density = 2600, young = 1e10, poisson = 0.25 }
  local function set(dip, spacing, number)
    return talus.joint_set { dip = math.rad(dip) + angle, spacing = spacing*k, spacing_scatter = 0.3, seed = number, through = at(10, 5) }
  end
  local sim = talus.simulation {
    gravity = { 9.81*s/k, -9.81*c/k }, contact = joint,  -- strains are those of ρ g L/E; waves take k times as long
    regions = {
      talus.region { name = "base", blocks = { rect(-15, -2, 20, 0), rect(20, -2, 22, 12) }, material = rock, held = true },
      talus.region { name = "slope", outline = polygon { {0, 0}, {20, 0}, {20, 10}, {6, 10} }, material = rock, joint = joint,
                     cuts = { set(70, 2.5, seed), set(-15 + 8*(seed % 4), 3.5, seed + 100) } },
    },
    time = { t_end = 0.5*k, start = "rest" },
  }
  sim:run()
  local most = 0
  for _, b in ipairs(sim.blocks) do most = math.max(most, b.u/k) end
  return most, sim.totals.steps
end

local ways = { { "turned by 30 degrees", { turn = math.rad(30) } }, { "turned by 90 degrees", { turn = math.rad(90) } },
               { "shifted by 10 km", { from = {1e4, -1e4} } }, { "scaled by 1000", { unit = 1000 } }, { "scaled by 1/1000", { unit = 1e-3 } } }
for seed = 1, 4 do
  local most, steps = slope(seed, {})
  for _, way in ipairs(ways) do
    local other, taken = slope(seed, way[2])
    local label = string.format("slope %d, %s", seed, way[1])
    talus.check.equal(label .. ": steps", taken, steps)
    talus.check.near(label .. ": largest displacement over that as drawn", other/most, 1, { rel = 1e-6 })
  end
end
