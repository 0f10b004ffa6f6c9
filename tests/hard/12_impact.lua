-- 12. Impact at 300 m/s of a 0.1 m block on a free 0.1 m wall: no tunnelling for any Δt; momentum to 1e-12 + 10 ε·kΔt²/m a step; total
-- energy never rises by more than 1e-6 of the start.
-- Flat, and on its corner; Δt from 10 ms (3 m of way, thirty walls) to 1 µs. Source: conservation. (1 s CPU)
local talus = require "talus"
local full = talus.param("full", false, "also dt 1e-6 s")
local young = 55e9
local rock = talus.material { name = "rock", density = 2600, young = young, poisson = 0.2 }
local flat = { {-0.35, -0.05}, {-0.25, -0.05}, {-0.25, 0.05}, {-0.35, 0.05} }
local h = 0.05*math.sqrt(2)
local corner = { {-0.35 - h, 0.01}, {-0.35, 0.01 - h}, {-0.35 + h, 0.01}, {-0.35, 0.01 + h} }
for name, ball in pairs { flat = flat, corner = corner } do
  for _, dt in ipairs(full and { 1e-2, 1e-3, 1e-4, 1e-5, 1e-6 } or { 1e-2, 1e-3, 1e-4, 1e-5 }) do
    local hit = talus.simulation {
      contact = talus.joint { name = "contact", friction = 0.5 },
      regions = { talus.region { name = "wall", outline = talus.rect(0, -1, 0.1, 1), material = rock },
                  talus.region { name = "ball", outline = ball, material = rock, velocity = {300, 0} } },
      time = { mode = "dynamic", t_end = 3e-3, dt = dt },
    }
    local wall, flyer = hit.blocks[1], hit.blocks[2]
    local start, energy0 = flyer.mass*300, hit.energy.total
    local before, worst, most = start, 0, 0
    for status in hit:steps() do
      local p = wall.mass*wall.velocity[1] + flyer.mass*flyer.velocity[1]
      local allowed = 1e-12 + 10*2.2e-16*(100*young/2)*status.dt^2/flyer.mass
      worst = math.max(worst, math.abs(p - before)/start/allowed)
      before = p
      most = math.max(most, hit.energy.total/energy0)
    end
    local label = string.format("impact, %s, dt %g s: ", name, dt)
    talus.check.below(label .. "change of momentum in a step over what is allowed", worst, 1)
    talus.check.above(label .. "the ball is in front, m", wall.centroid[1] - flyer.centroid[1], 0.05)
    talus.check.below(label .. "largest energy over the first", most, 1 + 1e-6)
  end
end

-- The same of glued triangles, most of which are held all round: the bodies are what must not pass through each other.
local glue = talus.joint { name = "glue", friction = 0.5 }
for _, dt in ipairs { 1e-2, 1e-3, 1e-4 } do
  local hit = talus.simulation {
    contact = talus.joint { name = "contact", friction = 0.5 },
    regions = { talus.region { name = "wall", outline = talus.rect(0, -0.5, 0.1, 0.5), material = rock, mesh = { size = 0.05 }, joint = glue },
                talus.region { name = "ball", outline = flat, material = rock, mesh = { size = 0.03 }, joint = glue, velocity = {300, 0} } },
    time = { mode = "dynamic", t_end = 3e-3, dt = dt },
  }
  hit:run()
  local front, back = math.huge, -math.huge
  for _, b in ipairs(hit.blocks) do
    if b.region == "wall" then front = math.min(front, b.centroid[1]) else back = math.max(back, b.centroid[1]) end
  end
  talus.check.above(string.format("impact of glued triangles, dt %g s: the ball is behind, m", dt), front - back, 0)
end
