-- 47. Blocks of 1 m whose joints give as fresh ones do (k_n = 10 GPa/m), squeezed by up to 20 MPa: pressed in by 1e-3 √area and more, corner on corner and face to face, square and leaning. They bear
-- what they should: what a contact is pressed in by is no reason to take it for another.
-- Source: sum of compliances, u = p ((n − ½)/E + n/k_n) of the top blocks' middles, F = 2 w/(2 H/E + 1/k_n + 2/k_p) under a plate that comes down by w. Ours: from 1e-3 √area on contacts at
-- the ends of faces came twice or not at all: 47 % of the energy gone, 2.5 times the way, nothing borne. (0.3 s CPU)
local talus = require "talus"
local E, kn, kp = 30e9, 10e9, 3000e9
local rock = talus.material { name = "rock", density = 2500, young = E, poisson = 0 }
local joint = talus.joint { friction = math.rad(35), stiffness = { per = "area", value = kn } }
for _, n in ipairs { 2, 4 } do
  for _, side in ipairs { 0, 0.5 } do
    for _, p in ipairs { 9e6, 11e6, 20e6 } do
      local function push(on, x, y) return talus.edge_load { region = "block", on = on, traction = {x, y} } end
      local sim = talus.simulation {
        contact = joint,
        regions = { talus.region { name = "floor", outline = talus.rect(-2, -1, n + 2, 0), material = rock, held = true },
                    talus.region { name = "block", outline = talus.rect(0, 0, n, n), material = rock,
                                   cuts = { talus.joint_set { dip = 0, spacing = 1, through = {0, 0} }, talus.joint_set { dip = math.rad(90), spacing = 1, through = {0, 0} } } } },
        loads = { push("top", 0, -p), push("left", p*side, 0), push("right", -p*side, 0) },
        time = { mode = "static", steps = 1 },
      }
      sim:run()
      local top = 0
      for _, b in ipairs(sim.blocks) do top = math.max(top, -b.uy) end
      local label = string.format("%d x %d blocks under %g MPa, %g of it from the sides: ", n, n, p/1e6, side)
      talus.check.near(label .. "the top sinks, m", top, p*((n - 0.5)/E + n/kn), { rel = side > 0 and 5e-3 or 1e-6 })
      talus.check.below(label .. "unexplained, of scale", math.abs(sim.energy.unexplained)/sim.energy.scale, 1e-5)
    end
  end
end
local plate = talus.joint { friction = 0, stiffness = { per = "area", value = kp } }
for _, turn in ipairs { 0, 30 } do
  local c, s = math.cos(math.rad(turn)), math.sin(math.rad(turn))
  local function rect(x1, y1, x2, y2)
    local corners = {}
    for k, q in ipairs { {x1, y1}, {x2, y1}, {x2, y2}, {x1, y2} } do corners[k] = { c*q[1] - s*q[2], s*q[1] + c*q[2] } end
    return corners
  end
  for _, p in ipairs { 13e6, 20e6, 40e6 } do
    local way, T = p*(2/E + 1/kn + 2/kp), 1
    for _, time in ipairs { { mode = "static", steps = 10, t_end = T }, { t_end = T, dt = 2e-3 } } do
      local sim = talus.simulation {
        contact = plate, contacts = { talus.contact { between = {"block", "block"}, joint = joint } },
        regions = { talus.region { name = "floor", outline = rect(-3, -1, 3, 0), material = rock, held = true },
                    talus.region { name = "plate", outline = rect(-3, 2, 3, 3), material = rock, held = true },
                    talus.region { name = "block", blocks = { rect(-1, 0, 1, 1), rect(-1, 1, 1, 2) }, material = rock } },
        fix = { talus.fix { region = "plate", displacement = { {{0, 0}, {0.9*T, way*s}, {T, way*s}}, {{0, 0}, {0.9*T, -way*c}, {T, -way*c}} } }, talus.fix { name = "base", region = "floor" } },
        time = time,
      }
      sim:run()
      local f = sim.reactions.base
      talus.check.near(string.format("two blocks under a plate, turned by %g°, %g MPa, %s: pressure, of that", turn, p/1e6, time.mode or "in motion"), (f[2]*c - f[1]*s)/(2*p), 1, { abs = 2e-3 })
    end
  end
end
local lean = math.tan(math.rad(5))
local upper = talus.simulation {
  contact = joint,
  regions = { talus.region { name = "floor", outline = talus.rect(-3, -1, 3, 0), material = rock, held = true },
              talus.region { name = "block", blocks = { {{-0.5, 0}, {0.5, 0}, {0.5 + lean, 1}, {-0.5 - lean, 1}}, talus.rect(-0.4995 - lean, 1, 0.4995 + lean, 2) }, material = rock } },
  loads = { talus.edge_load { region = "block", on = "top", traction = {0, -20e6} } },
  time = { t_end = 1, dt = 2e-3 },
}
upper:run()
talus.check.between("block near the ends of a face that leans in under it: sinks, m", -upper.blocks[3].uy, 4e-3, 7e-3)
