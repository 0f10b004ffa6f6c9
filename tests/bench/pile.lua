-- A bench of 4 x 3 m that gas from one hole breaks, casts and leaves as a pile, with the drag of examples/11 (L = 2 m), for 1.6 s: how
-- far its centroid has gone sideways. `hole`: by how many cm it is moved, along and up: another mesh of the same rock.
local talus = require "talus"
local u = talus.units
local size, order = talus.param("size", 0.6, "edge, m"), talus.param("order", 1, "of the blocks")
local ratio, hole = talus.param("ratio", 0.005, "displacement a step"), talus.param("hole", 0, "cm")
local rock = talus.material { density = 2600, young = 5*u.GPa, poisson = 0.3, plane = "strain" }
local joint = talus.joint { name = "rock bonds", friction = 45*u.deg, cohesion = 2*u.MPa, tension = 0.5*u.MPa, residual = { cohesion = 0 } }
local sim = talus.simulation {
  gravity = {0, -9.81}, contact = talus.joint { friction = 45*u.deg },
  regions = {
    talus.region { name = "ground", outline = talus.polygon { {-3, -1}, {12, -1}, {12, 0}, {0, 0}, {0, 3}, {-3, 3} }, material = rock, held = true },
    talus.region { name = "bench", outline = talus.rect(0, 0, 4, 3), material = rock, joint = joint, order = order,
                   holes = { talus.circle { at = {2.8 + hole*u.cm, 1 + hole*u.cm}, radius = 0.1, sides = 12, name = "hole" } },
                   mesh = { size = talus.grade { { at = "hole", size = size/3 }, far = size } } },
  },
  charges = { talus.charge { hole = "hole", eos = talus.eos.polytropic { pressure = 100*u.MPa, gamma = 1.4 }, gas_speed = 200 } },
  numerics = { damping = function(speed, dt) return 1/(1 + speed*dt/2) end },
  time = { t_end = 1.6, start = "settled", displacement_ratio = ratio },
}
sim:run()
local area, moved = 0, 0
for _, block in ipairs(sim.blocks) do
  if block.region == "bench" then area, moved = area + block.area, moved + block.area*block.ux end
end
print(("BENCH %d %.9g value"):format(#sim.blocks, moved/area))
