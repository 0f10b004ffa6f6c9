-- Viscous boundaries: what comes back of waves that meet them straight, energy that they absorb, and a bench that stays where it
-- settled. A pulse (one sine of 16 blocks' length) runs along a strip held sideways; what comes back is the difference to a
-- strip that goes on. theta = 0.5, which damps nothing.
-- Source: Lysmer & Kuhlemeyer (1969): dashpots rho c_p, rho c_s absorb all of a wave at normal incidence. (3 s CPU)
local talus = require "talus"
local u = talus.units
local density, young, poisson, h = 2500, 10*u.GPa, 0.25, 0.1
local length = 16*h  -- of the pulse
local traction = 1*u.MPa

local function speeds(plane)
  local shear = young/2/(1 + poisson)
  local stiff = plane == "stress" and young/(1 - poisson^2)
    or young*(1 - poisson)/(1 + poisson)/(1 - 2*poisson)
  return { P = math.sqrt(stiff/density), S = math.sqrt(shear/density) }
end

-- Velocities at a block one and a half pulses from the loaded end, from the end of the pulse's passage on in the second list.
local function strip(wave, plane, lengths, viscous)
  local c, along_x = speeds(plane)[wave], wave == "P"
  local rock = talus.material { density = density, young = young, poisson = poisson, plane = plane }
  local blocks = lengths*16
  local function pulse(t) return t < length/c and traction*math.sin(2*math.pi*c*t/length)*math.sin(math.pi*c*t/length)^2 or 0 end
  local cuts = {}
  for i = 1, blocks - 1 do cuts[i] = talus.trace { points = { {i*h, 0}, {i*h, h} }, bonded = true } end
  local sim = talus.simulation {
    regions = { talus.region { name = "strip", outline = talus.rect(0, 0, blocks*h, h), material = rock, cuts = cuts } },
    fix = talus.fix { region = "strip", on = {"top", "bottom"}, x = not along_x, y = along_x },
    loads = talus.edge_load { region = "strip", on = "left", traction = along_x and { pulse, 0 } or { 0, pulse } },
    boundaries = viscous and talus.viscous { region = "strip", on = "right" } or nil,
    probes = { seen = {1.5*length, h/2} }, numerics = { theta = 0.5, recovery = false },
    time = { mode = "dynamic", t_end = 4.6*length/c, dt = h/c/8 },
  }
  local seen = {}
  for _ in sim:steps() do seen[#seen + 1] = along_x and sim.probes.seen.vx or sim.probes.seen.vy end
  return seen, sim
end

for _, case in ipairs { {"P", "stress"}, {"P", "strain"}, {"S", "strain"} } do
  local wave, plane = case[1], case[2]
  local open, sim = strip(wave, plane, 3, true)
  local on = strip(wave, plane, 5, false)
  local most, back = 0, 0
  for i = 1, #on do
    most, back = math.max(most, math.abs(on[i])), math.max(back, math.abs(open[i] - on[i]))
  end
  local name = ("%s wave, plane %s"):format(wave, plane)
  talus.check.below(name .. ": reflected amplitude", back/most, 0.01)
  talus.check.near(name .. ": absorbed, of the work put in", sim.energy.viscous/sim.energy.external, 1, { abs = 1e-3 })
  talus.check.below(name .. ": unexplained energy", math.abs(sim.energy.unexplained)/sim.energy.scale, 1e-3)
end

-- A bench on viscous sides begins from equilibrium, where they are held, and stays there.
local rock = talus.material { density = density, young = young, poisson = poisson, plane = "strain" }
local function bench(more)
  local fields = {
    gravity = {0, -9.81}, regions = { talus.region { name = "bench", material = rock, mesh = { size = 1.5 },
      outline = talus.polygon { {0, 0}, {12, 0}, {12, 4}, {6, 4}, {6, 8}, {0, 8} } } },
    boundaries = { talus.viscous { region = "bench", on = {"left", "right", "bottom"} } },
    probes = { crest = {6, 8}, toe = {6, 4}, far = {12, 4} },
    time = { mode = "dynamic", t_end = 10, dt = 0.01, start = "settled" }, numerics = { recovery = false },
  }
  for key, value in pairs(more or {}) do fields[key] = value end
  return talus.simulation(fields)
end

local still, from = bench()
local function places(sim)
  local list = {}
  for _, name in ipairs { "crest", "toe", "far" } do
    list[#list + 1], list[#list + 2] = sim.probes[name].ux, sim.probes[name].uy
  end
  return list
end
local drift = 0
for _ in still:steps() do
  local now = places(still)
  from = from or now
  for i = 1, #now do drift = math.max(drift, math.abs(now[i] - from[i])) end
end
talus.check.above("bench: it has settled by, m", -still.probes.crest.uy, 1e-6)
talus.check.below("bench: drift in 10 s over its height", drift/8, 1e-9)

-- A blow on its crest, with the weight carried by the boundaries: where the energy goes, at the default theta too.
for _, theta in ipairs { 0.5, 0.75 } do
  local sim = bench { numerics = { theta = theta, recovery = false }, time = { mode = "dynamic", t_end = 0.05, dt = 1e-4, start = "settled" },
    loads = talus.edge_load { region = "bench", on = talus.line(0, 8, 6, 8),
                              traction = { 0, function(t) return t < 2e-3 and -1e6*math.sin(math.pi*t/2e-3)^2 or 0 end } } }
  sim:run()
  local name = ("bench, struck, theta %g: "):format(theta)
  talus.check.near(name .. "absorbed and lost to the integrator, of the work of the blow",
    (sim.energy.viscous + sim.energy.numerical)/sim.energy.external, 1, { abs = 1e-3 })
  talus.check.below(name .. "unexplained energy", math.abs(sim.energy.unexplained)/sim.energy.scale, 1e-3)
end
