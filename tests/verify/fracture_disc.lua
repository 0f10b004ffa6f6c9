-- The flattened disc of Ning et al. (2011), Fig. 6: stress before failure, load and path of its splitting on five meshes of about 1400
-- blocks and one of about 6000 (two of 1400 unless full=true, 40 s CPU).
-- Sources: a disc under arcs of half-angle a: at its centre 2P/(pi D)·(sin 2a / a - 1) (Hondros 1959). Splitting load: the load at
-- which the tension along the loaded diameter reaches the strength on a mesh of blocks of 0.7 mm that does not break.
local talus = require "talus"
local u = talus.units
local disc = require "parts.flattened_disc"
local strength = 0.5*u.MPa
local full = talus.param("full", false, "all six meshes")

local function body(size, joint)
  return talus.region { name = "disc", outline = disc.outline(size), material = disc.rock, mesh = { size = size }, joint = joint }
end

-- Unbroken, under pressure on arcs of half-angle a in place of plates.
local points, chords = {}, 4*math.ceil(math.pi*disc.radius/2/(1.2*u.mm))
for k = 0, chords - 1 do
  local angle = 2*math.pi*(k + 0.5)/chords
  points[k + 1] = { disc.radius*math.sin(angle), disc.radius*math.cos(angle) }
end
-- On seven chords at each end of the loaded diameter.
local a, loads, load = 7*math.pi/chords, {}, 40*u.kN
for k = 0, chords - 1 do
  local from, to = points[k + 1], points[(k + 1) % chords + 1]
  local middle = math.abs(from[1] + to[1])/2
  if middle < disc.radius*math.sin(a) then
    loads[#loads + 1] = talus.pressure { region = "disc", on = talus.line(from[1], from[2], to[1], to[2]), value = load/(2*disc.radius*math.sin(a)) }
  end
end
local side = 0.99*disc.radius  -- inside the chords
local intact = talus.simulation {
  regions = { talus.region { name = "disc", outline = points, material = disc.rock, mesh = { size = 1.2*u.mm }, joint = talus.joint { friction = 0.5 } } },
  loads = loads, probes = { centre = {0, 0} }, time = { mode = "static" },
  fix = { talus.fix { region = "disc", on = { talus.point(-side, 0), talus.point(side, 0) }, y = true },
          talus.fix { region = "disc", on = talus.point(0, -side), x = true } },
}
intact:run()
talus.check.near("disc under arcs: sigma x at the centre, Pa", intact.probes.centre.sxx,
                 2*load/(math.pi*2*disc.radius)*(math.sin(2*a)/a - 1), { rel = 0.01 })

-- The tension along the diameter where it is highest, per load, on a fine mesh.
local fine = {}
for k = -10, 10 do fine["p" .. k] = { 0, 0.03*k*2*disc.radius } end
local elastic = disc.simulation(body(0.7*u.mm, talus.joint { friction = 0.5 }), { probes = fine, time = { mode = "static", steps = 1 } })
elastic:run()
local most = 0
for k = -10, 10 do most = math.max(most, elastic.probes["p" .. k].sxx) end
local expected = disc.load(elastic)*strength/most
print(string.format("elasticity: %d blocks, the tension reaches the strength at %.2f kN/m", #elastic.blocks, expected/u.kN))
talus.check.between("elasticity: load at which the diameter reaches its strength, kN/m", expected/u.kN, 39.5, 40.7)

local splitting = {}
local function split(size)
  local passed = 0  -- by increments of load; what fails under a held load may be used by any part
  local sim, seen = disc.break_up(body(size*u.mm, disc.joint()), {
    on_step = function(sim) if sim.last.failures == 0 then passed = math.max(passed, sim.last.utilisation) end end,
  }, { until_through = true })
  local label = string.format("disc of %d blocks: ", #sim.blocks)
  talus.check.truth(label .. "split", seen.through ~= nil)
  talus.check.between(label .. "highest utilisation that an increment of load comes to", passed, 1, 1.01)
  talus.check.below(label .. "first crack, |x|/D", math.abs(seen.first.x)/(2*disc.radius), 0.1)
  talus.check.below(label .. "first crack, |y|/D", math.abs(seen.first.y)/(2*disc.radius), 0.3)
  talus.check.above(label .. "failed length within 0.1 D of the loaded diameter",
                    disc.share(seen, function(x) return math.abs(x) < 0.2*disc.radius end), 0.95)
  talus.check.below(label .. "unexplained energy, of the work put in", math.abs(sim.energy.unexplained)/sim.energy.scale, 0.01)
  return seen.splitting
end
for _, size in ipairs(full and { 1.72, 1.76, 1.8, 1.84, 1.88 } or { 1.76, 1.84 }) do splitting[#splitting + 1] = split(size) end
if full then talus.check.near("fine disc: splitting load, kN/m", split(0.88)/u.kN, expected/u.kN, { rel = 0.03 }) end
table.sort(splitting)
local median = (splitting[(#splitting + 1)//2] + splitting[#splitting//2 + 1])/2
talus.check.below("discs: spread of the splitting load, of their median", (splitting[#splitting] - splitting[1])/median, 0.08)
talus.check.near("discs: median splitting load, kN/m", median/u.kN, expected/u.kN, { rel = 0.03 })
