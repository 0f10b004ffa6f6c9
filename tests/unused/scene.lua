-- The scenes of tests/unused/run: each has some parts of the engine and is counted for what it spends in the others.
local talus = require "talus"
local kind = talus.param("kind", "elastic", "elastic, waves, rigid, flight, deformable, crack, law or blast")
local rock = talus.material { density = 2500, young = 10e9, poisson = 0.25 }
local scenes = {}

function scenes.elastic()  -- static, bonded
  return { regions = { talus.region { name = "beam", outline = talus.rect(0, 0, 4, 1), material = rock, mesh = { size = 0.25 } } },
           fix = { talus.fix { region = "beam", on = "left" } },
           loads = { talus.edge_load { region = "beam", on = "right", traction = {0, -1e3} } }, time = { mode = "static" } }
end
function scenes.waves()
  local scene = scenes.elastic()
  scene.time = { mode = "dynamic", t_end = 1e-3, dt = 5e-5 }
  return scene
end
local function wall(order)
  return { gravity = {0, -10}, time = { mode = "dynamic", t_end = 0.02, dt = 2e-3 },
           regions = { talus.region { name = "ground", outline = talus.rect(-1, -1, 11, 0), material = rock, held = true },
                       talus.region { name = "wall", blocks = talus.running_bond { at = {0, 0}, courses = 8, per_course = 8, length = 1,
                                      height = 0.5 }, material = rock, order = order } } }
end
function scenes.rigid() return wall("rigid") end
function scenes.deformable() return wall(1) end
function scenes.flight()
  local blocks = {}
  for i = 0, 9 do for j = 0, 9 do blocks[#blocks + 1] = talus.rect(3*i, 3*j, 3*i + 1, 3*j + 1) end end
  return { gravity = {0, -10}, regions = { talus.region { name = "blocks", blocks = blocks, material = rock } },
           time = { mode = "dynamic", t_end = 0.1, dt = 5e-3 } }
end
local function breakable(scene, tension)
  scene.regions[1].joint = talus.joint { friction = 0.6, cohesion = 3*tension, tension = tension }
  return scene
end
function scenes.crack() return breakable(scenes.waves(), 2e4) end
-- The same with the built-in laws written in Lua.
function scenes.law()
  local scene = scenes.crack()
  local tan = math.tan
  scene.regions[1].joint = talus.joint { friction = 0.6, cohesion = 6e4, tension = 2e4,
    criterion = function(t)
      local normal, shear = t.normal, t.shear
      local pulled = normal > 0 and normal/t.tension or 0
      local sheared = ((shear < 0 and -shear or shear) + normal*tan(t.friction))/t.cohesion
      return sheared > pulled and sheared or pulled
    end,
    reduction = function(intact) return { friction = intact.friction, cohesion = intact.cohesion < 5e4 and intact.cohesion or 5e4 } end }
  return scene
end
function scenes.blast()
  return { regions = { talus.region { name = "rock", outline = talus.rect(-2, -2, 2, 2), material = rock, mesh = { size = 0.4 },
                                      holes = { talus.circle { at = {0, 0}, radius = 0.2, sides = 12, name = "hole" } },
                                      joint = talus.joint { friction = 0.6, cohesion = 5e6, tension = 1e6 } } },
           charges = { talus.charge { hole = "hole", eos = talus.eos.polytropic { pressure = 50e6 } } },
           time = { mode = "dynamic", t_end = 2e-4, dt = 2e-5 } }
end
talus.simulation(scenes[kind]()):run()
