-- A column under its own weight: s = rho g (H - y), shortening rho g H²/(2E) (nu = 0).
-- Source: rod under body force; joints close by σ/k_n, by default k_n = 100 E/h.
local talus = require "talus"
local u = talus.units
local g, density, young, height = 9.81, 2500, 10*u.GPa, 10
local rock = talus.material { name = "rock", density = density, young = young, poisson = 0 }
local shortening = density*g*height^2/(2*young)

local function column(region, contact)
  region.name, region.material = "column", rock
  local sim = talus.simulation {
    gravity = {0, -g}, contact = contact,
    regions = { talus.region(region) },
    fix = { talus.fix { region = "column", on = talus.line(0, 0, 1, 0) } },
    probes = { top = {0.5, height}, low = {0.5, 2.25}, middle = {0.5, 5.25} },
    time = { mode = "static" },
  }
  sim:run()
  return sim
end

local bonded = column { outline = talus.rect(0, 0, 1, height), mesh = { kind = "cross", nx = 2, ny = 20 } }
talus.check.near("bonded column: shortening, m", -bonded.probes.top.uy, shortening, { rel = 1e-3 })
for name, y in pairs { low = 2.25, middle = 5.25 } do
  talus.check.near("bonded column: sigma y at " .. y, bonded.probes[name].syy, -density*g*(height - y), { rel = 1e-3 })
end

local blocks, penalty_bias = {}, 0
for i = 1, 10 do
  blocks[i] = talus.rect(0, i - 1, 1, i)
  if i > 1 then penalty_bias = penalty_bias + density*g*(height - (i - 1))/(100*young/1) end
end
local stacked = column({ blocks = blocks }, talus.joint { name = "seat", friction = 30*u.deg })
-- The middle of a first-order block sits where its mean strain puts it: the top of the column moves by the sum of them.
talus.check.near("stacked column: shortening with the bias of its 9 joints, m", -stacked.probes.top.uy,
                 shortening + penalty_bias, { rel = 1e-3 })
talus.check.near("stacked column: sigma y of block 3", stacked.blocks[3].syy, -density*g*7.5, { rel = 1e-4 })

-- The same with joints of k_n = 20 GPa/m: by contact, and by spring bonds in blocks of other sizes.
local kn, closing = 20*u.GPa, 0
for i = 1, 9 do closing = closing + density*g*(height - i)/kn end
local soft = { per = "area", value = kn }
local seated = column({ blocks = blocks }, talus.joint { name = "seat", friction = 30*u.deg, stiffness = soft })
talus.check.near("joints of 20 GPa/m: shortening, m", -seated.probes.top.uy, shortening + closing, { rel = 1e-4 })
local cuts = {}
for i = 1, 9 do cuts[i] = talus.trace { points = { {-1, i}, {2, i} }, bonded = true,
                                       joint = talus.joint { name = "cement", bond = "spring", stiffness = soft } } end
local cemented = column { outline = talus.rect(0, 0, 1, height), cuts = cuts }
talus.check.near("cement of 20 GPa/m: shortening, m", -cemented.probes.top.uy, shortening + closing, { rel = 1e-4 })
