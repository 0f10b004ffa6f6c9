-- 42. Two squares, bonded or joined by a trace with cohesion, sheared along their common face at 3 m/s while hardly or not pressed, turned by 0 to 1.2 rad: the run
-- goes on, and faces that nothing presses carry nothing.
-- Source: Mohr–Coulomb's law of faces that are pressed; a scene turned. Ours: a normal force of rounding switched all of the cohesion on, and where
-- cohesion lifts what presses it the law has no solution: runs stopped at four angles of six. (1 s CPU)
local talus = require "talus"
local rock = talus.material { name = "rock", density = 2500, young = 10e9, poisson = 0.2 }
local function sheared(order, turn, velocity, joint, bonded, dt)
  local c, s = math.cos(turn), math.sin(turn)
  local function at(x, y) return { c*x - s*y, s*x + c*y } end
  local fields = { name = "bar", order = order, material = rock, joint = joint }
  if bonded then
    fields.bonded, fields.blocks = true, { { at(0, 0), at(0.5, 0), at(0.5, 0.5), at(0, 0.5) }, { at(0.5, 0), at(1, 0), at(1, 0.5), at(0.5, 0.5) } }
  else
    fields.outline, fields.cuts = { at(0, 0), at(1, 0), at(1, 0.5), at(0, 0.5) }, { talus.trace { points = { at(0.5, 0), at(0.5, 0.5) } } }
  end
  local sim = talus.simulation { regions = { talus.region(fields) }, time = { t_end = 0.02, dt = dt } }
  sim.blocks[2].velocity = at(table.unpack(velocity))
  local ok, message = pcall(sim.run, sim)
  local v = sim.blocks[2].velocity
  return ok, message, c*v[1] + s*v[2], c*v[2] - s*v[1]
end
local bond = talus.joint { name = "bond", friction = 0.6, cohesion = 1e5, tension = 1e5, residual = { cohesion = 5e4 } }
local face = talus.joint { name = "face", friction = 0.6, cohesion = 5e4 }
for _, order in ipairs { 1, "rigid" } do
  for _, turn in ipairs { 0, 0.2, 0.6, 1.2 } do
    local ok, message, _, along = sheared(order, turn, { 0, 3 }, face, false, 1e-3)
    talus.check.equal(string.format("trace, order %s, turned by %g: runs", order, turn), ok and "to its end" or message, "to its end")
    talus.check.near(string.format("trace, order %s, turned by %g: speed along the face, m/s", order, turn), along, 3, { rel = 1e-6 })
  end
end
for _, push in ipairs { -1, -0.1, 0, 0.1 } do
  for _, turn in ipairs { 0, 0.6 } do
    for _, dt in ipairs { 1e-4, 1e-3 } do
      local ok, message = sheared("rigid", turn, { push, 3 }, bond, true, dt)
      talus.check.equal(string.format("bond, pushed at %g m/s, turned by %g, %g s: runs", push, turn, dt), ok and "to its end" or message, "to its end")
    end
  end
end
