-- talus.refine on a closed form (parts/kirsch.lua): the true error of the stress, sampled at 6100 points, is what was asked for, and that
-- of an even mesh of as many blocks is 1.7 and 2.7 times larger. (7 s CPU)
local talus = require "talus"
local kirsch = require "parts.kirsch"

local function refined(order, error, size)
  return talus.refine { error = error, size = size, scene = function(edge)
    return kirsch.simulation(edge, order, { probes = kirsch.samples(0.1) })
  end }
end
local function even(order, blocks)
  local size = 1
  local sim
  for _ = 1, 6 do  -- the hole's own sides are always there: the size that gives as many blocks is found by trials
    sim = kirsch.simulation(size, order, { probes = kirsch.samples(0.1) })
    if #sim.blocks >= blocks then break end
    size = size*math.sqrt(math.max(0.3, math.min(0.97, #sim.blocks/blocks)))
  end
  sim:run()
  return sim
end

for _, case in ipairs { { 1, 0.04, 1.2 }, { 2, 0.005, 1.2 } } do
  local order, wanted, least = table.unpack(case)
  local result = refined(order, wanted, 2)
  local reached = kirsch.true_error(result.sim)
  local same = even(order, result.blocks)
  local label = ("order %d, %d blocks, %d rounds, %.2g s: "):format(order, result.blocks, #result.rounds, result.seconds)
  talus.check.below(label .. "true error, of the wanted one", reached/wanted, 1.1)
  talus.check.near(label .. "estimated error over the true one", result.error/reached, 1, { abs = 0.25 })
  talus.check.above(("order %d, an even mesh of %d blocks: its true error over that"):format(order, #same.blocks),
    kirsch.true_error(same)/reached, least)
end
