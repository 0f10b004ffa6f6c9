-- Bonds fail where theory says, share what they release, and leave what a body with those cracks would have.
-- Source: maximum tension and Mohr–Coulomb (Ning et al. 2011, eqs. 1 and 2); the increments of a static load stop within
-- fracture.overshoot (here 0.001) of the first strength.
local talus = require "talus"
local u = talus.units
local rock = talus.material { name = "rock", density = 2500, young = 10*u.GPa, poisson = 0.2 }
local tension, cohesion, friction = 0.5*u.MPa, 4*u.MPa, 35*u.deg
local function joint(more)
  local fields = { name = "bond", friction = friction, cohesion = cohesion, tension = tension }
  for key, value in pairs(more or {}) do fields[key] = value end
  return talus.joint(fields)
end
local precise = { overshoot = 1e-3 }

local function first_failure(fields)
  local first
  fields.fracture, fields.on_fracture = fields.fracture or precise, function(sim, cracks)
    first = first or { cracks = cracks, time = sim.time, failed = #cracks }
    sim:stop()
  end
  local sim = talus.simulation(fields)
  sim:run()
  return first, sim
end

-- Direct tension: a bar of 4 x 1 m, pulled at its right end up to twice the strength. Poisson's contraction is free.
local function bar(more, mesh)
  return talus.region { name = "bar", outline = talus.rect(0, 0, 4, 1), material = rock, joint = joint(more),
                        mesh = mesh or { kind = "cross", nx = 8, ny = 2 } }
end
local held = { talus.fix { region = "bar", on = "left", x = true }, talus.fix { region = "bar", on = talus.point(0, 0), y = true } }
local function pulled(stress, more, mesh)
  return { regions = { bar(more, mesh) }, fix = held, time = { mode = "static" },
           loads = { talus.edge_load { region = "bar", on = "right", traction = { {{0, 0}, {1, stress}}, 0 } } } }
end
local pull = first_failure(pulled(2*tension))
talus.check.near("bar in tension: stress at failure, Pa", pull.time*2*tension, tension, { rel = 1e-3 })
talus.check.equal("bar in tension: mode", pull.cracks[1].mode, "tension")

-- Direct shear: two rigid blocks bonded along y = 0, pressed by σ and pushed along the bond. The resultant of the push goes
-- through the bond, so that its mean traction is pure shear and pressure.
for _, pressure in ipairs { 0, 1*u.MPa, 5*u.MPa } do
  local top = 20*u.MPa  -- of which the held half takes half
  local shear = first_failure {
    regions = { talus.region { name = "pair", outline = talus.rect(0, -1, 1, 1), material = rock, order = "rigid",
                               joint = joint(), cuts = { talus.trace { points = { {0, 0}, {1, 0} }, bonded = true } } } },
    fix = { talus.fix { region = "pair", on = "bottom" } },
    loads = { talus.pressure { region = "pair", on = "top", value = pressure },
              talus.point_load { region = "pair", at = {0.5, 0}, force = { {{0, 0}, {1, top}}, 0 } } },
    time = { mode = "static" },
  }
  local label = string.format("bond in shear under %g MPa: ", pressure/u.MPa)
  talus.check.near(label .. "traction at failure, Pa", shear and math.abs(shear.cracks[1].shear), cohesion + pressure*math.tan(friction),
                   { rel = 1e-3 })
  talus.check.equal(label .. "mode", shear and shear.cracks[1].mode, "shear")
end

-- What is left after a failure does not remember how it came about: a plate with a weak line inside, pulled until the line fails,
-- against the same plate whose line failed at a hundredth of that load.
local function plate(strength)
  local line = talus.trace { points = { {0.3, 0.5}, {0.7, 0.5} }, bonded = true,
                             joint = talus.joint { name = "line", friction = 0.5, tension = strength, cohesion = 10*strength } }
  local sim = talus.simulation {
    regions = { talus.region { name = "plate", outline = talus.rect(0, 0, 1, 1), material = rock, mesh = { size = 0.1 }, cuts = { line },
                               joint = talus.joint { name = "tough", friction = 0.5 } } },
    fix = { talus.fix { region = "plate", on = "bottom" } },
    loads = { talus.edge_load { region = "plate", on = "top", traction = {0, {{0, 0}, {1, 0.3*u.MPa}}} } },
    time = { mode = "static", steps = 2 },
  }
  sim:run()
  return sim
end
local late, early = plate(0.1*u.MPa), plate(0.001*u.MPa)
local difference = 0
for _, name in ipairs { "sxx", "syy", "sxy" } do
  local ours, theirs = late.blocks:field(name), early.blocks:field(name)
  for b = 1, #ours do difference = math.max(difference, math.abs(ours[b] - theirs[b])/(0.3*u.MPa)) end
end
talus.check.equal("weak line in tension: joints that failed", #late.cracks[1].joints, 4)
talus.check.below("stresses where it failed late against early, part of the load", difference, 1e-8)

-- The stress in front of a tip goes as K/sqrt(distance), so the mean traction of the first edge as K/sqrt(h): the K at which it fails
-- is in proportion to sqrt(h). Three meshes, each twice as fine, along the path.
local function load_of_crack(size, no_path)
  local cuts = { talus.trace { points = { {0, 0.5}, {0.3, 0.5} }, joint = talus.joint { name = "crack", friction = 0 } },
                 not no_path and talus.trace { points = { {0.3, 0.5}, {1, 0.5} }, bonded = true, joint = joint() } or nil }
  local crack = first_failure {
    regions = { talus.region { name = "plate", outline = talus.rect(0, 0, 1, 1), material = rock, mesh = { size = size }, cuts = cuts,
                               joint = joint() } },
    fix = { talus.fix { region = "plate", on = "bottom", y = true }, talus.fix { region = "plate", on = talus.point(0, 0), x = true } },
    loads = { talus.edge_load { region = "plate", on = "top", traction = {0, {{0, 0}, {1, 1*u.MPa}} } } }, time = { mode = "static" },
  }
  return crack.time*u.MPa
end
local reference
for _, size in ipairs { 0.1, 0.05, 0.025 } do
  local scaled = load_of_crack(size)/(tension*math.sqrt(size))
  reference = reference or scaled
  talus.check.near(string.format("edge crack, size %g: load at failure / (strength sqrt(h)), of that at 0.1", size), scaled/reference, 1,
                   { rel = 0.05 })
end
-- On meshes without a path the first edge is up to 30 degrees off the crack's way and its length is the mesh's choice.
local scattered, mean, variance = {}, 0, 0
for k = 1, 12 do
  local size = 0.038 + 0.002*k
  scattered[k] = load_of_crack(size, true)/(tension*math.sqrt(size))
  mean = mean + scattered[k]/12
end
for _, scaled in ipairs(scattered) do variance = variance + (scaled/mean - 1)^2/12 end
talus.check.below("edge crack on 12 unstructured meshes: standard deviation of the same, of its mean", math.sqrt(variance), 0.12)

-- A square, pressed over the middle of top and bottom, is the same in both mirrors, and so are its cracks, whichever corner its
-- outline begins at and whichever way it turns.
local corners = { {-1, -1}, {1, -1}, {1, 1}, {-1, 1} }
local function square(first, way, path)
  local points = {}
  for k = 0, 3 do points[#points + 1] = corners[(first + way*k) % 4 + 1] end
  local sim = talus.simulation {
    regions = { talus.region { name = "square", outline = talus.polygon(points), material = rock, mesh = { kind = "cross", nx = 8, ny = 8 },
                               joint = joint() } },
    fix = { talus.fix { region = "square", on = talus.line(-0.25, -1, 0.25, -1), y = true },
            talus.fix { region = "square", on = talus.point(0, -1), x = true } },
    loads = { talus.pressure { region = "square", on = talus.line(-0.25, 1, 0.25, 1), value = {{0, 0}, {1, 12*u.MPa}} } },
    time = { mode = "static", steps = 4 }, stop = function(sim) return sim.cracks.tension + sim.cracks.shear > 1 end,
    fracture = { path = path },
  }
  sim:run()
  local at, list = {}, {}
  for _, crack in ipairs(sim.cracks) do
    for _, j in ipairs(crack.joints) do
      local mid = sim.joints[j].mid
      local key = string.format("%.2f %.2f", mid[1], mid[2])
      at[key], list[#list + 1] = true, key
    end
  end
  table.sort(list)
  local alone = 0
  for key in pairs(at) do
    local x, y = key:match("(%S+) (%S+)")
    local mirror = string.format("%.2f %.2f", -tonumber(x) + 0, tonumber(y))
    if not at[mirror] and not at["-" .. mirror] then alone = alone + 1 end
  end
  return table.concat(list, ", "), alone, #list
end
for _, path in ipairs { "mesh", "tracked" } do
  local expected
  for first = 0, 3 do
    for _, way in ipairs { 1, -1 } do
      local list, alone, count = square(first, way, path)
      expected = expected or list
      local label = string.format("symmetric square, outline from corner %d, %s, path = \"%s\": ", first + 1,
                                  way > 0 and "counter-clockwise" or "clockwise", path)
      talus.check.above(label .. "failed joints", count, 3)
      talus.check.equal(label .. "failed joints without a mirror image", alone, 0)
      talus.check.truth(label .. "the same as from the first", list == expected)
    end
  end
end
