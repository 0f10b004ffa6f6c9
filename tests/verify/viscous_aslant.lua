-- Waves that meet a viscous boundary at 30 degrees, P and S: how much comes back as P and as S, by amplitude of displacement, against
-- ideal dashpots. Waves at +30 and -30 degrees make ux ~ cos(ky y), uy ~ sin(ky y), which is what a strip of the width pi/ky on rollers
-- holds, so that a strip stands for a boundary without end. A traction at its other end, which has dashpots too, makes the wave that is
-- wanted. In the last period, when the start has left, each column of blocks gives its part of cos(ky y), sin(ky y) and e^(-iwt), and four
-- waves, P and S to and fro, are fitted to these along x, with the wave numbers that the columns themselves have, so that nothing of the
-- mesh's dispersion is taken for reflection. What the other end gives back of the other kind (2 % P beside S) is taken off by theory.
-- Plane strain, Poisson's ratio 0.25, at least 16 blocks a wavelength of P and of S, theta = 0.5.
-- Source: Lysmer & Kuhlemeyer (1969). A wave p e^(i(kx x + ky y - wt)), |k| = w/c, d = k c/w, p along d for P, across it for S, has the
-- velocity -iw p and on x = const the tractions iw s, s = ((lambda p.d + 2 mu px dx)/c, mu (px dy + py dx)/c). On the boundary
-- s1 - rho cP p1 = 0 and s2 - rho cS p2 = 0, summed over the wave that comes and the P and S waves that go, of one ky (Snell): two
-- equations for two amplitudes. P at 30 degrees: 1.60 % P, 0.90 % S; S at 30 degrees: 13.4 % of each (straight on none of either).
-- With full=true also S on blocks half as large, which comes five times as near. (6 s CPU; full 18 s)
local talus = require "talus"
local u = talus.units
local full = talus.param("full", false, "the finer mesh too")
local density, young, poisson, h = 2500, 10*u.GPa, 0.25, 0.1
local steps, ramp, amplitude = 40, 4, 1e-7  -- steps a period, periods in which the load comes, m

local mu = young/2/(1 + poisson)
local stiff = young*(1 - poisson)/(1 + poisson)/(1 - 2*poisson)
local c = { P = math.sqrt(stiff/density), S = math.sqrt(mu/density) }
local dashpot = { density*c.P, density*c.S }

-- To the right (sign 1) or back (-1): wave number along x, p and s of above.
local function wave(kind, sign, ky, w)
  local k = w/c[kind]
  local kx = sign*math.sqrt(k^2 - ky^2)
  local dx, dy = kx/k, ky/k
  local px, py = dx, dy
  if kind == "S" then px, py = dy, -dx end
  return { kx = kx, p = {px, py}, s = { ((stiff - 2*mu)*(px*dx + py*dy) + 2*mu*px*dx)/c[kind], mu*(px*dy + py*dx)/c[kind] } }
end

-- Amplitudes of P and S that come back of a wave of amplitude 1, with their signs.
local function ideal(kind, ky, w)
  local function rest(of) return of.s[1] - dashpot[1]*of.p[1], of.s[2] - dashpot[2]*of.p[2] end
  local b1, b2 = rest(wave(kind, 1, ky, w))
  local p1, p2 = rest(wave("P", -1, ky, w))
  local s1, s2 = rest(wave("S", -1, ky, w))
  local det = p1*s2 - s1*p2
  return { P = (s1*b2 - b1*s2)/det, S = (b1*p2 - p1*b2)/det }
end

-- What each column of a strip of `rows` x `columns` blocks does at w: real and imaginary part of vx, then of vy. The load makes the wave
-- alone that is wanted: its own tractions, and those that the dashpots at that end take.
local function columns_of(kind, rows, columns, periods, ky, w)
  local own, cuts, loads = wave(kind, 1, ky, w), {}, {}
  for i = 1, columns - 1 do cuts[#cuts + 1] = talus.trace { points = { {i*h, 0}, {i*h, rows*h} }, bonded = true } end
  for j = 1, rows - 1 do cuts[#cuts + 1] = talus.trace { points = { {0, j*h}, {columns*h, j*h} }, bonded = true } end
  local function grow(t) return math.sin(math.pi/2*math.min(t*w/(2*math.pi*ramp), 1))^2 end
  for j = 1, rows do
    local y = ky*(j - 0.5)*h
    local fx = amplitude*w*(own.s[1] + dashpot[1]*own.p[1])*math.cos(y)
    local fy = amplitude*w*(own.s[2] + dashpot[2]*own.p[2])*math.sin(y)
    loads[j] = talus.edge_load { region = "strip", on = talus.line(0, (j - 1)*h, 0, j*h),
      traction = { function(t) return -fx*math.sin(w*t)*grow(t) end, function(t) return fy*math.cos(w*t)*grow(t) end } }
  end
  local sim = talus.simulation {
    regions = { talus.region { name = "strip", outline = talus.rect(0, 0, columns*h, rows*h), cuts = cuts, joint = talus.joint {},
      material = talus.material { density = density, young = young, poisson = poisson, plane = "strain" } } },
    fix = talus.fix { region = "strip", on = {"top", "bottom"}, y = true },
    loads = loads, boundaries = talus.viscous { region = "strip", on = {"left", "right"} },
    numerics = { theta = 0.5, recovery = false },
    time = { t_end = periods*2*math.pi/w, dt = 2*math.pi/w/steps, displacement_ratio = 0.1 },
  }
  local of, seen = {}, {}
  for k = 1, columns do seen[k] = { 0, 0, 0, 0 } end
  for i, at in ipairs(sim.blocks:field "centroid") do
    of[i] = { seen[math.floor(at[1]/h) + 1], math.cos(ky*at[2]), math.sin(ky*at[2]) }
  end
  for _ in sim:steps() do
    if sim.totals.steps > (periods - 1)*steps then
      local re, im = math.cos(w*sim.time), math.sin(w*sim.time)
      for i, v in ipairs(sim.blocks:field "velocity") do
        local column, vx, vy = of[i][1], v[1]*of[i][2], v[2]*of[i][3]
        column[1], column[2], column[3], column[4] = column[1] + vx*re, column[2] + vx*im, column[3] + vy*re, column[4] + vy*im
      end
    end
  end
  return seen, sim
end

-- Least squares: the x for which the rows {a1, …, an, b} come nearest to a.x = b; and what is left, of b.
local function least_squares(rows)
  local n, m = #rows[1] - 1, {}
  for i = 1, n do
    m[i] = {}
    for j = 1, n + 1 do
      m[i][j] = 0
      for _, row in ipairs(rows) do m[i][j] = m[i][j] + row[i]*row[j] end
    end
  end
  for i = 1, n do  -- positive definite: no pivots
    for k = 1, n do
      if k ~= i then
        local f = m[k][i]/m[i][i]
        for j = i, n + 1 do m[k][j] = m[k][j] - f*m[i][j] end
      end
    end
  end
  local x, left, all = {}, 0, 0
  for i = 1, n do x[i] = m[i][n + 1]/m[i][i] end
  for _, row in ipairs(rows) do
    local rest = row[n + 1]
    for i = 1, n do rest = rest - row[i]*x[i] end
    left, all = left + rest^2, all + row[n + 1]^2
  end
  return x, math.sqrt(left/all)
end

-- Wave numbers along x of P and S: with C = 2 cos(k s), u(x+2s) + u(x-2s) - a (u(x+s) + u(x-s)) - b u(x) = 0 for C^2 - 2 - a C - b = 0.
local function wave_numbers(seen, from, to, s)
  local rows = {}
  for part = 1, 4 do
    for k = from + 2*s, to - 2*s do
      rows[#rows + 1] = { seen[k + s][part] + seen[k - s][part], seen[k][part], seen[k + 2*s][part] + seen[k - 2*s][part] }
    end
  end
  local x = least_squares(rows)
  local root = math.sqrt(x[1]^2 + 4*(x[2] + 2))
  return math.acos((x[1] + root)/4)/(s*h), math.acos((x[1] - root)/4)/(s*h)
end

-- Amplitudes at the boundary, {real, imaginary}, of P and S that come ([1]) and go ([-1]), and the part of the motion that is neither:
-- of ux by px, of uy, which is i py sin(ky y), by -i py.
local function split(seen, from, to, k, ky, w)
  local found, worst = { P = { [1] = {0, 0}, [-1] = {0, 0} }, S = { [1] = {0, 0}, [-1] = {0, 0} } }, 0
  for axis = 1, 2 do
    local parts = {}
    for part = 1, 2 do
      local rows = {}
      for column = from, to do
        local x = (column - 0.5 - #seen)*h
        rows[#rows + 1] = { math.cos(k.P*x), math.sin(k.P*x), math.cos(k.S*x), math.sin(k.S*x), seen[column][2*axis - 2 + part] }
      end
      local found_part, left = least_squares(rows)
      parts[part] = found_part
      worst = math.max(worst, left)
    end
    for i, kind in ipairs { "P", "S" } do  -- A cos + B sin = (A - iB)/2 e^(ikx) + (A + iB)/2 e^(-ikx)
      local ar, br, ai, bi = parts[1][2*i - 1], parts[1][2*i], parts[2][2*i - 1], parts[2][2*i]
      for _, sign in ipairs { 1, -1 } do
        local re, im, sum = (ar + sign*bi)/2, (ai - sign*br)/2, found[kind][sign]
        local p = wave(kind, sign, ky, w).p[axis]
        if axis == 2 then re, im = im, -re end
        sum[1], sum[2] = sum[1] + p*re, sum[2] + p*im
      end
    end
  end
  return found, worst
end

-- Half a wavelength across is 2 sin 30 = 1 wavelength of the wave that comes: rows blocks. P with 28 has S with 16.2.
local cases = { { "P", 28, 36, 9, 3, 0.002 }, { "S", 16, 36, 22, 4, 0.01 } }
if full then cases[3] = { "S", 32, 52, 24, 8, 0.0025 } end
for _, case in ipairs(cases) do
  local kind, rows, columns, periods, apart, near = table.unpack(case)
  local ky = math.pi/(rows*h)
  local w = c[kind]*ky/math.sin(30*u.deg)
  local seen, sim = columns_of(kind, rows, columns, periods, ky, w)
  local k = {}
  k.P, k.S = wave_numbers(seen, 5, columns - 2, apart)
  local found, left = split(seen, 5, columns - 2, k, ky, w)
  local function size(a) return math.sqrt(a[1]^2 + a[2]^2) end
  local other = kind == "P" and "S" or "P"
  local comes, beside = found[kind][1], found[other][1]
  local name = ("%s at 30 degrees, %d blocks a wavelength: "):format(kind, rows)
  talus.check.below(name .. "motion that is neither P nor S, of all", left, 0.005)
  talus.check.below(name .. other .. " that comes with it", size(beside)/size(comes), 0.05)
  for _, back in ipairs { "P", "S" } do
    local more = ideal(other, ky, w)[back]  -- of what comes with it; 0.4 % of the wave
    local goes = size { found[back][-1][1] - more*beside[1], found[back][-1][2] - more*beside[2] }/size(comes)
    if kind == "P" and back == "P" then talus.check.below(name .. "reflected as P, at most", goes, 0.04) end
    talus.check.near(name .. "reflected as " .. back, goes, math.abs(ideal(kind, ky, w)[back]), { abs = near })
  end
  talus.check.below(name .. "unexplained energy", math.abs(sim.energy.unexplained)/sim.energy.scale, 1e-9)
end
