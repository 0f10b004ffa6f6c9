-- Regular polygons that roll down a rough slope with automatic steps: way after 2 s, whatever lies far off in the scene.
-- Source: between impacts a body turns about its corner under gravity; at an impact that keeps it on the slope angular momentum about the next corner is
-- kept, so that its spin falls to (I + m r² cos 2π/N)/(I + m r²) of it (rimless wheel, McGeer 1990, Int. J. Robotics Res. 9(2), 62-82).
-- What is left is that contacts with springs let it rebound a little. (1 s CPU)
local talus = require "talus"
local g, r, slope, t_end = 9.81, 0.5, math.rad(20), 2

-- m, along the slope.
local function rimless_way(n)
  local half, inertia = math.pi/n, r^2/6*(2 + math.cos(2*math.pi/n))  -- per mass, about the middle
  local about_corner = inertia + r^2
  local angle, spin, way, dt = slope - half, 0, 0, 1e-6
  for _ = 1, math.floor(t_end/dt + 0.5) do
    spin = spin + g*r*math.sin(angle)/about_corner*dt
    angle = angle + spin*dt
    if angle > slope + half then
      angle, spin, way = angle - 2*half, spin*(inertia + r^2*math.cos(2*half))/about_corner, way + 2*r*math.sin(half)
    end
  end
  return way + r*(math.sin(angle - slope) + math.sin(half))
end

for _, n in ipairs { 40, 100 } do
  local expected = rimless_way(n)
  for _, far in ipairs { 0, 10, 300 } do
    local corners = {}
    for k = 0, n - 1 do
      local at = 2*math.pi*(k + 0.5)/n - math.pi/2
      corners[k + 1] = { r*math.cos(at), r*math.cos(math.pi/n) + r*math.sin(at) }
    end
    local rock = talus.material { name = "rock", density = 2500, young = 10e9, poisson = 0.2 }
    local regions = { talus.region { name = "slope", outline = talus.rect(-2, -1, 20, 0), material = rock, held = true },
                      talus.region { name = "wheel", outline = corners, material = rock } }
    if far > 0 then regions[3] = talus.region { name = "far", outline = talus.rect(-60, -far, -50, far), material = rock, held = true } end
    local sim = talus.simulation {
      gravity = { g*math.sin(slope), -g*math.cos(slope) }, contact = talus.joint { name = "rough", friction = math.rad(30) },
      regions = regions,
      time = { mode = "dynamic", t_end = t_end },
    }
    sim:run()
    local label = string.format("%d corners%s: ", n, far > 0 and ", in a scene " .. 2*far .. " m high" or "")
    talus.check.near(label .. "way of an inelastic polygon, m", sim.blocks[2].ux, expected, { rel = 0.08 })
    talus.check.below(label .. "unexplained energy at the end, of the largest", math.abs(sim.energy.unexplained)/sim.energy.scale, 0.01)
  end
end
