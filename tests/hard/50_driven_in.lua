-- 50. What is driven against something that cannot give way stops the run with a message that names both blocks, before corners come out on
-- the other side; what is written stays. A block that deforms is squeezed and stops the run by that.
-- Source: none; a contact pressed in by a tenth of a block bears ten times Young's modulus. Ours: a held punch went through a rigid block on
-- its floor in steps of 1e-5 s, and through one whose edges are fixed, to the end of the run, without a word. (0.1 s CPU)
local talus = require "talus"
local u = talus.units
local rock = talus.material { name = "rock", density = 2500, young = 1*u.GPa, poisson = 0.25 }
local cases = {
  { "rigid on a floor", order = "rigid", floor = true },
  { "rigid on a floor, 1 ms", order = "rigid", floor = true, dt = 1*u.ms },
  { "rigid on a pin", order = "rigid", fix = { talus.fix { region = "block", on = talus.point(0, 0.5) } } },
  { "fixed edges", fix = { talus.fix { region = "block", on = "bottom" }, talus.fix { region = "block", on = "top" } } },
  { "rigid on a floor, static", order = "rigid", floor = true, static = true },
  { "on a floor", floor = true, squeezed = true },
}
for _, case in ipairs(cases) do
  local name = case[1]
  local regions = { talus.region { name = "block", outline = talus.rect(-0.5, 0, 0.5, 1), material = rock, order = case.order },
                    talus.region { name = "punch", outline = talus.rect(-0.25, 1.001, 0.25, 2), material = rock, held = true } }
  if case.floor then regions[3] = talus.region { name = "floor", outline = talus.rect(-5, -1, 5, 0), material = rock, held = true } end
  local fix = { talus.fix { region = "punch", velocity = {0, -0.1} } }
  for _, more in ipairs(case.fix or {}) do fix[#fix + 1] = more end
  local sim = talus.simulation { gravity = {0, -9.81}, contact = talus.joint { name = "seat", friction = math.rad(30) }, regions = regions, fix = fix,
    time = { mode = case.static and "static" or "dynamic", t_end = 12, steps = case.static and 60 or nil, dt = case.dt } }
  local deepest = 0  -- m, of contacts
  local ran, message = pcall(function()
    for _ in sim:steps() do
      for _, c in ipairs(sim.contacts) do deepest = math.max(deepest, -c.gap) end
    end
  end)
  message = tostring(message)
  talus.check.truth(name .. ": stopped", not ran)
  if case.squeezed then
    talus.check.truth(name .. ": squeezed, as it says", message:find 'region "block".*would be squeezed to less than a tenth' ~= nil)
  else
    talus.check.truth(name .. ": both are named", message:find 'is pressed in by .* m where it meets' and message:find 'region "punch"' and message:find 'region "block"' ~= nil)
  end
  talus.check.below(name .. ": deepest contact, m", deepest, 0.1*math.sqrt(0.4995) + 0.02)
  talus.check.above(name .. ": time reached, s", sim.time, 0.7)
end

-- What is free gives way: rigid blocks on soft joints that hit at 120 m/s are pressed in by more than a tenth, v √(m/2k), and part.
local flying = talus.simulation { contact = talus.joint { name = "soft", friction = 0, stiffness = { per = "area", value = 1e9 } },
  regions = { talus.region { name = "block", outline = talus.rect(-0.5, 0, 0.5, 1), material = rock, order = "rigid" },
              talus.region { name = "stone", outline = talus.rect(-0.5, 1.001, 0.5, 2.001), material = rock, order = "rigid", velocity = {0, -120} } },
  time = { mode = "dynamic", t_end = 0.05, dt = 1e-5 } }
local deepest = 0
for _ in flying:steps() do
  for _, c in ipairs(flying.contacts) do deepest = math.max(deepest, -c.gap) end
end
talus.check.above("two in flight that hit: deepest contact, m", deepest, 0.11)
talus.check.above("two in flight that hit: they part, m/s", flying.blocks[2].velocity[2] - flying.blocks[1].velocity[2], 60)
