-- Five short scenes that break, four of them under gas: each saved in its middle, in a file, and gone on from there in a fresh
-- simulation, must end in the same state to the last bit as in one go. No source: the answer is the run itself. One of them alone
-- (-p only=…) is what tests/killed/run kills and restarts.
local talus = require "talus"
local u = talus.units
local disc = require "parts.flattened_disc"
local only = talus.param("only", "", "the name of one scene, to be run as any other")
local file = talus.param("file", "build/restart_blast.state", "where states are saved")
local rock = talus.material { name = "rock", density = 2600, young = 55*u.GPa, poisson = 0.3 }
local scenes = {}

-- A disc between plates; what is left of a bond falls with slip and opening by a law in Lua.
function scenes.softening_disc()
  local function worn(intact, slip, opening)
    local left = math.exp(-(slip + opening)/(2*u.mm))
    return { tension = 0, cohesion = 0.05*u.MPa + left*intact.cohesion/10, friction = intact.friction }
  end
  local joint = disc.joint { reduction = worn, scatter = talus.laws.weibull { modulus = 8, seed = 3 } }
  local h, b, size = disc.half_height, disc.half_flat, 5*u.mm
  return {
    regions = { talus.region { name = "disc", outline = disc.outline(size), material = disc.rock, mesh = { size = size }, joint = joint },
                talus.region { name = "upper", outline = talus.rect(-2*b, h, 2*b, h + 2*b), material = disc.rock, order = "rigid" },
                talus.region { name = "lower", outline = talus.rect(-2*b, -h - 2*b, 2*b, -h), material = disc.rock, held = true } },
    contact = talus.joint { name = "smooth", friction = 0 },
    fix = { talus.fix { region = "upper", on = "top", displacement = {0, { {0, 0}, {1, -0.1*u.mm} }} } },
    time = { mode = "static", steps = 10, max_steps = 20 },
  }
end

local function plate(fields)
  fields.name, fields.material = "plate", rock
  return talus.region(fields)
end

-- Cracks run out from a hole.
function scenes.borehole()
  local joint = talus.joint { name = "bonds", friction = 45*u.deg, cohesion = 20*u.MPa, tension = 5*u.MPa }
  return {
    regions = { plate { outline = talus.rect(-1, -1, 1, 1), joint = joint,
                        holes = { talus.circle { at = {0, 0}, radius = 0.1, sides = 16, name = "hole" } },
                        mesh = { size = talus.grade { { at = "hole", size = 0.06 }, far = 0.3 } } } },
    boundaries = { talus.viscous { region = "plate", on = {"left", "right", "bottom", "top"} } },
    charges = { talus.charge { hole = "hole", eos = talus.eos.polytropic { pressure = 60*u.MPa, gamma = 1.4 }, gas_speed = 200 } },
    time = { t_end = 5e-4, displacement_ratio = 0.002 },
  }
end

-- Equation of state, speed and venting by laws of the script; the gas reaches the edge.
function scenes.own_gas()
  local function speed(_, chamber) return 800*math.sqrt(chamber.pressure/(100*u.MPa)*chamber.volume/chamber.first_volume) end
  return {
    regions = { plate { outline = talus.rect(-1, -1, 1, 1), mesh = { size = 0.3 },
      joint = talus.joint { name = "bonds", friction = 40*u.deg, cohesion = 4*u.MPa, tension = 1*u.MPa },
      holes = { talus.circle { at = {0, 0}, radius = 0.05, sides = 16, name = "hole" } },
      cuts = { talus.trace { points = { {-2, 0}, {2, 0} } }, talus.trace { points = { {0, -2}, {0, 2} } } } } },
    charges = { talus.charge { hole = "hole", gas_speed = speed,
      eos = function(v, t) return 100*u.MPa*(0.7/(v - 0.3))^1.3*math.exp(-100*t) end,
      venting = function(t, chamber) return math.exp(-t/(chamber.volume/chamber.first_volume*u.ms)) end } },
    time = { t_end = 1.2e-3, dt = 2e-5 },
  }
end

-- Two holes with delays and strengths that scatter, grain, an orifice.
function scenes.delays()
  local holes, charges = {}, {}
  for i = 1, 2 do
    holes[i] = talus.circle { at = {2*i - 3, -1}, radius = 0.12, sides = 10, name = "hole " .. i }
    charges[i] = talus.charge { hole = "hole " .. i, eos = talus.eos.polytropic { pressure = 40*u.MPa, gamma = 1.3 }, gas_speed = 250,
                                delay = (i - 1)*0.4*u.ms, delay_scatter = 0.05*u.ms, seed = 5, venting = talus.venting.orifice { density = 850 } }
  end
  local joint = talus.joint { name = "bonds", friction = 40*u.deg, cohesion = 8*u.MPa, tension = 2*u.MPa, scatter = talus.laws.weibull { modulus = 5, seed = 2 } }
  return {
    gravity = {0, -9.81},
    regions = { plate { outline = talus.rect(-2.5, -2.5, 2.5, 0), joint = joint, holes = holes,
                        mesh = { kind = "voronoi", size = 0.5, seed = 4 } } },
    boundaries = { talus.viscous { region = "plate", on = {"left", "right", "bottom"} } },
    charges = charges,
    time = { t_end = 1.2e-3, dt_max = 2e-5 },
  }
end

-- A block of second order falls and breaks; loads that the script changes, by numbers it draws.
function scenes.fall()
  return {
    gravity = {0, -9.81}, contact = talus.joint { name = "floor", friction = 30*u.deg },
    regions = { talus.region { name = "floor", outline = talus.rect(-2, -1, 3, 0), material = rock, held = true },
                plate { outline = talus.rect(0, 0.001, 1, 1.001), velocity = {0, -8}, order = 2, mesh = { kind = "cross", nx = 3, ny = 3 },
                        joint = talus.joint { name = "bonds", friction = 35*u.deg, cohesion = 4*u.MPa, tension = 0.5*u.MPa } } },
    loads = { talus.point_load { name = "push", region = "plate", at = {0, 0.5}, force = {0, 0} } },
    time = { t_end = 6e-4, dt = 1e-5 },
  }
end

local names = { "softening_disc", "borehole", "own_gas", "delays", "fall" }

-- What the script notes down and changes on the way: part of the state like the rest.
local function make(name, drawn)
  local fields = scenes[name]()
  fields.title = name
  fields.output = drawn and { dir = "out/" .. name, every = 1e-4, picture = false }
  fields.on_step = function(sim)
    sim.state.steps = (sim.state.steps or 0) + 1
    if name == "fall" then sim:load("push").force = { 1e4*(drawn and math.random() or sim.state.steps % 7), 0 } end
  end
  return talus.simulation(fields)
end

if only ~= "" then
  math.randomseed(11)
  local sim = make(only, true)
  sim:run()
  print(("ends in %s after %d steps and %d failures"):format(sim:hash(), sim.state.steps, sim.totals.failures))
  return
end

for _, name in ipairs(names) do
  local whole = make(name)
  whole:run()
  local saved = make(name)
  for _ = 1, math.max(1, whole.totals.steps//3) do saved:step() end
  saved:save(file)
  local again = make(name)
  again:restore(file)
  local at = again.totals.steps
  again:run()
  talus.check.above(name .. ": bonds that failed after the saved state", whole.totals.failures - saved.totals.failures, 0)
  if #whole.charges > 0 then talus.check.above(name .. ": the gas has worked, J/m", saved.charges[1].work, 0) end
  talus.check.equal(("%s: hash at the end of %d steps, restarted at %d"):format(name, whole.totals.steps, at), again:hash(), whole:hash())
  talus.check.equal(name .. ": steps that the script counted", again.state.steps, whole.state.steps)
end
