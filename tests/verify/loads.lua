-- Supports and loads on a bar of 4 m x 1 m (nu = 0), each against the uniaxial closed form, and a step too long for a fall.
-- Source: sigma = E u/L, sigma = p, sigma = force per area; initial stress in equilibrium stays and moves nothing.
local talus = require "talus"
local u = talus.units
local young = 10*u.GPa
local rock = talus.material { name = "rock", density = 2500, young = young, poisson = 0 }

local function bar(more)
  local region = { name = "bar", outline = talus.rect(0, 0, 4, 1), material = rock, mesh = { kind = "cross", nx = 8, ny = 2 } }
  for key, value in pairs(more.region or {}) do region[key] = value end
  local sim = talus.simulation {
    regions = { talus.region(region) }, loads = more.loads, probes = { middle = {2.01, 0.49}, tip = {4, 0.5} },
    fix = { talus.fix { region = "bar", on = "left" }, more.fix }, time = { mode = "static" },
  }
  sim:run()
  return sim.probes
end

local pulled = bar { fix = talus.fix { region = "bar", on = "right", displacement = {1e-3, 0} } }
talus.check.near("prescribed displacement: sigma x, Pa", pulled.middle.sxx, young*1e-3/4, { rel = 1e-3 })
local ramped = bar { fix = talus.fix { region = "bar", on = "right", displacement = { { {0, 0}, {1, 1e-3} }, 0 } } }
talus.check.near("prescribed displacement by a table: sigma x, Pa", ramped.middle.sxx, young*1e-3/4, { rel = 1e-3 })
local pressed = bar { loads = { talus.pressure { region = "bar", on = "right", value = 1*u.MPa } } }
talus.check.near("pressure: sigma x, Pa", pressed.middle.sxx, -1e6, { rel = 1e-3 })
local drawn = bar { loads = { talus.edge_load { region = "bar", on = "right", traction = { function() return 1*u.MPa end, 0 } } } }
talus.check.near("edge traction by a function: sigma x, Pa", drawn.middle.sxx, 1e6, { rel = 1e-3 })
talus.check.near("edge traction: way of the tip, m", drawn.tip.ux, 1e6*4/young, { rel = 1e-3 })
local borne = bar { region = { body_force = {1e5, 0} } }
talus.check.near("body force: sigma x at 2.01 m, Pa", borne.middle.sxx, 1e5*(4 - 2.01), { rel = 1e-3 })
-- sxx = -1 MPa + 0.25 MPa/m x is in equilibrium with a body force of -0.25 MN/m3 and vanishes at the free end.
local kept = bar { region = { stress = { sxx = -1e6, gradient_x = {0.25e6, 0, 0} }, body_force = {-0.25e6, 0} } }
talus.check.near("initial stress with gradient: sigma x at 2.01 m, Pa", kept.middle.sxx, -1e6 + 0.25e6*2.01, { rel = 1e-3 })
talus.check.below("initial stress with gradient: way of the tip over that of no stress", math.abs(kept.tip.ux)/(1e6*2/young), 0.01)

-- A block alone on a fixed edge carries its weight in its stress.
local alone = talus.simulation {
  gravity = {0, -10}, regions = { talus.region { name = "cube", outline = talus.rect(0, 0, 1, 1), material = rock } },
  fix = { talus.fix { region = "cube", on = "bottom" } }, time = { mode = "static" },
}
alone:run()
talus.check.near("block alone on a fixed edge: sigma y, Pa", alone.blocks[1].syy, -12500, { rel = 2e-3 })

-- A given step of 1 s is cut where a block would pass through another.
local drop = talus.simulation {
  gravity = {0, -9.81}, contact = talus.joint { name = "seat", friction = 0.5 },
  regions = { talus.region { name = "slab", outline = talus.rect(-2, -0.5, 2, 0), material = rock, held = true },
              talus.region { name = "block", outline = talus.rect(-0.5, 2, 0.5, 3), material = rock } },
  time = { mode = "dynamic", t_end = 5, dt = 1 },
}
drop:run()
talus.check.near("fall with a step of 1 s: way of the block, m", drop.blocks[2].uy, -2, { abs = 0.01 })
