-- 5. Needles: angles of 0.05–0.5°, aspect 1000, in a glued plate: far field within 1 %, iterations < 3 × a clean mesh, no NaN.
-- A plate of 25 glued squares, and the same with six more glued lines that cross its joints at 0.05°, 0.1° and 0.5°; pulled; sheared (both
-- meshed, which merges traces nearer than 2 % of its size: at 0.5° only); and standing on a floor in motion (for the iterations, and a stack on it).
-- Source: uniform tension σ = p, and the clean plate. (1 s CPU)
local talus = require "talus"
local tools = require "tools"
local g = tools.g
local rock = talus.material { name = "rock", density = 2500, young = 10e9, poisson = 0.25 }
local glue = talus.joint { name = "glue", friction = 0.6, tension = 1e9, cohesion = 1e9 }

local function plate(needles, size)
  local cuts = {}
  for k = 1, 4 do
    cuts[#cuts + 1] = talus.trace { points = { {-1, 0.4*k}, {3, 0.4*k} }, bonded = true, joint = glue }
    cuts[#cuts + 1] = talus.trace { points = { {0.4*k, -1}, {0.4*k, 3} }, bonded = true, joint = glue }
  end
  for i, degrees in ipairs(needles and (size and { 0.5, -0.5 } or { 0.05, 0.1, 0.5, -0.05, -0.1, -0.5 }) or {}) do
    local slope = math.tan(math.rad(degrees))
    local x, y = 0.93, 0.4*(1 + (i - 1) % 4)     -- crosses the joint between two corners
    cuts[#cuts + 1] = talus.trace { points = { {x - 4, y - 4*slope}, {x + 4, y + 4*slope} }, bonded = true, joint = glue }
  end
  return { name = "plate", outline = talus.rect(0, 0, 2, 2), material = rock, joint = glue, cuts = cuts,
           slivers = "keep", mesh = size and { size = size } or nil }
end
local function thinnest(sim)
  local least = math.huge
  for _, b in ipairs(sim.blocks) do
    local p, longest = b.vertices, 0
    for i = 1, #p do
      for j = 1, i - 1 do longest = math.max(longest, math.sqrt((p[i][1] - p[j][1])^2 + (p[i][2] - p[j][2])^2)) end
    end
    least = math.min(least, b.area/longest^2)
  end
  return least
end
local function finite(sim)
  for _, b in ipairs(sim.blocks) do
    for _, v in ipairs { b.ux, b.uy, b.rotation, b.sxx, b.syy, b.sxy } do
      if v ~= v or math.abs(v) == math.huge then return false end
    end
  end
  return true
end

local function static(needles, traction, size)
  local sim = talus.simulation {
    regions = { talus.region(plate(needles, size)) }, time = { mode = "static" },
    fix = { talus.fix { region = "plate", on = "left", x = true, y = size ~= nil }, talus.fix { region = "plate", on = talus.point(0, 0) } },
    loads = { talus.edge_load { region = "plate", on = "right", traction = traction } },
    probes = { far = {1.8, 1.8}, near = {0.2, 0.2} },
  }
  sim:run()
  return sim
end
local pulled = static(true, {1e6, 0})
talus.check.below("needles: thinnest block, area over length²", thinnest(pulled), 1e-3)
talus.check.near("needles, pulled: far raw stress, Pa", pulled.probes.far.raw_sxx, 1e6, { rel = 0.01 })
talus.check.near("needles, pulled: far displacement, m", pulled.probes.far.ux - pulled.probes.near.ux, 1.6*1e6/10e9, { rel = 0.01 })
talus.check.truth("needles, pulled: every number finite", finite(pulled))
local sheared, clean = static(true, {0, 1e5}, 0.06), static(false, {0, 1e5}, 0.06)
print("COST  needles, sheared  " .. #sheared.blocks .. " blocks, clean " .. #clean.blocks)
talus.check.near("needles, sheared: far displacement against the clean plate, m", sheared.probes.far.uy, clean.probes.far.uy, { rel = 0.01 })
talus.check.truth("needles, sheared: every number finite", finite(sheared))

local function standing(needles)
  local stack = {}
  for i = 1, 4 do stack[i] = talus.rect(0.9 - 0.1*i, 2 + 0.25*(i - 1) + 0.01*i, 1.3 - 0.1*i, 2.25 + 0.25*(i - 1) + 0.01*i) end
  local sim = talus.simulation {
    gravity = {0, -g}, contact = talus.joint { name = "floor", friction = 0.6 },
    regions = { talus.region { name = "floor", outline = talus.rect(-1, -1, 3, 0), material = rock, held = true },
                talus.region(plate(needles)), talus.region { name = "stack", blocks = stack, material = rock } },
    time = { mode = "dynamic", t_end = 0.3, dt = 1e-3 },
  }
  local seen = tools.watch(sim)
  tools.cost(needles and "needles" or "clean plate", seen, #sim.blocks)
  return seen, sim
end
local with, sim = standing(true)
local without = standing(false)
talus.check.near("needles, standing: time reached, s", sim.time, 0.3, { rel = 1e-9 })
talus.check.below("needles, standing: iterations over those of the clean plate", with.iterations/without.iterations, 3)
talus.check.truth("needles, standing: every number finite", finite(sim))
