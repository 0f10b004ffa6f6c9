-- 39. A block that friction holds (80°) on a held floor that begins to move along its face: it goes with the floor. While the floor gets faster the
-- block lags by what bends the springs, at any step; at a steady speed, and when the floor has stopped, not at all.
-- Source: sticking friction; the lag is what the springs are stretched by, and the middle of a block by its shear, ρ a h²/4G (it tilts a little, too). Ours: the shear springs of a contact knew the floor's way and not that it had got
-- faster, and left the block behind by (θ − ½) Δt v, 12 mm at 5 m/s and 10 ms, with nothing of it in slip, friction or the ledger; then by the second
-- power of the step, as they went by the floor's mean speed in it. And a floor that gets faster upwards, a lift: what stands on
-- it does not sink in. Ours: contacts looked ahead by the floor's mean speed in a step, and the block sank by up to 2 mm and stayed. (0.3 s CPU)
local talus = require "talus"
local rock = talus.material { name = "rock", density = 2500, young = 50e9, poisson = 0.2 }
local function lag(dt, speeds)
  local sim = talus.simulation {
    gravity = {0, -9.81}, contact = talus.joint { name = "rough", friction = math.rad(80) },
    regions = { talus.region { name = "floor", outline = talus.rect(-2, -1, 2, 0), held = true, material = rock },
                talus.region { name = "block", outline = talus.rect(-2, 0, 2, 1), material = rock } },
    fix = { talus.fix { region = "floor", velocity = { speeds, 0 } } }, time = { t_end = 1, dt = dt, start = "settled" },
  }
  local off, rest = 0, 0  -- m, beside what bends the springs
  local floor, block = sim.blocks[1], sim.blocks[2]
  for _ in sim:steps() do
    local bent = 0
    for _, c in ipairs(sim.contacts) do bent = math.max(bent, math.abs(c.stretch)) end
    off, rest = math.max(off, math.abs(floor.ux - block.ux) - bent), math.max(rest, math.abs(sim.energy.unexplained)/sim.energy.scale)
  end
  return off, math.abs(floor.ux - block.ux), rest
end
for name, speeds in pairs { ["to 5 m/s in 0.5 s"] = { {0, 0}, {0.5, 5} }, ["to 1 m/s and back"] = { {0, 0}, {0.4, 1}, {0.8, 0} } } do
  local a, h, shear_modulus = speeds[2][2]/speeds[2][1], 1, 50e9/2.4
  local label = "floor that moves, " .. name .. ": "
  for step, dt in pairs { ["20 ms"] = 2e-2, ["10 ms"] = 1e-2, automatic = false } do
    local off, left, rest = lag(dt or nil, speeds)
    talus.check.below(label .. step .. ": lag beside that of the springs over that of the block's own shear", off/(rock.density*a*h^2/(4*shear_modulus)), 1.5)
    talus.check.below(label .. step .. ": lag at the end, m", left, 1e-8)
    talus.check.below(label .. step .. ": unexplained over scale", rest, 1e-6)
  end
end
for _, speed in ipairs { 1, 5, 20 } do
  for name, dt in pairs { ["10 ms"] = 1e-2, automatic = false } do
    for _, start in ipairs { "rest", "settled" } do
      local sim = talus.simulation {
        gravity = {0, -9.81}, contact = talus.joint { name = "rough", friction = 0.5 },
        regions = { talus.region { name = "floor", outline = talus.rect(-4, -1, 4, 0), held = true, material = rock },
                    talus.region { name = "block", outline = talus.rect(-0.5, 0, 0.5, 1), material = rock } },
        fix = { talus.fix { region = "floor", velocity = { 0, { {0, 0}, {0.5, speed} } } } }, time = { t_end = 2, dt = dt or nil, start = start },
      }
      sim:run()
      local low = math.huge
      for _, corner in ipairs(sim.blocks[2].vertices) do low = math.min(low, corner[2]) end
      talus.check.below(string.format("lift to %g m/s in 0.5 s, from %s, %s: sunk into the floor, m", speed, start, name), sim.blocks[1].uy - low, 5e-6)
    end
  end
end

-- Two piers and a lintel stand on a floor that shakes, without sliding: a row of its table every 10 ms, and a step each. A gain that is small beside the work of the floor cut 40 to 77 steps, and what grew back took 4 to 7 times as many.
for _, order in ipairs { "rigid", 1, 2 } do
  local stone = talus.material { name = "stone", density = 2200, young = 5e9, poisson = 0.2 }
  local regions = { talus.region { name = "floor", outline = talus.rect(-8, -1, 12, 0), material = stone, held = true } }
  for k, outline in ipairs { talus.rect(0, 0, 0.65, 2), talus.rect(2.5, 0, 3.15, 2), talus.rect(-0.2, 2, 3.35, 2.5) } do
    regions[k + 1] = talus.region { name = "stone " .. k, outline = outline, material = stone, order = order }
  end
  local rows, w = {}, 4*math.pi
  for k = 0, 400 do rows[k + 1] = { k/100, math.sin(w*k/100)/w } end
  local sim = talus.simulation { gravity = {0, -9.81}, contact = talus.joint { friction = math.rad(30) }, regions = regions,
    fix = { talus.fix { region = "floor", velocity = { rows, 0 } } }, time = { t_end = 4, start = "settled" } }
  sim:run()
  local e = sim.energy
  talus.check.below(string.format("trilith on a floor that shakes by 1 m/s², order %s: steps, of the rows", order), sim.totals.steps/400, 2.5)
  talus.check.below(string.format("trilith, order %s: part of the steps that were cut", order), sim.totals.cuts/sim.totals.steps, 0.05)
  talus.check.above(string.format("trilith, order %s: numerical loss, of the scale", order), e.numerical/e.scale, -1e-3)
end
