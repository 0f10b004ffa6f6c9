local talus = require "talus"
local tools = require "tools"
local g = tools.g
local which = talus.param("which", "I")
local phi = talus.param("phi", 45)
local dt = talus.param("dt", 1e-3)
local young = 10e9
local rock = talus.material { name = "rock", density = 2500, young = young, poisson = 0.2 }
local function sim(regions, t_end, more)
  more = more or {}
  return talus.simulation { gravity = more.gravity or {0, -g}, contact = talus.joint { name = "c", friction = math.rad(more.phi or phi) }, regions = regions,
    time = { mode = "dynamic", t_end = t_end, dt = dt > 0 and dt or nil, start = more.start }, fix = more.fix, loads = more.loads }
end
local function report(s, seen, extra)
  tools.cost(which, seen, #s.blocks)
  print(extra or "")
end
local talus_verbose = talus.param('verbose', false)
local function watch(s)
  local before, gain, at, deep = tools.energy(s, young, g), 0, 0, 0
  local start = before.total
  local seen = tools.watch(s, function()
    local now = tools.energy(s, young, g)
    if now.total - before.total > gain then gain, at = now.total - before.total, s.time end
    before = now
    local gaps, forces = s.contacts:field "gap", s.contacts:field "normal_force"
    for k = 1, #gaps do if forces[k] > 0 and -gaps[k] > deep then deep = -gaps[k]; local c = s.contacts[k]
      if talus_verbose and deep > 1e-4 then print("DEEP", s.time, c.block_i, c.vertex, c.block_j, c.edge, c.kind, c.gap, c.normal_force, c.point[1], c.point[2]) end end end
  end)
  print(string.format("gain %.3g J of %.3g at %g, deepest %.3g, fastest %.3g", gain, start, at, deep, tools.fastest(s)))
  return seen
end
local floor = talus.region { name = "floor", outline = talus.rect(-20, -1, 20, 0), material = rock, held = true }
if which == "I" then
  local s = sim({ talus.region { name = "a", outline = talus.rect(-1, -1, 0, 0), material = rock, velocity = {1, 1} },
                  talus.region { name = "b", outline = talus.rect(0, 0, 1, 1), material = rock, velocity = {-1, -1} } }, 0.2, { gravity = {0, 0} })
  local seen = watch(s)
  report(s, seen, string.format("va %g %g vb %g %g ca %g cb %g", s.blocks[1].velocity[1], s.blocks[1].velocity[2], s.blocks[2].velocity[1], s.blocks[2].velocity[2], s.blocks[1].centroid[1], s.blocks[2].centroid[1]))
elseif which == "H" then
  for _, sides in ipairs { 16, 32, 64, 128, 256 } do
    local a = math.rad(10)
    local r = 0.5
    local s = sim({ floor, talus.region { name = "disc", outline = talus.circle { at = {0, r*math.cos(math.pi/sides)}, radius = r, sides = sides }, material = rock } }, 2,
      { gravity = {g*math.sin(a), -g*math.cos(a)}, phi = 45 })
    local seen = watch(s)
    report(s, seen, string.format("sides %d: way %g of rolling %g; spin*r/v %g y %g", sides, s.blocks[2].ux, 0.5*2/3*g*math.sin(a)*4, -s.blocks[2].spin*r/s.blocks[2].velocity[1], s.blocks[2].uy))
  end
elseif which == "B" then
  for _, mu in ipairs { 0.5, 1.2, 2, 4 } do
    local a = math.rad(50)
    local l, w = 1, 0.04
    local c, sn = math.cos(a), math.sin(a)
    local p = { {0, 0}, {w*sn, -w*c + w*c + 0}, }
    local rod = { {0, 0.0}, {l*c, l*sn}, {l*c - w*sn, l*sn + w*c}, {-w*sn, w*c} }
    for _, v in ipairs { 3, -3 } do
      local s = sim({ floor, talus.region { name = "rod", outline = rod, material = rock, velocity = {v, 0} } }, 1, { phi = math.deg(math.atan(mu)) })
      local seen = watch(s)
      report(s, seen, string.format("Painleve mu %g v %g", mu, v))
    end
  end
elseif which == "F" then
  local s = sim({ talus.region { name = "table", outline = talus.rect(-2, -1, 0, 0), material = rock, held = true }, floor and talus.region { name = "low", outline = talus.rect(-5, -3, 5, -2), material = rock, held = true },
    talus.region { name = "leaf", outline = talus.rect(-0.45, 0, 0.55, 0.001), material = rock } }, 3)
  report(s, watch(s))
elseif which == "M" then
  local b = {}
  for i = 1, 20 do b[i] = talus.rect(0.3*i, 0, 0.3*i + 0.08, 1) end
  local s = sim({ floor, talus.region { name = "d", blocks = b, material = rock } }, 4, { phi = 30 })
  s.blocks[2].spin = -1
  s.blocks[2].velocity = {0.5, 0}
  report(s, watch(s), string.format("last rotation %g", s.blocks[21].rotation))
elseif which == "P" then
  local b = {}
  for i = 1, 5 do b[i] = talus.rect(2*i - 0.0005, 0, 2*i + 0.0005, 0.001) end
  local s = sim({ floor, talus.region { name = "pebbles", blocks = b, material = rock }, talus.region { name = "rock", outline = talus.rect(1, 0.001, 11, 6), material = rock } }, 2, { phi = 30 })
  report(s, watch(s), string.format("uy %g ux %g", s.blocks[7].uy, s.blocks[7].ux))
elseif which == "W" then   -- wedge pressed between two blocks
  for _, p in ipairs { 5, 15, 25, 35 } do
    local t = math.tan(math.rad(20))
    local s = sim({ floor, talus.region { name = "w", blocks = { { {-1, 0}, {0 - 0.2, 0}, {-0.2 - t*1 + t, 1}, {-1, 1} }, { {0.2, 0}, {1, 0}, {1, 1}, {0.2, 1} }, { {0 - 0.199, 1.2}, {0.199, 1.2}, {0.6, 2.2}, {-0.6, 2.2} } }, material = rock } }, 1, { phi = p })
    report(s, watch(s), "wedge phi " .. p)
  end
elseif which == "K" then  -- fan of n triangles squeezed
  for _, n in ipairs { 3, 4, 5, 6, 8, 12 } do
    local b = {}
    for k = 1, n do
      local a0, a1 = 2*math.pi*(k - 1)/n, 2*math.pi*k/n
      b[k] = { {0, 0}, {math.cos(a0), math.sin(a0)}, {math.cos(a1), math.sin(a1)} }
    end
    local s = sim({ talus.region { name = "fan", blocks = b, material = rock } }, 0.02, { gravity = {0, 0} })
    local random = tools.random(3)
    for k = 1, n do
      local a = 2*math.pi*(k - 0.5)/n
      local v = -3*(1 + random())
      s.blocks[k].velocity = { v*math.cos(a), v*math.sin(a) }
    end
    report(s, watch(s), "fan of " .. n)
  end
elseif which == "J" then
  local s = sim({ floor, talus.region { name = "ram", outline = talus.rect(-2, 0.1, -1, 1), material = rock, held = true }, talus.region { name = "row", blocks = { talus.rect(0, 0, 1, 1), talus.rect(1, 0, 2, 1), talus.rect(2, 0, 3, 1) }, material = rock } }, 1, { phi = 30,
    fix = { talus.fix { region = "ram", velocity = {5, 0} } } })
  report(s, watch(s), string.format("v %g %g %g", s.blocks[3].velocity[1], s.blocks[4].velocity[1], s.blocks[5].velocity[1]))
elseif which == "C" then  -- T in a slot, concave
  local e = 1e-6
  local s = sim({ floor, talus.region { name = "fork", outline = { {0, 0}, {3, 0}, {3, 2}, {2 + e, 2}, {2 + e, 1}, {1 - e, 1}, {1 - e, 2}, {0, 2} }, material = rock },
    talus.region { name = "peg", outline = talus.rect(1, 1.5, 2, 3), material = rock } }, 1, { phi = 30 })
  report(s, watch(s), string.format("uy %g", s.blocks[3].uy))
elseif which == "X" then   -- crossing of four
  local b = { talus.rect(-1, 0, 0, 1), talus.rect(0, 0, 1, 1), talus.rect(-1, 1, 0, 2), talus.rect(0, 1, 1, 2) }
  local s = sim({ floor, talus.region { name = "four", blocks = b, material = rock } }, 0.5, { phi = 30, loads = { talus.point_load { region = "four", at = {-1, 2}, force = {2e4, -2e4} } } })
  report(s, watch(s), string.format("corners %g %g", s.blocks[4].vertices[2][1], s.blocks[4].vertices[2][2]))
end
