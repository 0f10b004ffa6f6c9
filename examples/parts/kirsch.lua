-- Tension 1 MPa along x round a hole of radius 1 m (Kirsch 1898), in a square plate of half side 4 m. Outline and hole, a polygon of 48
-- sides, bear the tractions that this stress has on them, each quarter of a side and each sixteenth of a metre its mean.
local talus = require "talus"
local kirsch = { half = 4, far = 1e6, young = 10e9, poisson = 0.25 }

function kirsch.stress(x, y)
  local r2, t = x*x + y*y, math.atan(y, x)
  local q, c2, s2, c4, s4 = 1/r2, math.cos(2*t), math.sin(2*t), math.cos(4*t), math.sin(4*t)
  return kirsch.far*(1 - q*(1.5*c2 + c4) + 1.5*q*q*c4), kirsch.far*(-q*(0.5*c2 - c4) - 1.5*q*q*c4),
         kirsch.far*(-q*(0.5*s2 + s4) + 1.5*q*q*s4)
end

-- The mean traction from p to q, the body on the left.
local function traction(p, q)
  local dx, dy, tx, ty, parts = q[1] - p[1], q[2] - p[2], 0, 0, 8
  local length = math.sqrt(dx*dx + dy*dy)
  for k = 1, parts do
    local s = (k - 0.5)/parts
    local sxx, syy, sxy = kirsch.stress(p[1] + s*dx, p[2] + s*dy)
    tx, ty = tx + (sxx*dy - sxy*dx)/length/parts, ty + (sxy*dy - syy*dx)/length/parts
  end
  return { tx, ty }
end

-- mesh: size; order; probes.
function kirsch.simulation(size, order, more)
  local h, hole, loads = kirsch.half, {}, {}
  for k = 0, 47 do hole[k + 1] = { math.cos(k*math.pi/24), -math.sin(k*math.pi/24) } end  -- clockwise: the body on its left
  local function load(p, q)
    loads[#loads + 1] = talus.edge_load { region = "plate", on = talus.segment(p, q), traction = traction(p, q) }
  end
  local function load_all(a, b, parts)
    local function at(s) return { a[1] + s*(b[1] - a[1]), a[2] + s*(b[2] - a[2]) } end
    for k = 1, parts do load(at((k - 1)/parts), at(k/parts)) end
  end
  for k = 1, 48 do load_all(hole[k], hole[k % 48 + 1], 4) end
  local corners = { {-h, -h}, {h, -h}, {h, h}, {-h, h} }
  for side = 1, 4 do load_all(corners[side], corners[side % 4 + 1], 32*h) end
  local fields = {
    regions = { talus.region { name = "plate", outline = talus.rect(-h, -h, h, h), holes = { talus.polygon(hole) }, order = order,
                               material = talus.material { density = 2500, young = kirsch.young, poisson = kirsch.poisson, plane = "stress" },
                               mesh = { size = size } } },
    fix = { talus.fix { region = "plate", on = talus.point(-h, -h) }, talus.fix { region = "plate", on = talus.point(h, -h), y = true } },
    loads = loads, time = { mode = "static" },
  }
  for key, value in pairs(more or {}) do fields[key] = value end
  return talus.simulation(fields)
end

-- Probes on a grid, and the true error of the raw stress at them, relative in energy norm: a sum over even samples of the plate.
function kirsch.samples(spacing)
  local probes, n = {}, 0
  for x = -kirsch.half + spacing/2, kirsch.half, spacing do
    for y = -kirsch.half + spacing/2, kirsch.half, spacing do
      if x*x + y*y > 1 then
        n = n + 1
        probes["p" .. n] = { x, y }
      end
    end
  end
  return probes
end
function kirsch.true_error(sim)
  local function energy(a, b, c) return (a*a + b*b - 2*kirsch.poisson*a*b + 2*(1 + kirsch.poisson)*c*c)/kirsch.young end
  local error, whole = 0, 0
  for _, probe in ipairs(sim.probes) do
    local sxx, syy, sxy = kirsch.stress(probe.x, probe.y)
    error = error + energy(probe.raw_sxx - sxx, probe.raw_syy - syy, probe.raw_sxy - sxy)
    whole = whole + energy(sxx, syy, sxy)
  end
  return math.sqrt(error/whole)
end

return kirsch
