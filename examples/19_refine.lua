-- A bracket with a re-entrant corner, where the stress is infinite: meshes made for the error that one asks for.
-- Run: scripts/run examples/19_refine.lua                (2 s CPU; pictures in out/refine)
--      scripts/run examples/19_refine.lua -p error=0.02  less, for more blocks
-- Teaches: talus.refine, sim.error, the field stress_error.
local talus = require "talus"
local u = talus.units
local wanted = talus.param("error", 0.04, "relative error of the stress, in energy norm")
local steel = talus.material { name = "steel", density = 7800, young = 210*u.GPa, poisson = 0.3, plane = "stress" }

-- The scene, on a mesh of the sizes it is given.
local function bracket(size)
  return talus.simulation {
    title = "A bracket, meshed for an error of its stress",
    regions = { talus.region { name = "bracket", material = steel, order = 2, mesh = { size = size },
                               outline = talus.polygon { {0, 0}, {0.4, 0}, {0.4, 0.15}, {0.15, 0.15}, {0.15, 0.5}, {0, 0.5} } } },
    fix = { talus.fix { region = "bracket", on = "top" } },
    loads = { talus.edge_load { region = "bracket", on = "right", traction = {0, -10*u.MPa} } },
    time = { mode = "static" },
    output = { dir = "out/refine", error = true, picture = "stress_error" },
  }
end

local result = talus.refine { scene = bracket, error = wanted, size = 0.1 }
local sizes = result.sim.blocks:field "area"
table.sort(sizes)
print(("%d blocks, the smallest of %.2g mm, the largest of %.2g mm; %.1f s"):format(result.blocks, 1e3*math.sqrt(sizes[1]),
  1e3*math.sqrt(sizes[#sizes]), result.seconds))
talus.check.below("estimated error", result.error, wanted)
talus.check.above("largest block over the smallest", math.sqrt(sizes[#sizes]/sizes[1]), 5)
