-- The cast blast of the paper's section 4: a hole under 1 GPa of gas, its chamber, the cracks, the throw and the pile in one run.
-- Run: scripts/run examples/11_cast_blast.lua                        (about a quarter of an hour; damped as said below, to 5 s: the pile at rest)
--      scripts/run examples/11_cast_blast.lua -p near=0.09 -p far=0.8   a coarse mesh, three minutes to its pile
--      scripts/run examples/11_cast_blast.lua -p damped=false        undamped, a quarter of an hour to 3.62 s: the rock flies on
--      scripts/run examples/11_cast_blast.lua -p t_end=0.03          the gas phase alone, two minutes
-- Teaches: a blast from the hole to the pile: talus.charge, viscous boundaries, damping laws, talus.blast.
-- Picture: docs/paper.md
-- Source: Ning, Yang, An & Ma, Computers and Geotechnics 38 (2011) 40-49, section 4, figures 11 to 15 and table 3.
--
-- What the paper leaves open, and what is taken here:
--   mesh         its block count is not given: triangles of 0.05 m at the hole to 0.29 m, 2200 to 2400 of them
--   borehole     22 sides: 131.4 V0 = 4.073 m3 gives V0 = 0.0310 m3, that of a 22-gon of 0.1 m (0.0031 is a misprint)
--   gas          is at the wall from the start, and at VP·t from the centre where that is more; it vents when a joint that it has
--                reached ends in the free surface, not when VP·t is the burden (2.66 m of 3 m at the paper's 26.57 ms)
--   state        plane strain; starts from the equilibrium under gravity with all joints holding
--   contacts     k_n = 1000 GPa/m, k_s = 0.4 k_n, of fresh joints pressed with tens of MPa (Bandis, Lumsden & Barton 1983). Talus's
--                usual 100 E/h, 5 to 100 times as stiff, takes 2.4 times as long for what differs less than seeds do
--   receivers    blocks of 8 m x 5 m, held, 0.05 m beside the model, their tops level with its free surface
--   damping      "a dynamic parameter adjustment", a function of step and velocity that is not given. Here a drag that grows
--                with speed, dv/dt = -v²/L with L = 2 m: v <- v/(1 + v Δt/L). It was fixed before the run and not fitted.
local talus = require "talus"
local u = talus.units

local damped = talus.param("damped", true, "the drag of the header; false: none")
local short = talus.param("short", false, "the first moments on a coarse mesh, as the tests run it")
local t_end = talus.param("t_end", short and 3e-4 or damped and 5 or 3.62, "end of the run, s")
local near = talus.param("near", short and 0.09 or 0.05, "size of blocks at the hole, m")
local far = talus.param("far", short and 0.8 or 0.29, "size of blocks far from it, m")
local seed = talus.param("seed", 0, "of strengths that scatter by a tenth (Weibull, modulus 12); 0: all alike")

local burden, L = 3.0, 2.0
local rock = talus.material { name = "rock", density = 2600, young = 55*u.GPa, poisson = 0.3, plane = "strain" }
local pressed = { per = "area", value = 1000*u.GPa }
local joint = talus.joint { name = "artificial", friction = 45*u.deg, cohesion = 2*u.MPa, tension = 0.5*u.MPa, stiffness = pressed,
                            residual = { cohesion = 0.05*u.MPa },
                            scatter = seed > 0 and talus.laws.weibull { modulus = 12, seed = seed } or nil }
local faces = talus.joint { name = "faces", friction = 45*u.deg, stiffness = pressed }

local curve, before = {}, nil  -- chamber volume every 5 ms until it vents, m3/m
local leak, at_leak = 26.57e-3, nil  -- when the paper's gas vents, s; our volume then
local function follow(sim)
  local now = { time = sim.time, volume = sim.charges[1].volume }
  while before and not sim.state.vented and now.time >= 5e-3*(#curve + 1) do
    local part = (5e-3*(#curve + 1) - before.time)/(now.time - before.time)
    curve[#curve + 1] = before.volume + part*(now.volume - before.volume)
  end
  if before and not at_leak and now.time >= leak then
    at_leak = before.volume + (leak - before.time)/(now.time - before.time)*(now.volume - before.volume)
  end
  before = now
end

local sim = talus.simulation {
  title   = "Cast blast (Ning et al. 2011)",
  gravity = {0, -9.81},
  regions = {
    talus.region { name = "bench", outline = talus.rect(0, 0, 15, 5), material = rock, joint = joint,
                   holes = { talus.circle { at = {7.5, 5 - burden}, radius = 0.1, sides = 22, name = "hole" } },
                   mesh = { size = talus.grade { { at = "hole", size = near }, far = far } } },
    talus.region { name = "left receiver", outline = talus.rect(-8.05, 0, -0.05, 5), material = rock, held = true },
    talus.region { name = "right receiver", outline = talus.rect(15.05, 0, 23.05, 5), material = rock, held = true },
  },
  contact    = faces,
  boundaries = { talus.viscous { region = "bench", on = {"left", "right", "bottom"} } },
  charges    = { talus.charge { hole = "hole", eos = talus.eos.polytropic { pressure = 1*u.GPa, gamma = 1.4 }, gas_speed = 100 } },
  numerics   = { damping = damped and function(speed, dt) return 1/(1 + speed*dt/L) end or nil },
  time       = { t_end = t_end, start = "settled", displacement_ratio = 0.005 },
  probes     = { p4 = {3.5, 2.0}, p8 = {11.5, 1.0}, surface = {7.5, 4.99}, far = {0.5, 4.9} },
  output     = { dir = "out/cast_blast", every = t_end > 0.1 and 0.02 or 1e-3, picture = "speed" },
  on_step    = follow,
  on_gas     = function(sim, events)
    for _, event in ipairs(events) do
      sim:log("%s at %.2f ms: %.3f m3, %.3g MPa", event.kind, 1e3*event.time, event.volume, event.pressure/u.MPa)
      if event.kind == "venting" then sim.state.vented = { time = event.time, volume = event.volume, pressure = event.pressure } end
    end
  end,
}
sim:run()

local charge, energy = sim.charges[1], sim.energy
local vented = sim.state.vented
if vented then
  print(string.format("vented at %.2f ms: V/V0 %.1f, %.3g MPa (paper: 26.57 ms, 131.4, 1.04 MPa)", 1e3*vented.time,
    vented.volume/charge.first_volume, vented.pressure/u.MPa))
else
  print(string.format("not vented; V/V0 %.1f, %.3g MPa", charge.volume/charge.first_volume, charge.pressure/u.MPa))
end
local sizes = talus.blast.fragmentation(sim, { regions = {"bench"}, file = "sizes" })
print(string.format("%d bonds failed, %d fragments, x50 %.2f m; gas %.3g MJ/m, of it friction %.3g, damping %.3g, boundary %.3g",
  sim.totals.failures, sizes.count, sizes.x50, energy.gas/1e6, energy.friction/1e6, (energy.damping or 0)/1e6, energy.viscous/1e6))
print(string.format("highest rise %.1f m at %.2f s (paper: 0.74 s)", sim.highest.rise, sim.highest.time))
if at_leak then talus.result("volume_ratio", at_leak/charge.first_volume, "V/V0 at 26.57 ms") end
if vented then
  talus.result("vented_at", 1e3*vented.time, "ms")
  talus.result("vented_volume", vented.volume, "m3/m")
end
talus.result("fragments", sizes.count)
talus.result("x50", sizes.x50, "m")
if sim.time > 0.5 then
  local pile = talus.blast.pile(sim, { regions = {"bench"}, moved = 0.1, ground = 5, file = "profile" })
  local speed = math.sqrt(2*energy.kinetic/(rock.density*pile.solid))
  local at, area, held, cast = sim.blocks:field "centroid", sim.blocks:field "area", sim.blocks:field "fixed", 0
  for block, p in ipairs(at) do
    if held[block] == 0 and (p[1] < 0 or p[1] > 15 or p[2] > 5) then cast = cast + area[block] end
  end
  local fastest = 0
  for _, of_block in ipairs(sim.blocks:field "speed") do fastest = math.max(fastest, of_block) end
  print(string.format("centroid of what moved by (%.2f, %.2f) m; %.1f %% of the bench lie out of it; mean speed now %.3g m/s, the fastest %.3g m/s",
    pile.shift[1], pile.shift[2], 100*cast/(15*5), speed, fastest))
  talus.result("shift_x", pile.shift[1], "m")
  talus.result("shift_y", pile.shift[2], "m")
  talus.result("moved", pile.solid/(15*5), "of the bench, by 0.1 m")
  talus.result("cast", cast/(15*5), "of the bench, out of its outline")
  talus.result("rise", sim.highest.rise, "m")
  talus.result("rise_at", sim.highest.time, "s")
  talus.result("speed", speed, "m/s")
  if damped and t_end >= 5 then talus.check.below("at rest: mean speed over root of g times the bench's height", speed/math.sqrt(9.81*5), 1e-3) end
end
for k = 2, math.min(#curve - 1, 5) do  -- as long as the paper shows it
  talus.check.above(("volume at %d ms: growth of the next 5 ms over that of the last, m3/m"):format(5*k), curve[k+1] - 2*curve[k] + curve[k-1], 0)
end
talus.check.near("P V^1.4 at the last pressure", vented and vented.pressure*(vented.volume/charge.first_volume)^1.4
  or charge.pressure*(charge.volume/charge.first_volume)^1.4, 1*u.GPa, { rel = 1e-10 })
talus.check.near("work on the wall against the law's", energy.gas/charge.work, 1, { abs = 0.005 })
talus.check.near("ledger", energy.unexplained/energy.gas, 0, { abs = 0.01 })
