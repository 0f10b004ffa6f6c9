-- A plate with an edge crack is pulled apart: how straight the crack runs depends on where the mesh lets it.
-- Run: scripts/run examples/05_edge_crack.lua                   joints on the straight path (0.3 s CPU)
--      scripts/run examples/05_edge_crack.lua -p mesh=coarse    also: coarse_2, fine, local (0.2 to 4 s CPU)
--      scripts/run examples/05_edge_crack.lua -p mesh=fine -p tracked=false    the mesh chooses the way, as in the paper
-- Teaches: real joints that end inside, a bonded trace, graded meshes, paths of cracks, loads up to failure, sim.cracks.
-- Picture: docs/pictures/05_edge_crack_path.svg, and _coarse, _coarse_2, _fine, _local; _local_mesh as the mesh chooses
-- Source: Ning, Yang, An & Ma (2011), Fig. 5. The paper gives no sizes: 1 m square, crack 0.3 m, and the joint of its discs.
local talus = require "talus"
local u = talus.units

-- Every bond takes the crack up to 30 degrees off its way, and nothing takes it back to the straight line but the stress: what it strays
-- adds up as in a walk. A tracked crack has a path beside its bonds, and keeps to it.
local meshes = {
  path     = { size = 0.1, on_path = true },
  coarse   = { size = 0.12 },
  coarse_2 = { size = 0.1 },
  fine     = { size = 0.04 },
  ["local"] = { size = function(x, y) return math.min(0.12, 0.02 + 0.3*math.max(0, math.abs(y) - 0.04, 0.26 - x)) end, h = 0.02 },
}
local name = talus.param("mesh", "path", "path, coarse, coarse_2, fine or local")
local mesh = meshes[name]
if not mesh then error("mesh: expected path, coarse, coarse_2, fine or local, got " .. name) end
local h = mesh.h or mesh.size
local tracked = talus.param("tracked", true, "the crack keeps to a path of its own")

local rock = talus.material { name = "rock", density = 2500, young = 10*u.GPa, poisson = 0.2 }
local joint = talus.joint { name = "rock", friction = 35*u.deg, cohesion = 4*u.MPa, tension = 0.5*u.MPa }
local open = talus.joint { name = "crack", friction = 0 }
local tip = 0.3
local cuts = { talus.trace { points = { {0, 0}, {tip, 0} }, joint = open } }
if mesh.on_path then cuts[2] = talus.trace { points = { {tip, 0}, {1, 0} }, joint = joint, bonded = true } end

local sim = talus.simulation {
  title   = "Plate with an edge crack, mesh " .. name,
  regions = { talus.region { name = "plate", outline = talus.rect(0, -0.5, 1, 0.5), material = rock, mesh = { size = mesh.size },
                             joint = joint, cuts = cuts } },
  fix     = { talus.fix { region = "plate", on = "bottom", y = true },
              talus.fix { region = "plate", on = { talus.point(0, -0.5), talus.point(0, 0.5) }, x = true },
              talus.fix { name = "pull", region = "plate", on = "top", y = true, displacement = {0, { {0, 0}, {1, 0.05*u.mm} }} } },
  time    = { mode = "static", steps = 5 },
  fracture = { path = tracked and "tracked" or "mesh" },
  output  = { dir = "out/edge_crack" },
}

-- Measured at the middles of joints, in mesh sizes along the path. The crack has run through when one is within that of the far side.
local deviation, reached, most = 0, tip, 0
for _ in sim:steps() do
  most = math.max(most, sim.reactions.pull[2])
  for _, crack in ipairs(sim.cracks) do
    for _, j in ipairs(crack.joints) do
      local mid = sim.joints[j].mid
      reached, deviation = math.max(reached, mid[1]), math.max(deviation, math.abs(mid[2]))
    end
  end
  if reached > 1 - h then break end
end
print(string.format("%d blocks; pulled apart at %.1f kN/m; largest deviation %.4f m = %.2f mesh sizes", #sim.blocks, most/u.kN,
                    deviation, deviation/h))
talus.check.above("the crack runs through, m", reached, 1 - h)
talus.check.below("largest deviation from the straight path, mesh sizes", deviation/h, mesh.on_path and 0.01 or tracked and 1 or 2)
