-- 20. Block pressed alternately in a slot of clearance 1e-6 L: at most 10 iterations, at most 2 step cuts, states reproducible.
-- A block of L = 1 m between two held jaws; a force of ten times its weight changes its side twenty times a second, square and smooth.
-- Reproducible: contact states at the same phase of the last ten periods, and of a second run, the same. (0.3 s CPU)
local talus = require "talus"
local tools = require "tools"
local g, L, clearance = tools.g, 1, 1e-6
local rock = talus.material { name = "rock", density = 2500, young = 10e9, poisson = 0.2 }
local force, period = 10*2500*g*L^2, 0.05
local waves = {
  square = function(t) return (t/period) % 1 < 0.5 and force or -force end,
  smooth = function(t) return force*math.sin(2*math.pi*t/period) end,
}
local function run(wave, friction)
  local sim = talus.simulation {
    gravity = {0, -g}, contact = talus.joint { name = "joint", friction = friction },
    regions = {
      talus.region { name = "jaws", material = rock, held = true, blocks = { talus.rect(-1, 0, 0, L), talus.rect(L + clearance, 0, L + 1, L),
                                                                             talus.rect(-1, -1, L + 1, 0) } },
      talus.region { name = "block", outline = talus.rect(clearance/2, 0, L + clearance/2, L), material = rock } },
    loads = { talus.point_load { region = "block", at = {L/2, L/2}, force = { waves[wave], 0 } } },
    time = { mode = "dynamic", t_end = 30*period, dt = period/100 },
  }
  local states, step = {}, 0
  local seen = tools.watch(sim, function()
    step = step + 1
    local list = {}
    for _, c in ipairs(sim.contacts) do list[#list + 1] = string.format("%d.%d-%d.%d%s", c.block_i, c.vertex, c.block_j, c.edge, c.state) end
    states[step] = table.concat(list, " ")
  end)
  return seen, states
end
for _, wave in ipairs { "square", "smooth" } do
  for _, friction in ipairs { 0, 0.5 } do
    local label = string.format("slot, %s force, friction %g: ", wave, friction)
    local seen, states = run(wave, friction)
    local _, again = run(wave, friction)
    local differ, other = 0, 0
    for k = 2001, 2900 do if states[k] ~= states[k + 100] then differ = differ + 1 end end
    for k = 1, math.max(#states, #again) do if states[k] ~= again[k] then other = other + 1 end end
    talus.check.below(label .. "most iterations of a step", seen.most_iterations, 10.5)
    talus.check.below(label .. "cuts", seen.cuts, 2.5)
    talus.check.equal(label .. "steps whose states differ from those a period later", differ, 0)
    talus.check.equal(label .. "steps whose states differ in a second run", other, 0)
  end
end
