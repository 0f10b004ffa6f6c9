-- 37. A settled start and a static run of what topples: no body is laid down elsewhere. Regular polygons on slopes just below and above the angle at which they roll,
-- slabs just below and above their lean, with and without a large scene round them: a settled start stands, or begins at rest as given with a note; static mode
-- finds equilibrium, or names the block. Source: statics, tan of slope = half the face over the height above it. Ours: hexagons started 4 m off, turned by 8 rad. (1 s CPU)
local talus = require "talus"
local g = 9.81
local rock = talus.material { name = "rock", density = 2500, young = 10e9, poisson = 0.2 }
local function ngon(n, side)  -- on a face along x, from the origin
  local corners, x, y = {}, 0, 0
  for k = 0, n - 1 do
    corners[k + 1] = {x, y}
    x, y = x + side*math.cos(2*math.pi*k/n), y + side*math.sin(2*math.pi*k/n)
  end
  return corners
end
local bodies = {
  hexagon = { ngon(6, 0.5), math.pi/6 }, octagon = { ngon(8, 0.4), math.pi/8 }, square = { talus.rect(0, 0, 1, 1), math.pi/4 }, slab = { talus.rect(0, 0, 1, 3), math.atan(1/3) },
}
local function scene(outline, slope, far, time)
  local regions = { talus.region { name = "floor", outline = talus.rect(-5 - far, -1, 8 + far, 0), material = rock, held = true },
                    talus.region { name = "body", outline = outline, material = rock } }
  if far > 0 then regions[3] = talus.region { name = "far", outline = talus.rect(-6 - far, -far, -5.5 - far, far), material = rock, held = true } end
  return talus.simulation { gravity = { g*math.sin(slope), -g*math.cos(slope) }, contact = talus.joint { name = "rough", friction = math.rad(70) }, regions = regions, time = time }
end
for name, body in pairs(bodies) do
  for _, far in ipairs { 0, 30 } do
    for _, part in ipairs { 0.99, 1.01, 1.2 } do
      local label = string.format("%s, %g of its limit, %s: ", name, part, far > 0 and "large scene" or "alone")
      local settled = scene(body[1], part*body[2], far, { mode = "dynamic", t_end = 3, dt = 1e-3, start = "settled" })
      settled:step()
      local block = settled.blocks[2]
      talus.check.below(label .. "settled start, way, m", math.sqrt(block.ux^2 + block.uy^2), 1e-4)
      talus.check.below(label .. "settled start, turned by, rad", math.abs(block.rotation), 1e-4)
      settled:run()
      if part < 1 then
        talus.check.below(label .. "stands: way, m", math.sqrt(block.ux^2 + block.uy^2), 1e-4)
      else
        talus.check.above(label .. "falls: turned by, rad", math.abs(block.rotation), 0.5)
      end
      local static = scene(body[1], part*body[2], far, { mode = "static" })
      local found, message = pcall(static.run, static)
      talus.check.equal(label .. "equilibrium, static", found, part < 1)
      if not found then talus.check.truth(label .. "named", tostring(message):find("topples or falls", 1, true) ~= nil) end
    end
  end
end
