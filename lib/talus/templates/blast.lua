-- A hole behind the face of a bench is fired: the gas presses, enters cracks and throws the burden.
-- Run: talus blast.lua                    results in out/blast: pictures, gas_pressure.svg, cracks.pvd for ParaView
--      talus blast.lua -p t_end=20        longer (4 s)
--      talus blast.lua --checkpoint every=60s --resume    to go on where it was stopped
--      talus check blast.lua              what it would take, without running it
local talus = require "talus"
local u = talus.units  -- SI everywhere: multiply by a unit, 5*u.MPa, 2*u.ms

-- Parameters can be given on the command line with -p name=value.
local t_end = talus.param("t_end", 3, "end of the run, ms")*u.ms
local size = talus.param("size", 0.2, "triangle edge at the hole, m")

local rock = talus.material { name = "rock", density = 2600, young = 30*u.GPa, poisson = 0.25 }
-- Bonds between the triangles fail where traction passes these strengths; gas goes into those that have failed.
local bond = talus.joint { name = "rock", friction = 40*u.deg, cohesion = 10*u.MPa, tension = 3*u.MPa }

local sim = talus.simulation {
  regions = {
    talus.region { name = "bench", outline = talus.rect(-3, -3, 3, 0), material = rock, joint = bond,
                   holes = { talus.circle { at = {0, -1}, radius = 0.1, sides = 12, name = "hole" } },
                   mesh = { size = talus.grade { { at = "hole", size = size }, far = 0.6 } } },  -- fine at the hole
  },
  boundaries = { talus.viscous { region = "bench", on = {"left", "right", "bottom"} } },  -- lets waves out
  -- Pressure over volume; gas_speed is that of the gas in cracks (m/s). Or by explosive: talus.charge { explosive = "ANFO", … }.
  charges = { talus.charge { hole = "hole", eos = talus.eos.polytropic { pressure = 60*u.MPa, gamma = 1.4 }, gas_speed = 250 } },
  probes  = { face = {0, -0.01} },
  time    = { t_end = t_end, dt_max = 5e-5 },
  output  = { dir = "out/blast", every = t_end/6, picture = "speed" },
  -- Called when a charge goes off and when its gas finds a way out.
  on_gas = function(sim, events)
    for _, event in ipairs(events) do sim:log("%s: %.3g m3, %.4g MPa", event.kind, event.volume, event.pressure/u.MPa) end
  end,
}
sim:run()

print(("%d bonds failed; the face moves at %.1f m/s"):format(sim.totals.failures, sim.probes.face.vy))
