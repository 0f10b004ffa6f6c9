-- A plate with a hole under tension (Kirsch): how much wider the hole gets, 6 σ a/E, and the error of the raw stress in energy norm.
package.path = "tests/verify/?.lua;" .. package.path
local talus = require "talus"
local kirsch = require "parts.kirsch"
local size, order = talus.param("size", 0.5, "edge, m"), talus.param("order", 1, "of the blocks")
local wanted = talus.param("refine", 0, "error that the mesh is made for; 0: an even mesh")
local what = talus.param("what", "width", "width of the hole or stress")
local function scene(edge)
  local probes = what == "stress" and kirsch.samples(0.2) or { left = {-1, 0}, right = {1, 0} }
  return kirsch.simulation(edge, order, { probes = probes })
end
local sim
if wanted > 0 then
  sim = talus.refine { scene = scene, size = size, error = wanted, log = false }.sim
else
  sim = scene(size)
  sim:run()
end
local error = what == "stress" and kirsch.true_error(sim) or
  math.abs((sim.probes.right.ux - sim.probes.left.ux)/(6*kirsch.far/kirsch.young) - 1)
print(("BENCH %d %.6g"):format(#sim.blocks, error))
