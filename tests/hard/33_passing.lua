-- 33. Bodies that pass each other by with a clear gap feel nothing, whatever part of their thickness a step moves them; spinning
-- polygons that meet in flight do not sink into each other, whatever part of a side a corner moves in a step.
-- Source: geometry. Ours: a contact is a vertex against the line of an edge. Slabs 1 cm apart stopped each other by the lines of faces that
-- their corners never reached; corners that came to an edge from beyond its ends went 16 cm deep. (2 s CPU)
local talus = require "talus"
local rock = talus.material { name = "rock", density = 2500, young = 10e9, poisson = 0.2 }

-- Largest contact force in a flight of `a` at `speed` past `b`, N/m.
local function force_in_passing(a, b, speed, dt)
  local sim = talus.simulation {
    contact = talus.joint { name = "contact", friction = 0.3 },
    regions = { talus.region { name = "a", outline = a, material = rock, velocity = {speed, 0} },
                talus.region { name = "b", outline = b, material = rock } },
    time = { mode = "dynamic", t_end = 2.2/speed, dt = dt },
  }
  local most = 0
  for _ in sim:steps() do
    for _, force in ipairs(sim.contacts:field "normal_force") do most = math.max(most, force) end
  end
  return most
end

for _, step in ipairs { 0.1, 0.02, 0.002 } do
  local slabs, wedges = 0, 0
  for _, speed in ipairs { 1, 100 } do
    for _, gap in ipairs { 0.0005, 0.01 } do
      for _, thick in ipairs { 0.001, 0.05 } do
        slabs = math.max(slabs, force_in_passing(talus.rect(-1, -thick, -0.05, 0), talus.rect(0.05, gap, 1, gap + thick), speed, step/speed))
      end
      for _, thick in ipairs { 0.006, 0.06 } do
        wedges = math.max(wedges, force_in_passing({ {-1, -thick}, {-0.05, 0}, {-1, 0} },
                                                   { {1, gap}, {1, gap + thick}, {0.05, gap} }, speed, step/speed))
      end
    end
  end
  talus.check.equal(string.format("slabs that pass each other, %g m a step: largest contact force, N/m", step), slabs, 0)
  talus.check.equal(string.format("wedges that pass each other, %g m a step: largest contact force, N/m", step), wedges, 0)
end

local function regular(corners, radius, x, y, turn)
  local points = {}
  for k = 1, corners do
    local a = turn + 2*math.pi*k/corners
    points[k] = { x + radius*math.cos(a), y + radius*math.sin(a) }
  end
  return points
end

-- m, of the deepest corner of one convex polygon in the other.
local function deepest(corners, body)
  local most = 0
  for _, p in ipairs(corners) do
    local depth = math.huge
    for k, a in ipairs(body) do
      local b = body[k % #body + 1]
      local x, y = b[1] - a[1], b[2] - a[2]
      depth = math.min(depth, (x*(p[2] - a[2]) - y*(p[1] - a[1]))/math.sqrt(x*x + y*y))
    end
    most = math.max(most, depth)
  end
  return most
end

-- Within a step of 10 ms a corner moves 0.3 m, and a body that is turned back lies Δt/4 · v deeper than where contacts are judged.
for _, case in ipairs { {1e-2, 0.02}, {5e-3, 0.01}, {1e-3, 0.01} } do
  local dt, bound = case[1], case[2]
  local most = 0
  for _, corners in ipairs { 4, 6, 12 } do
    for _, spin in ipairs { 5, 15, 40 } do
      for _, sense in ipairs { 1, -1 } do
        for _, height in ipairs { 0.1, 0.4 } do
          local sim = talus.simulation {
            contact = talus.joint { name = "contact", friction = 0.6 },
            regions = { talus.region { name = "a", outline = regular(6, 0.43, -0.6, 0, 0.3), material = rock, velocity = {15, 0}, spin = spin },
                        talus.region { name = "b", outline = regular(corners, 0.35, 0.3, height, 0.1), material = rock, spin = sense*spin } },
            time = { mode = "dynamic", t_end = 0.053, dt = dt },
          }
          for _ in sim:steps() do
            local outlines = sim.blocks:field "vertices"
            most = math.max(most, deepest(outlines[1], outlines[2]), deepest(outlines[2], outlines[1]))
          end
        end
      end
    end
  end
  talus.check.below(string.format("spinning polygons that meet, dt %g s: deepest corner, m", dt), most, bound)
end
