-- Own case 54: a block drawn over steps between the blocks of a floor. Off a step down the corner that leaves goes along the side of the lower block, whose end it is above: that side held it as a wall
-- where it came past by less than 1e-4 of its size in a step, with 1e4 times the friction; so it did meshed bodies, whose corner belongs to two blocks, at any speed, with up to 84 times. Down it must pass under μN alone, drawn slowly or fast, loaded or not, in motion and in load steps.
-- Up, a step higher than what blocks give way to under the stress across it must stop the block: pushed by 0.6 of its weight it stays, by a face that it is not in.
-- Bounds: force of the drive after its start 1.06 μN, under a load 1.3 (the floor shears under the block and lets go); the way to the step and the height of the block to 1e-4 m.
local talus = require "talus"
local check = talus.check
local g, density, mu = 9.81, 2500, 0.3

local function scene(case, fix, loads, time)
  local rock = talus.material { name = "rock", density = density, young = case.young, poisson = 0.2 }
  local sled = talus.rect(-1.3, 0, -0.3, case.high)
  local mesh = case.mesh and (case.mesh == "triangles" and { kind = "triangles", size = 0.5 } or { kind = case.mesh, nx = 2, ny = 2 })
  local regions, fixes = {}, {}
  if mesh then
    for k = -3, 2 do
      regions[#regions + 1] = talus.region { name = "floor" .. k, outline = talus.rect(k, -1, k + 1, k < 0 and 0 or case.step), material = rock, mesh = mesh }
      fixes[#fixes + 1] = talus.fix { region = "floor" .. k, on = "bottom" }
    end
  else
    local blocks = {}
    for k = -3, 2 do blocks[#blocks + 1] = talus.rect(k, -1, k + 1, k < 0 and 0 or case.step) end
    regions[1] = talus.region { name = "floor", blocks = blocks, material = rock, stress = case.sxx and { sxx = case.sxx } }
    fixes[1] = talus.fix { region = "floor", on = "bottom" }
    if case.sxx then fixes[2] = talus.fix { region = "floor", on = {"left", "right"}, x = true } end
  end
  regions[#regions + 1] = talus.region { name = "sled", outline = sled, material = rock, mesh = mesh }
  fixes[#fixes + 1] = fix
  if case.pressure then loads[#loads + 1] = talus.edge_load { region = "sled", on = "top", traction = {0, -case.pressure} } end
  return talus.simulation { gravity = {0, -g}, contact = talus.joint { name = "seat", friction = math.atan(mu) }, regions = regions, fix = fixes, loads = loads, time = time }
end

for _, case in ipairs { { young = 5e10, step = -8e-3, speed = 0.05, high = 1 }, { young = 5e10, step = -2e-3, speed = 0.02, high = 1 }, { young = 2e10, step = -8e-3, speed = 0.3, high = 1, pressure = 5e6 },
                        { young = 1e9, step = -8e-3, speed = 0.5, high = 1, pressure = 1e6 },
                        { young = 1e10, step = -2e-3, speed = 0.5, high = 1, pressure = 1e6, mesh = "cross" }, { young = 1e10, step = -2e-3, speed = 0.5, high = 1, pressure = 1e6, mesh = "triangles" } } do
  local sim = scene(case, talus.fix { name = "jack", region = "sled", on = "left", x = true, velocity = { function(t) return case.speed*math.min(1, t/0.1) end, 0 } }, {},
    { mode = "dynamic", t_end = 0.4/case.speed + 0.1, dt = 1e-3, start = "settled" })
  local most = 0
  for _ in sim:steps() do if sim.time > 0.2 then most = math.max(most, math.abs(sim.reactions.jack[1])) end end
  local label = string.format("drawn at %g m/s off a step of %g mm, %g GPa%s: ", case.speed, -1e3*case.step, case.young/1e9, (case.pressure and string.format(", under %g MPa", case.pressure/1e6) or "") .. (case.mesh and ", mesh of " .. case.mesh or ""))
  local friction = mu*(density*g + (case.pressure or 0))
  check.below(label .. "force of the drive, of the friction", most/friction, case.pressure and 1.3 or 1.06)
  check.below(label .. "unexplained", math.abs(sim.energy.unexplained)/sim.energy.scale, 1e-3)
  check.equal(label .. "cuts", sim.totals.cuts, 0)
end

for _, case in ipairs { { young = 5e10, step = 2e-4, high = 0.5 }, { young = 5e10, step = 5e-3, high = 0.5 }, { young = 1e10, step = 2.5e-3, high = 0.5, sxx = -10e6 } } do
  local sim = scene(case, nil, { talus.edge_load { region = "sled", on = "left", traction = { function(t) return 0.6*density*g*math.min(1, t/0.2) end, 0 } } },
    { mode = "dynamic", t_end = 1.5, dt = 1e-3, start = "settled" })
  sim:run()
  local sled = sim.blocks[#sim.blocks]
  local label = string.format("pushed against a step of %g mm, %g GPa%s: ", 1e3*case.step, case.young/1e9, case.sxx and ", under 10 MPa along it" or "")
  check.near(label .. "way to it, m", sled.ux, 0.3, { abs = 1e-4 })
  check.below(label .. "lifted, m", math.abs(sled.uy), 1e-4)
  check.below(label .. "unexplained", math.abs(sim.energy.unexplained)/sim.energy.scale, 1e-3)
end

for _, case in ipairs { { young = 5e10, step = -8e-3, high = 1 }, { young = 5e9, step = -8e-3, high = 1, pressure = 1e6 } } do
  local sim = scene(case, talus.fix { name = "jack", region = "sled", on = "left", x = true, displacement = { {{0, 0}, {0.05, 0}, {1, 0.5}}, 0 } }, {},
    { mode = "static", t_end = 1, steps = 100 })
  local most = 0
  for _ in sim:steps() do most = math.max(most, math.abs(sim.reactions.jack[1])) end
  local label = string.format("drawn off a step of 8 mm, %g GPa%s, static: ", case.young/1e9, case.pressure and ", under 1 MPa" or "")
  check.below(label .. "force of the drive, of the friction", most/(mu*(density*g + (case.pressure or 0))), 1.01)
  check.below(label .. "unexplained", math.abs(sim.energy.unexplained)/sim.energy.scale, 0.01)
end
