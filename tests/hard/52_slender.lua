-- Own case 52: single blocks of 1:1 to 1:100 that swing in shear, free. The strains of a block are in axes that turn with the mean of its
-- deformation gradient; those of a slender block go to and fro with its shear although nothing turns: an initial shear stress of 1e-4 to 1e-2 of
-- strain leaves it at rest in the mean. Centrifugal forces by the rate of these axes drew it out for ever: at 1:100 and 1e-2 the energy rose
-- to 658 times what there was in 100 periods at θ = ½, and at the default to 8. A square chip of 1000 m/s on a thin free plate: 4 times.
-- Bounds: energy is kept at θ = ½ and lost at the default (docs/theory.md, section 2); the axes turn to and fro by the shear strain at most, and a bar's axial stress is
-- what the shear stress E γ/2 gives it as it turns with them, E γ²; a plate that a chip strains by 0.2 leaves 1 % unexplained
-- (finite rotations in a step).
local talus = require "talus"
local u, check = talus.units, talus.check
local young, density = 20*u.GPa, 2500
local rock = talus.material { name = "rock", density = density, young = young, poisson = 0 }

local function corners(x, y, a, b, turn)
  local c, s, list = math.cos(turn), math.sin(turn), {}
  for i, p in ipairs { {-a, -b}, {a, -b}, {a, b}, {-a, b} } do list[i] = { x + c*p[1] - s*p[2], y + s*p[1] + c*p[2] } end
  return talus.polygon(list)
end

local function swing(aspect, strain, theta, turn, order)
  local thick = 1/aspect
  local period = 2*math.pi*thick/math.sqrt(young/2/density)  -- of a slender one about; a square swings in 1.4 of it
  local c, s, t = math.cos(turn), math.sin(turn), young/2*strain
  local sim = talus.simulation {
    regions = { talus.region { name = "bar", outline = corners(0, 0, 1, thick, turn), material = rock, order = order,
                               stress = { sxx = -2*s*c*t, syy = 2*s*c*t, sxy = (c*c - s*s)*t } } },
    numerics = { theta = theta },
    time = { mode = "dynamic", t_end = 50*period, dt = period/100 },
  }
  local last, rise, off, turned, long = nil, 0, 0, 0, 0
  for _ in sim:steps() do
    local e, bar = sim.energy, sim.blocks[1]
    if last then rise = math.max(rise, (e.total - last)/e.scale) end
    last, off, turned = e.total, math.max(off, math.abs(e.unexplained)/e.scale), turned + bar.spin*sim.last.dt
    long = math.max(long, math.abs(c*c*bar.sxx + s*s*bar.syy + 2*s*c*bar.sxy)/young)
  end
  return rise, off, math.abs(turned), long
end
for _, aspect in ipairs { 1, 10, 100 } do
  for _, strain in ipairs { 1e-4, 1e-2 } do
    for _, how in ipairs { {0.5, 0, 1}, {0.75, 0, 1}, {0.75, 0.5, 1}, {0.75, 0, 2} } do
      local theta, turn, order = table.unpack(how)
      local rise, off, turned, long = swing(aspect, strain, theta, turn, order)
      local name = ("1:%g, strain %g, theta %g, turned by %g, order %d: "):format(aspect, strain, theta, turn, order)
      check.below(name .. "largest rise of energy in a step over scale", rise, 1e-10)  -- round-off of places is 1e-12 of a strain of 1e-4
      check.below(name .. "unexplained", off, 1e-9)
      check.below(name .. "axes turned in the end, rad", turned, strain)
      check.below(name .. "largest axial stress over E", long, math.max(strain^2, 1e-12))
    end
  end
end

-- A bar of 2:1 that spins and swings along itself by 1e-2: the centrifugal force drew it out by the strain at the step's start, and gained 0.2 % in 50 periods,
-- 34 % in 1000. Now what is off is bounded, and goes with the square of the step.
local function spinning(n)
  local period = 2*math.pi/math.sqrt(3*young/density)  -- of a half length of 1 m
  local bar = talus.simulation {
    regions = { talus.region { name = "bar", outline = corners(0, 0, 1, 0.5, 0), material = rock, stress = { sxx = -0.01*young },
                               spin = math.sqrt(1e-3*3*young/density) } },
    numerics = { theta = 0.5 }, time = { mode = "dynamic", t_end = 50*period, dt = period/n },
  }
  local most = 0
  for _ in bar:steps() do most = math.max(most, math.abs(bar.energy.unexplained)/bar.energy.scale) end
  return most
end
local coarse, fine = spinning(40), spinning(80)
check.below("bar that spins and swings along itself, 40 steps a period: unexplained", coarse, 1e-5)
check.between("bar that spins and swings along itself, 40 over 80 steps a period: order", math.log(coarse/fine)/math.log(2), 1.8, 2.2)

for _, dt in ipairs { 4e-7, 1e-7, 2.5e-8 } do
  local sim = talus.simulation {
    contact = talus.joint { name = "rough", friction = 0.5 },
    regions = { talus.region { name = "plate", outline = talus.rect(-1, -0.02, 1, 0), material = rock },
                talus.region { name = "chip", outline = corners(0, 0.05*(math.cos(0.3) + math.sin(0.3)) + 1e-4, 0.05, 0.05, 0.3), material = rock, velocity = {0, -1000} } },
    time = { mode = "dynamic", t_end = 2e-4, dt = dt },
  }
  local most = 0
  for _ in sim:steps() do most = math.max(most, math.abs(sim.energy.unexplained)/sim.energy.scale) end
  check.below(("chip on a thin plate, dt %g: unexplained, most"):format(dt), most, 0.01)
end
