-- 48. Notches of 1 to 5° that a needle falls into, bowls of facets of 0.1 to 3.2° that a square rests in, at once, in static runs and settled, and a smooth drum that swings in a tunnel of 333 to 1000 sides: nothing goes
-- through a bottom, nothing sinks, all energy is accounted for in long and short steps. Tips that hit the side of a notch at its bottom are held as they are a little farther up.
-- Source: geometry; a square on two corners in a circle of R; a point mass in a circle, T = 2π √((R − r)/g) (1 + a²/16). Ours: the bottom of a notch below 3° was no corner, and the needle fell
-- on for ever; slow bodies sank by 6 mm into bowls; a corner of the tunnel was taken to press on the drum between the drum's own corners, 2 % of the energy gone with it in short steps; the floor of a notch was taken for the far side of its wall, and tips pressed in by 1e-3 of their size went through it. (2 s CPU)
local talus = require "talus"
local g = 9.81
local rock = talus.material { name = "rock", density = 2500, young = 20e9, poisson = 0.2 }
for _, open in ipairs { 1, 2.5, 2.9, 3.1, 5 } do
  for _, order in ipairs { "rigid", 1 } do
    local c, n, H, gap = math.tan(math.rad(open/2)), math.tan(math.rad(open/4)), 3, 5e-3
    local sim = talus.simulation {
      gravity = {0.3, -g}, contact = talus.joint { friction = math.rad(5) },
      regions = { talus.region { name = "notch", outline = {{-2, -1}, {2, -1}, {2, H}, {H*c, H}, {0, 0}, {-H*c, H}, {-2, H}}, material = rock, held = true },
                  talus.region { name = "needle", outline = {{0, gap}, {3.5*n, 3.5 + gap}, {-3.5*n, 3.5 + gap}}, material = rock, order = order } },
      time = { t_end = 1, dt = 2e-3 },
    }
    sim:run()
    talus.check.between(string.format("needle in a notch of %g°, order %s: falls, m", open, order), -sim.blocks[2].uy, 0.8*gap, 1.2*gap)
  end
end
local R, half = 5, 0.5
local function bowl(facet)
  local surface, n = {{-R - 1, -R - 1}, {R + 1, -R - 1}}, math.floor(100/facet + 0.5)
  for k = n, 0, -1 do
    local a = math.rad(-50 + 100*k/n)
    surface[#surface + 1] = { R*math.sin(a), -R*math.cos(a) }
  end
  return surface
end
for _, facet in ipairs { 0.1, 0.5, 1, 2, 2.9, 3.2 } do
  local floor = bowl(facet)
  local low = math.sqrt(R^2 - half^2)
  for _, time in ipairs { { mode = "static" }, { t_end = 0.2, dt = 2e-3, start = "settled" }, { t_end = 0.2, dt = 2e-3 } } do
    local sim = talus.simulation {
      gravity = {0, -g}, contact = talus.joint { friction = math.rad(35) },
      regions = { talus.region { name = "bowl", outline = floor, material = rock, held = true },
                  talus.region { name = "square", outline = talus.rect(-half, -low, half, -low + 2*half), material = rock } },
      time = time,
    }
    sim:run()
    local deepest = 0
    for _, p in ipairs(sim.blocks[2].vertices) do
      for k = 4, #floor do
        local a, b = floor[k], floor[k - 1]  -- from left to right
        local x, y = b[1] - a[1], b[2] - a[2]
        local s = ((p[1] - a[1])*x + (p[2] - a[2])*y)/(x*x + y*y)
        if s >= 0 and s <= 1 then deepest = math.max(deepest, -((p[2] - a[2])*x - (p[1] - a[1])*y)/math.sqrt(x*x + y*y)) end
      end
    end
    local drawn = R*(1 - math.cos(math.rad(facet/2)))  -- a chord lies so far inside the circle that the square is drawn on
    local label = string.format("square in a bowl of facets of %g°, %s: ", facet, time.mode or time.start or "at once")
    talus.check.below(label .. "deepest, m", deepest, 1e-6 + drawn)
    talus.check.below(label .. "turned by, rad", math.abs(sim.blocks[2].rotation), 1e-3)
  end
end
for _, turn in ipairs { 0.05, 0.5, 1, 2.9, 3.1 } do
  for _, order in ipairs { "rigid", 1 } do
    local rise = 2*math.tan(math.rad(turn/2))
    local sim = talus.simulation {
      gravity = {0, -g}, contact = talus.joint { friction = math.rad(35), stiffness = { per = "area", value = 5e9 } },
      regions = { talus.region { name = "valley", outline = {{-2, -1}, {2, -1}, {2, rise}, {0, 0}, {-2, rise}}, material = rock, held = true },
                  talus.region { name = "tip", outline = {{0, 0}, {0.5, 1}, {-0.5, 1}}, material = rock, order = order } },
      time = { t_end = 0.2, dt = 1e-3 },
    }
    sim:run()
    talus.check.below(string.format("tip that stands in a valley of %g°, order %s: deepest, m", turn, order), -sim.blocks[2].vertices[1][2], 2e-5)
    talus.check.below(string.format("tip that stands in a valley of %g°, order %s: unexplained, of scale", turn, order), math.abs(sim.energy.unexplained)/sim.energy.scale, 1e-6)
  end
end
local r, from = 1, math.rad(20)
local T = 2*math.pi*math.sqrt((3 - r)/g)*(1 + from^2/16)
for _, sides in ipairs { {100, 333}, {200, 1000} } do
  for _, dt in ipairs { 1e-2, 1e-3 } do
    local wall, drum = {{-5, -5}, {5, -5}, {5, 0.01}}, {}
    for k = 0, sides[2] do wall[#wall + 1] = { 3*math.cos(-math.pi*k/sides[2]), 3*math.sin(-math.pi*k/sides[2]) } end
    wall[#wall + 1] = {-5, 0}
    local at = { (3 - r - 2e-3)*math.sin(from), -(3 - r - 2e-3)*math.cos(from) }
    for k = 1, sides[1] do drum[k] = { at[1] + r*math.cos(0.1 + 2*math.pi*k/sides[1]), at[2] + r*math.sin(0.1 + 2*math.pi*k/sides[1]) } end
    local sim = talus.simulation {
      gravity = {0, -g}, contact = talus.joint { friction = 0 },
      regions = { talus.region { name = "tunnel", outline = wall, material = rock, held = true }, talus.region { name = "drum", outline = drum, material = rock, order = "rigid" } },
      time = { t_end = 0.8*T, dt = dt },
    }
    local crossed, before, most = {}, at[1], 0
    for status in sim:steps() do
      local x = sim.blocks[2].centroid[1]
      if x < 0 ~= (before < 0) then crossed[#crossed + 1] = status.time - status.dt*x/(x - before) end
      before, most = x, math.max(most, math.abs(sim.energy.unexplained)/sim.energy.scale)
    end
    local label = string.format("drum of %d sides in a tunnel of %d, steps of %g ms: ", sides[1], sides[2], 1e3*dt)
    talus.check.near(label .. "half a period, s", (crossed[2] or 0) - (crossed[1] or 0), T/2, { rel = 0.01 })
    talus.check.below(label .. "unexplained, most of a step, of scale", most, 1e-5)
  end
end
-- A wedge flies at 3 m/s at right angles onto the overhanging side of a notch, `at` from its bottom.
local function tip_onto_side(degrees, at)
  local a = math.rad(degrees)
  local c, s = math.cos(a), math.sin(a)
  local x, y = at*c + 0.001*s, math.max(at*s - 0.001*c, 1e-6)
  local soft = talus.material { name = "soft", density = 2600, young = 100e6, poisson = 0.2 }
  local low, high = math.rad(2), a - math.rad(12)
  local sim = talus.simulation {
    contact = talus.joint { friction = 0, stiffness = 1 }, time = { t_end = 0.05, dt = 2e-4 }, output = { vtk = false, picture = false },
    regions = { talus.region { name = "notch", material = soft, held = true, outline = {{-2, -1}, {4, -1}, {4, 0}, {0, 0}, {1.5*c, 1.5*s}, {1.5*c - 0.5, 2.5}, {-2, 2.5}} },
                talus.region { name = "wedge", material = soft, velocity = {-3*s, 3*c},
                  outline = {{x, y}, {x + math.cos(low), y + math.sin(low)}, {x + math.cos(high), y + math.sin(high)}} } },
  }
  local deepest = 0
  for _ in sim:steps() do
    local p = sim.blocks[2].vertices[1]
    deepest = math.max(deepest, p[2]*c - p[1]*s)
  end
  return deepest/math.sqrt(sim.blocks[2].area)
end
for _, degrees in ipairs { 20, 45, 60 } do
  local bottom, above = tip_onto_side(degrees, 5e-4), tip_onto_side(degrees, 0.1)
  talus.check.below(string.format("tip onto the side of a notch of %d°, at its bottom: deepest over as deep farther up", degrees), bottom/above, 2)
end
