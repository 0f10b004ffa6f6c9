-- Blocks in free fall, far enough apart never to meet: what a step costs besides contacts and the factor.
local talus = require "talus"
local n = talus.param("n", 10, "blocks along a side")
local rock = talus.material { name = "rock", density = 2600, young = 5e9, poisson = 0.25 }
local outlines = {}
for i = 1, n do
  for j = 1, n do outlines[#outlines + 1] = talus.rect(2*i, 2*j, 2*i + 1, 2*j + 1) end
end
local sim = talus.simulation {
  gravity = {0, -9.81}, regions = { talus.region { name = "blocks", blocks = outlines, material = rock } },
  time = { mode = "dynamic", t_end = 0.2, dt = 0.01 },
}
sim:run()
local off = 0
for _, uy in ipairs(sim.blocks:field("uy")) do off = math.max(off, math.abs(uy/(-0.5*9.81*0.04) - 1)) end
print(string.format("BENCH | %d | %d | fall %.2g", #sim.blocks, sim.totals.steps, off))
