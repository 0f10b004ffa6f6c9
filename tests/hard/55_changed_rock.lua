-- Ours. Pyramids of bricks of three rocks, loaded on one side, in which a script changes E or the density of a rock or the friction of all joints
-- after every third load step. What sticks only by the slope that it climbs slid without it, so that the search for equilibrium went to and fro
-- (6 of 150 random pyramids found none, three of these four among them); energy: a change of E between two load steps was unexplained, 20 to 50 % of the scale.
-- Source: statics (each stands; one that does not ends the run), Betti's theorem for the work of a change (docs/theory.md, § 9). Bound: the ledger's, 1 %.
-- Run: scripts/run tests/hard/55_changed_rock.lua -p full=true    (60 pyramids; otherwise 4)
local talus = require "talus"
local full = talus.param("full", false, "pyramids 1 to 60; otherwise four of them")

local function pyramid(seed)
  math.randomseed(seed)
  local random = math.random
  local rocks, regions = {}, {}
  for i = 1, 3 do rocks[i] = talus.material { name = "rock " .. i, density = 2000 + 500*i, young = 1e7*math.exp(5*random()), poisson = 0.1*i } end
  local joint = talus.joint { name = "joint", friction = math.rad(15 + random(25)) }
  local n = 2 + random(3)
  regions[1] = talus.region { name = "floor", outline = talus.rect(-5, -1, 20, 0), material = rocks[1], held = true }
  for i = 1, n do
    for j = 1, n + 2 - i do
      local x, y = j - 1 + (i - 1)*0.5, (i - 1)*0.5
      regions[#regions + 1] = talus.region { name = "brick " .. i .. " " .. j, outline = talus.rect(x, y, x + 1, y + 0.5), material = rocks[random(3)],
        mesh = random() < 0.3 and { size = 0.5 } or nil, order = random() < 0.3 and 2 or 1 }
    end
  end
  local load = talus.edge_load { region = "brick " .. n .. " 1", on = "top", traction = { 0, { {0, 0}, {1, -5e3}, {2, -2e3} } } }
  local sim = talus.simulation { gravity = {0, -9.81}, contact = joint, regions = regions, loads = {load}, time = { mode = "static", t_end = 2, steps = 20 } }
  local worst = 0
  for step = 1, 20 do
    sim:step()
    worst = math.max(worst, math.abs(sim.energy.unexplained)/sim.energy.scale)
    if step % 3 == 0 then
      local rock, what = rocks[random(3)], random(3)
      if what == 1 then
        rock.young = rock.young*math.exp(2*random() - 1)
      elseif what == 2 then
        rock.density = rock.density*(0.5 + random())
      else
        joint.friction = math.rad(15 + random(25))
      end
    end
  end
  return sim, worst
end

local seeds = { 8, 24, 25, 105 }
if full then
  for seed = 1, 60 do seeds[seed] = seed end
end
local most = 0
for _, seed in ipairs(seeds) do
  local sim, worst = pyramid(seed)
  most = math.max(most, worst)
  print(string.format("COST  pyramid %d: %d blocks, %d cuts, unexplained at most %.2g", seed, #sim.blocks, sim.totals.cuts, worst))
end
talus.check.below("pyramids whose rock changes: unexplained, most of all load steps", most, 1e-2)
