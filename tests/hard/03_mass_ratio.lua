-- 3. Mass ratio 1e6, light block below: contact force within 1e-6, at most 6 open–close iterations a step.
-- From a settled start, and with gravity put on at once (iterations only: the heavy block bounces).
-- Source: equilibrium. (0.2 s CPU)
local talus = require "talus"
local g = 9.81
local function rock(density)
  return talus.material { name = "rock " .. density, density = density, young = 10e9, poisson = 0.2 }
end
for _, start in ipairs { "settled", "rest" } do
  local pair = talus.simulation {
    gravity = {0, -g}, contact = talus.joint { name = "contact", friction = 0.5 },
    regions = { talus.region { name = "floor", outline = talus.rect(-2, -1, 3, 0), material = rock(2500), held = true },
                talus.region { name = "light", outline = talus.rect(0, 0, 1, 1), material = rock(2.5) },
                talus.region { name = "heavy", outline = talus.rect(0, 1, 1, 2), material = rock(2.5e6) } },
    time = { mode = "dynamic", t_end = 0.5, dt = 1e-3, start = start },
  }
  local most = 0
  for status in pair:steps() do most = math.max(most, status.iterations) end
  local force = 0
  for _, c in ipairs(pair.contacts) do
    if c.block_i == 3 or c.block_j == 3 then force = force + c.normal_force end
  end
  if start == "settled" then
    talus.check.near("mass ratio 1e6: contact force over weight", force/(2.5e6*g), 1, { rel = 1e-6 })
  end
  talus.check.below("mass ratio 1e6, from " .. start .. ": most iterations of a step", most, 6.5)
end
