-- The discs of Ning, Yang, An & Ma (2011), Figs. 6 to 10: two flats, pressed between smooth plates until they split.
-- A part of examples 06 to 09 and of tests/verify: local disc = require "parts.flattened_disc"
local talus = require "talus"
local u = talus.units

local disc = { radius = 25*u.mm, half_angle = 3.6*u.deg }
disc.half_height = disc.radius*math.cos(disc.half_angle)
disc.half_flat = disc.radius*math.sin(disc.half_angle)
-- |y| of what lies two widths of a flat away from the plates. Nearer, rock is pressed from all sides: it is wedged out only as the
-- halves part, while small cracks open beside the flats.
disc.clear_of_plates = disc.half_height - 4*disc.half_flat
disc.at_plates = disc.half_height - 2*disc.half_flat  -- one width

-- The outline in chords of about `size`, clockwise from the top flat or, mirrored, counter-clockwise from it.
function disc.outline(size, mirrored)
  local points, sign = {}, mirrored and -1 or 1
  local function arc(from, to)
    local chords = math.max(2, math.ceil(disc.radius*(to - from)/size))
    for i = 0, chords do
      local a = from + (to - from)*i/chords
      points[#points + 1] = { sign*disc.radius*math.sin(a), disc.radius*math.cos(a) }
    end
  end
  arc(disc.half_angle, math.pi - disc.half_angle)
  arc(math.pi + disc.half_angle, 2*math.pi - disc.half_angle)
  return talus.polygon(points)
end

-- Blocks of 0.8 mm at the flats. A smooth plate presses a flat harder at its ends, and the stress at the centre falls by the part 4<x²>/r²
-- of the pressure: by 4a²/3 where it is even, 4a² where it is all at the ends of the half-angle a, which is 1.1 % more for these. A flat
-- that is one edge of one block has no other choice.
function disc.mesh(size)
  local flats = { { at = {0, disc.half_height}, size = 0.8*u.mm }, { at = {0, -disc.half_height}, size = 0.8*u.mm } }
  return { size = talus.grade { flats[1], flats[2], far = size } }
end

-- What is left of a failed joint is the default: its friction, 0.05 MPa of cohesion, no tension.
disc.rock = talus.material { name = "rock", density = 2500, young = 10*u.GPa, poisson = 0.2 }
function disc.joint(more)
  local fields = { name = "rock", friction = 35*u.deg, cohesion = 4*u.MPa, tension = 0.5*u.MPa }
  for key, value in pairs(more or {}) do fields[key] = value end
  return talus.joint(fields)
end

-- The disc with a hole beside its centre.
function disc.holed(size, radius, eccentricity)
  local hole = talus.circle { at = {eccentricity, 0}, radius = radius, name = "hole", sides = math.ceil(2*math.pi*radius/size) }
  return talus.region { name = "disc", outline = disc.outline(size), holes = { hole }, material = disc.rock, mesh = { size = size },
                        joint = disc.joint() }
end
-- Whether a crack touches it: its middle is within two edges of the wall.
function disc.at_hole(crack, size, radius, eccentricity)
  return math.sqrt((crack.x - eccentricity)^2 + crack.y^2) < radius + 2*size
end

-- A simulation of the region `body`. The upper plate comes down by 0.1 mm in ten increments of load.
function disc.simulation(body, more)
  local h, b = disc.half_height, disc.half_flat
  local fields = {
    regions = {
      body,
      talus.region { name = "upper plate", outline = talus.rect(-2*b, h, 2*b, h + 2*b), material = disc.rock, order = "rigid" },
      talus.region { name = "lower plate", outline = talus.rect(-2*b, -h - 2*b, 2*b, -h), material = disc.rock, held = true },
    },
    contact = talus.joint { name = "smooth", friction = 0 },
    fix = { talus.fix { name = "press", region = "upper plate", on = "top", displacement = {0, { {0, 0}, {1, -0.1*u.mm} }} } },
    time = { mode = "static", steps = 10 },
  }
  for key, value in pairs(more or {}) do fields[key] = value end
  return talus.simulation(fields)
end

function disc.load(sim) return -sim.reactions.press[2] end

-- Whether what lies within |y| < `height` has come apart into two bodies, each of a quarter of the blocks or more.
function disc.is_split(sim, height)
  local y, state = sim.blocks:field "centroid", sim.joints:field "state"
  local a, b = sim.joints:field "block_a", sim.joints:field "block_b"
  local body = {}
  local function root(k)
    while body[k] ~= k do body[k] = body[body[k]]; k = body[k] end
    return k
  end
  for k = 1, #y do body[k] = math.abs(y[k][2]) < height and k or nil end
  for j = 1, #a do
    if state[j] == "intact" and body[a[j]] and body[b[j]] then body[root(a[j])] = root(b[j]) end
  end
  local blocks, large = {}, 0
  for k in pairs(body) do local r = root(k); blocks[r] = (blocks[r] or 0) + 1 end
  for _, count in pairs(blocks) do if count > #y/4 then large = large + 1 end end
  return large >= 2
end

-- Whether cracks with |x| < `band`, taken as upright, cross every height clear of the plates: a bond that bridges the gap between two
-- may still hold the halves together. `blank`: half the height of a hole at mid-height, where there is nothing to crack.
local function crosses_all(failed, blank, band)
  local spans = { { -blank, blank } }
  for _, crack in ipairs(failed) do
    if math.abs(crack.x) < band then spans[#spans + 1] = { crack.y - crack.length/2, crack.y + crack.length/2 } end
  end
  table.sort(spans, function(s, t) return s[1] < t[1] end)
  local reached = -disc.clear_of_plates
  for _, span in ipairs(spans) do
    if span[1] > reached then break end
    reached = math.max(reached, span[2])
  end
  return reached > disc.clear_of_plates
end

-- Runs it until it splits. What came of it: `first`, the first crack clear of the plates; `initiation` and `splitting`, the loads at
-- that crack and the largest (N/m); `failed`, each failed joint in order, and how many of them it took to go `through`; whether it
-- `split`. Writes an output time at the first crack. options: `height`, of what has to split; `blank`, `band` (else anywhere), see above;
-- `until_through`, whether to end there.
function disc.break_up(body, more, options)
  options = options or {}
  local height, blank, band = options.height or disc.clear_of_plates, options.blank or 0, options.band or math.huge
  local seen = { failed = {}, splitting = 0 }
  local fields = {}
  for key, value in pairs(more or {}) do fields[key] = value end
  function fields.on_fracture(sim, cracks)
    seen.splitting = math.max(seen.splitting, disc.load(sim))
    for _, crack in ipairs(cracks) do
      seen.failed[#seen.failed + 1] = crack
      if not seen.first and math.abs(crack.y) < disc.clear_of_plates then
        seen.first, seen.initiation = crack, disc.load(sim)
        sim:output()
      end
    end
    seen.split = disc.is_split(sim, height)
    if not seen.through and (seen.split or crosses_all(seen.failed, blank, band)) then seen.through = #seen.failed end
    if seen.split or options.until_through and seen.through then sim:stop() end
  end
  local sim = disc.simulation(body, fields)
  sim:run()
  return sim, seen
end

-- Part of the length that failed until cracks went through that `where(x, y)` holds for.
function disc.share(seen, where)
  local inside, all = 0, 0
  for k = 1, seen.through or 0 do
    local crack = seen.failed[k]
    all = all + crack.length
    if where(crack.x, crack.y) then inside = inside + crack.length end
  end
  return inside/all
end

return disc
