-- Rigid-body motion: free fall (g t²/2), the impact of two blocks
-- (momentum), a stack at rest (weight above the middle of each block), sliding along a real joint. Sources: closed forms.
local talus = require "talus"
local u = talus.units
local g = 9.81
local rock = talus.material { name = "rock", density = 2500, young = 10*u.GPa, poisson = 0 }
local smooth = talus.joint { name = "smooth", friction = 0 }

local fall = talus.simulation {
  gravity = {0, -g}, probes = { c = {0.5, 0.5} },
  regions = { talus.region { name = "block", outline = talus.rect(0, 0, 1, 1), material = rock } },
  time = { mode = "dynamic", t_end = 1, dt = 1e-2 },
}
fall:run()
talus.check.near("free fall, 1 s", fall.probes.c.uy, -g/2, { rel = 1e-10 })

local impact = talus.simulation {
  contact = smooth,
  regions = {
    talus.region { name = "left", outline = talus.rect(0, 0, 1, 1), material = rock, velocity = {2, 0} },
    talus.region { name = "right", outline = talus.rect(1.01, 0, 2.01, 1), material = rock },
  },
  time = { mode = "dynamic", t_end = 0.05, dt = 1e-4 },
}
impact:run()
talus.check.near("impact: momentum / mass", impact.blocks[1].velocity[1] + impact.blocks[2].velocity[1], 2, { rel = 1e-12 })

local outlines = {}
for i = 1, 10 do outlines[i] = talus.rect(0, i - 1, 1, i) end
local stack = talus.simulation {
  gravity = {0, -g}, contact = smooth,
  regions = {
    talus.region { name = "slab", outline = talus.rect(-1, -1, 2, 0), material = rock, held = true },
    talus.region { name = "stack", blocks = outlines, material = rock },
  },
  time = { mode = "static" },
}
stack:run()
for i = 1, 10, 3 do
  talus.check.near("stack of 10: syy of block " .. i, stack.blocks[i + 1].syy, -2500*g*(10.5 - i), { rel = 1e-4 })
end

-- A row of blocks, cut from one region by real joints, slides along the lowest of them past other blocks than those it lay on.
local slope, cuts = 20*u.deg, { talus.trace { points = { {-1, 1}, {25, 1} }, joint = talus.joint { name = "bedding", friction = 10*u.deg } } }
for x = 1, 23 do cuts[#cuts + 1] = talus.trace { points = { {x, -1}, {x, 1} } } end
for x = 6, 18, 6 do cuts[#cuts + 1] = talus.trace { points = { {x, 1}, {x, 3} } } end
local bedded = talus.simulation {
  gravity = {g*math.sin(slope), -g*math.cos(slope)},
  regions = { talus.region { name = "rock", outline = talus.rect(0, 0, 24, 2), material = rock, cuts = cuts,
                             joint = talus.joint { name = "other joints", friction = 35*u.deg } } },
  fix = { talus.fix { region = "rock", on = talus.line(0, 0, 24, 0) } },
  probes = { c = {3, 1.5} }, time = { mode = "dynamic", t_end = 1.5, dt = 2e-3, start = "rest" },
}
bedded:run()
talus.check.near("row of blocks on a real joint: way after 1.5 s, m", bedded.probes.c.ux,
                 g*(math.sin(slope) - math.tan(10*u.deg)*math.cos(slope))*1.5^2/2, { rel = 1e-4 })

-- A shear box in static steps: a block under a pressure of 1 MPa on a slab that is moved by 2 mm, or moved itself. Coulomb: the reaction
-- is N tan φ, and what the slab is moved with is friction's and what block and contacts store.
for _, order in ipairs { 1, "rigid" } do
  for _, moved in ipairs { "slab", "block" } do
    local phi, pull = 32*u.deg, { { {0, 0}, {1, 2*u.mm} }, 0 }
    local rock = talus.material { name = "rock", density = 2500, young = 10*u.GPa, poisson = 0.2 }
    local stop = moved == "slab" and { on = talus.line(0, 0.5, 0, 1) } or { on = talus.line(0, 0.5, 0, 1), displacement = pull }
    local sim = talus.simulation {
      contact = talus.joint { friction = phi },
      regions = { talus.region { name = "slab", outline = talus.rect(-0.5, 0, 1.5, 0.5), material = rock, held = true },
                  talus.region { name = "block", outline = talus.rect(0, 0.5, 1, 1), material = rock, order = order } },
      fix     = { talus.fix { name = "stop", region = "block", on = stop.on, x = true, y = false, displacement = stop.displacement },
                  moved == "slab" and talus.fix { name = "slab", region = "slab", displacement = pull } or nil },
      loads   = { talus.pressure { region = "block", on = "top", value = 1*u.MPa } },
      time    = { mode = "static", steps = 10 },
    }
    sim:run()
    local label = string.format("static shear box, %s moved, order %s: ", moved, order)
    -- The pressure follows the top, which bends by some 1e-4.
    talus.check.near(label .. "reaction, N", math.abs(sim.reactions.stop[1]), 1*u.MPa*math.tan(phi), { rel = 2e-4 })
    talus.check.below(label .. "unexplained, of the work put in", math.abs(sim.energy.unexplained/sim.energy.scale), 1e-6)
  end
end
