-- The discs of Ning et al. (2011), Figs. 7 and 10, each on five meshes (one unless full=true): with a notch, from whose tips
-- wing cracks reach the ends; with a small hole beside the centre (3-I), which it splits beside; with a large one (3-II), through it.
-- Source: what the paper's pictures show; examples 07 and 08 are the same discs.
local talus = require "talus"
local u = talus.units
local disc = require "parts.flattened_disc"
local full = talus.param("full", false, "five meshes each")

local function ledger(label, sim)
  talus.check.below(label .. "unexplained energy, of the work put in", math.abs(sim.energy.unexplained)/sim.energy.scale, 0.01)
end

-- m, y of a joint's ends, where both its blocks have a corner but for what has opened.
local function ends(sim, joint)
  local found = {}
  for _, p in ipairs(sim.blocks[joint.block_a].vertices) do
    for _, q in ipairs(sim.blocks[joint.block_b].vertices) do
      if math.sqrt((p[1] - q[1])^2 + (p[2] - q[2])^2) < 0.1*joint.length then found[#found + 1] = p[2] end
    end
  end
  return table.unpack(found)
end

local half_notch = 15*u.mm/2/math.sqrt(2)
for _, size in ipairs(full and { 1.7, 1.8, 1.85, 1.9, 2.0 } or { 1.9 }) do
  local notch = talus.trace { points = { { -half_notch, -half_notch }, { half_notch, half_notch } }, joint = talus.joint { friction = 0 } }
  local body = talus.region { name = "disc", outline = disc.outline(size*u.mm), material = disc.rock, mesh = { size = size*u.mm },
                              joint = disc.joint(), cuts = { notch } }
  local sim, seen = disc.break_up(body, nil, { height = disc.at_plates, blank = half_notch })
  local label = string.format("notched disc of %d blocks: ", #sim.blocks)
  local upper, lower = 0, 0
  for _, crack in ipairs(seen.failed) do
    for _, y in ipairs { ends(sim, sim.joints[crack.joint]) } do upper, lower = math.max(upper, y), math.max(lower, -y) end
  end
  talus.check.truth(label .. "split in two", seen.split)
  talus.check.equal(label .. "the first crack grows from the notch", seen.first.kind, "propagated")
  talus.check.above(label .. "wings reach the plates, of the half height", math.min(upper, lower)/disc.half_height, 0.8)
  ledger(label, sim)
end

for _, size in ipairs(full and { 1.7, 1.77, 1.83, 1.9, 1.97 } or { 1.83 }) do
  local sim, seen = disc.break_up(disc.holed(size*u.mm, 3.5*u.mm, 12*u.mm), nil, { band = 0.2*disc.radius, until_through = true })
  local label = string.format("small hole, %d blocks: ", #sim.blocks)
  talus.check.truth(label .. "the first crack is at the hole", disc.at_hole(seen.first, size*u.mm, 3.5*u.mm, 12*u.mm))
  talus.check.truth(label .. "cracks within 0.1 D of the loaded diameter cross it from plate to plate", seen.through ~= nil)
  ledger(label, sim)
end

for _, size in ipairs(full and { 1.6, 1.65, 1.7, 1.8, 1.9 } or { 1.8 }) do
  local sim, seen = disc.break_up(disc.holed(size*u.mm, 7*u.mm, 8*u.mm), nil, { height = disc.at_plates, blank = 7*u.mm })
  local label = string.format("large hole, %d blocks: ", #sim.blocks)
  local above, below = false, false
  for _, crack in ipairs(seen.failed) do
    local touches = disc.at_hole(crack, size*u.mm, 7*u.mm, 8*u.mm)
    above, below = above or touches and crack.y > 0, below or touches and crack.y < 0
  end
  talus.check.truth(label .. "split in two", seen.split)
  talus.check.truth(label .. "cracks above and below the hole", above and below)
  ledger(label, sim)
end
