-- Explosion gas by laws of the script: an equation of state with covolume that loses heat, and a speed in cracks that goes
-- with its own speed of sound, beside the polytrope at a constant speed.
-- Run: scripts/run examples/13_custom_gas.lua                 (2 s CPU; pictures in out/custom_gas)
--      scripts/run examples/13_custom_gas.lua -p cooling=0   no loss of heat
-- Teaches: eos = function(v, t, chamber), gas_speed = function(t, chamber), venting = function(t, chamber), sim:plot.
-- Picture: docs/pictures/13_custom_gas.svg (pressure over time)
-- Source: Noble and Abel's gas, P (v - b)^γ = const, b the part of the first volume that the molecules take (Johnston 2005, DSTO-TN-0670,
-- for propellants); that P falls by e^(-t/τ) as the walls cool it, and that the front goes at c √(P V/(P0 V0)),
-- are there to show how it is said.
local talus = require "talus"
local u = talus.units

local cooling = talus.param("cooling", 0.1, "1/τ, per ms")/u.ms
local P0, gamma, covolume, speed = 100*u.MPa, 1.3, 0.3, 500
local rock = talus.material { name = "rock", density = 2600, young = 55*u.GPa, poisson = 0.3 }

local function noble_abel(v, t)
  return P0*((1 - covolume)/(v - covolume))^gamma*math.exp(-cooling*t)
end

-- A plate that two joints through the hole part in four; the gas opens them and leaves at the edges.
local function blow(name, charge)
  charge.hole = "hole"
  local vented
  local sim = talus.simulation {
    title = name,
    regions = { talus.region { name = "plate", outline = talus.rect(-1, -1, 1, 1), material = rock, mesh = { size = 0.3 },
      holes = { talus.circle { at = {0, 0}, radius = 0.05, sides = 16, name = "hole" } },
      cuts = { talus.trace { points = { {-2, 0}, {2, 0} } }, talus.trace { points = { {0, -2}, {0, 2} } } } } },
    charges = { talus.charge(charge) },
    time = { t_end = 5e-3, dt = 2e-5 },
    output = { dir = "out/custom_gas/" .. name:gsub("%W", "_"), every = 1e-3, picture = "speed" },
    on_gas = function(_, events)
      for _, event in ipairs(events) do if event.kind == "venting" then vented = event end end
    end,
  }
  local curve = { name = name, x = {}, y = {} }
  for _ in sim:steps() do
    local c = sim.charges[1]
    curve.x[#curve.x + 1], curve.y[#curve.y + 1] = sim.time, c.pressure
  end
  print(string.format("%-12s reaches the edge at %.2f ms with %.2f MPa and gives %.1f kJ/m", name, vented.time/u.ms, vented.pressure/u.MPa,
    sim.charges[1].work/1e3))
  return curve, sim, vented
end

local eos_polytrope = talus.eos.polytropic { pressure = P0, gamma = gamma }
local plain, _, plain_vented = blow("polytrope", { eos = eos_polytrope, gas_speed = speed })
local own, sim, own_vented = blow("own laws", { eos = noble_abel,
  gas_speed = function(_, chamber) return speed*math.sqrt(chamber.pressure/P0*chamber.volume/chamber.first_volume) end,
  venting = function(t, chamber) return math.exp(-t/(chamber.volume/chamber.first_volume*u.ms)) end })
sim:plot("pressure", { title = "Pressure in the hole", x_label = "t", x_unit = "s", y_label = "P", y_unit = "Pa",
                       log_y = true, plain, own })

local first = sim.charges[1].first_volume
talus.check.near("own law: pressure at the edge", own_vented.pressure, noble_abel(own_vented.volume/first, own_vented.time),
  { rel = 1e-10 })
talus.check.between("constant speed: time to the edge, which moves out meanwhile, s", plain_vented.time, 1/speed, 1.05/speed)
talus.check.above("the gas at a part of its speed of sound is later at the edge, by ms", (own_vented.time - plain_vented.time)/u.ms, 0.1)
talus.check.near("gas's work on the rock against its law's", sim.energy.gas, sim.charges[1].work, { rel = 2e-3 })
talus.check.near("ledger", sim.energy.unexplained, 0, { abs = 0.01*sim.energy.gas })
