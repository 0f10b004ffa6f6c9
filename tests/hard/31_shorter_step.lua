-- 31. A square hits the floor in a step of 1 ms, and the next steps are shorter: no step gains 1e-6 of the energy at the start.
-- Source: energy. Ours: after a hit the block lies Δt/4 · v deeper than where the scheme looks for contacts; a shorter step found that depth as
-- a load, and threw the block up with many times its energy. The short step is what the end of the run leaves. (0.5 s CPU)
local talus = require "talus"
local tools = require "tools"
local g, young = tools.g, 10e9
local rock = talus.material { name = "rock", density = 2500, young = young, poisson = 0.2 }
for _, tilt in ipairs { 0, 0.3 } do
  for _, rest in ipairs { 0.5, 0.1, 0.01 } do
    local c, s = math.cos(tilt), math.sin(tilt)
    local sim = talus.simulation {
      gravity = {0, -g}, contact = talus.joint { name = "contact", friction = 0.5 },
      regions = { talus.region { name = "floor", outline = talus.rect(-20, -1, 20, 0), material = rock, held = true },
                  talus.region { name = "square", outline = { {0, 0}, {c, s}, {c - s, s + c}, {-s, c} }, material = rock, velocity = {0, -10} } },
      time = { mode = "dynamic", t_end = (1 + rest)*1e-3, dt = 1e-3 },
    }
    local gain = tools.gains(sim)
    tools.watch(sim, gain)
    talus.check.below(string.format("hit at tilt %g, then a step of %g of the last: gain over kinetic + stored", tilt, rest), gain(), 1e-6)
  end
end

-- Thrown up, down again and over the floor with automatic steps, which shrink and grow by the speed: nothing gains in flight or in landing. Ours: the
-- weight of what flies was read at y, and total energy rose by up to 30 % of kinetic energy as a step was cut.
for _, friction in ipairs { 0, 0.5 } do
  local sim = talus.simulation {
    gravity = {0, -g}, contact = talus.joint { name = "contact", friction = friction },
    regions = { talus.region { name = "floor", outline = talus.rect(-20, -1, 20, 0), material = rock, held = true },
                talus.region { name = "square", outline = talus.rect(0, 1, 0.3, 1.3), material = rock, velocity = {1, 5}, spin = 3 },
                talus.region { name = "lying", outline = talus.rect(2, 0, 3, 1), material = rock } },
    time = { mode = "dynamic", t_end = 3 },
  }
  local gain = tools.gains(sim)
  tools.watch(sim, gain)
  talus.check.below(string.format("thrown up, friction %g, automatic steps: gain over kinetic + stored", friction), gain(), 1e-6)
end

-- A bar of bonded blocks, a single block and one of second order that swing and turn freely, and a last step of another length: nothing gains. Ours:
-- y = X + Δt v/4, by which blocks and bonds are stretched, lay elsewhere with another Δt, and with it up to 29 % of their energy.
for kind, region in pairs {
  mesh = { outline = talus.rect(-1, -0.05, 1, 0.05), mesh = { kind = "cross", nx = 10, ny = 1 }, joint = talus.joint { friction = 0.5 } },
  springs = { outline = talus.rect(-1, -0.05, 1, 0.05), mesh = { kind = "cross", nx = 10, ny = 1 },
              joint = talus.joint { friction = 0.5, bond = "spring" } },
  ["first order"] = { outline = talus.rect(0, 0, 1, 1) },
  ["second order"] = { outline = talus.rect(-1, -0.05, 1, 0.05), order = 2 },
} do
  region.name, region.material = "body", talus.material { name = "rock", density = 2500, young = 50e9, poisson = 0.2 }
  local at, gain = kind == "first order" and {1, 0.9} or {0.95, 0}, -math.huge
  for steps = 12, 20, 0.3 do  -- not whole
    local push = { {0, 0}, {2e-4, 2e6}, {4e-4, 0}, {1, 0} }
    local sim = talus.simulation { regions = { talus.region(region) },
      loads = { talus.point_load { region = "body", at = at, force = { push, push } } }, time = { t_end = steps*1e-4, dt = 1e-4 } }
    local before
    for _ in sim:steps() do
      if before then gain = math.max(gain, (sim.energy.total - before)/before) end
      before = sim.time > 4.5e-4 and sim.energy.total or nil
    end
  end
  talus.check.below(kind .. ", swinging and turning, last step of a part of the others: largest gain in a step, of the energy", gain, 1e-6)
end
