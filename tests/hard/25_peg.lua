-- 25. A peg dropped into a slot of its own width (clearance 1e-6 L) and pressed to one side of it: it stops at the bottom, penetration
-- < 1e-4 L, and the bottom carries what is not in friction. Slots of one block, and of a body of bonded blocks.
-- Source: equilibrium. Ours: sliding down the wall the peg was taken to pass the bottom "flush", and sank in. (0.2 s CPU)
local talus = require "talus"
local tools = require "tools"
local g = tools.g
local rock = talus.material { name = "rock", density = 2500, young = 10e9, poisson = 0.2 }
local e = 1e-6
for _, bonded in ipairs { false, true } do
  for _, push in ipairs { 0, 1e4 } do
    local fork = talus.region { name = "fork", outline = { {0, 0}, {3, 0}, {3, 2}, {2 + e, 2}, {2 + e, 1}, {1 - e, 1}, {1 - e, 2}, {0, 2} }, material = rock,
      mesh = bonded and { size = 0.5 } or nil, joint = talus.joint { name = "glue", tension = 1e9, cohesion = 1e9, friction = 0.2 } }
    local sim = talus.simulation {
      gravity = {0, -g}, contact = talus.joint { name = "contact", friction = 0.2 },
      regions = { fork, talus.region { name = "peg", outline = talus.rect(1, 1.3, 2, 2.8), material = rock } },
      fix = { talus.fix { region = "fork", on = "bottom" } },
      loads = { talus.point_load { region = "peg", at = {1.5, 2.05}, force = {push, 0} } },
      time = { mode = "dynamic", t_end = 2, dt = 1e-3 },
    }
    local deepest = 0
    tools.watch(sim, function()
      local gaps, forces = sim.contacts:field "gap", sim.contacts:field "normal_force"
      for k = 1, #gaps do if forces[k] > 0 then deepest = math.max(deepest, -gaps[k]) end end
    end)
    local peg = sim.blocks:where { region = "peg" }[1]
    local label = string.format("peg in a slot%s, pushed by %g N: ", bonded and " of bonded blocks" or "", push)
    talus.check.near(label .. "way of the peg, m", peg.uy, -0.3, { abs = 1e-3 })
    talus.check.below(label .. "largest penetration, m", deepest, 1e-4)
    local lift = 0
    for _, c in ipairs(sim.contacts) do
      if c.block_i == peg.id or c.block_j == peg.id then
        local sign = c.block_i == peg.id and 1 or -1
        local p = sim.blocks[c.block_j].vertices
        local a, b = p[c.edge], p[c.edge % #p + 1]
        local l = math.sqrt((b[1] - a[1])^2 + (b[2] - a[2])^2)
        local tx, ty = (b[1] - a[1])/l, (b[2] - a[2])/l
        lift = lift + sign*(-tx*c.normal_force - ty*c.shear_force)
      end
    end
    talus.check.near(label .. "lift over weight", lift/(peg.mass*g), 1, { rel = 1e-3 })
  end
end
