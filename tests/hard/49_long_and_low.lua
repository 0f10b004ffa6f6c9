-- 49. Equilibrium of what is slow or comes and goes: a rock beam of 18 m by 0.3 m with a block on it, and arches of 40 and 60 voussoirs by a settled start.
-- Source: beam held at both ends, w = F L³/192EI + q L⁴/384EI; an arch of thickness t/R > 0.1075 stands (Heyman). Ours: the search held what moves by the height of the scene, hundreds of times
-- as hard as the beam is, and said that nothing holds it; the settled start tried sticking joints alone, among which an arch's contacts come and go. (1 s CPU)
local talus = require "talus"
local g = 9.81
local L, t, E = 18, 0.3, 20e9
local rock = talus.material { name = "rock", density = 2500, young = E, poisson = 0 }
local n = 180
local sim = talus.simulation {
  gravity = {0, -g}, contact = talus.joint { friction = math.rad(35) },
  regions = { talus.region { name = "beam", outline = talus.rect(0, 0, L, t), material = rock, mesh = { kind = "cross", nx = n, ny = 4 } },
              talus.region { name = "block", outline = talus.rect(L/2 - 0.5, t, L/2 + 0.5, t + 0.4), material = rock } },
  fix = { talus.fix { region = "beam", on = talus.line(0, 0, 0, t) }, talus.fix { region = "beam", on = talus.line(L, 0, L, t) } },
  time = { mode = "static" },
}
sim:run()
local sag, I = 0, t^3/12
for _, b in ipairs(sim.blocks) do sag = math.max(sag, -b.uy) end
-- The block lies on the middle's 1 m, which lowers F's part by less than a hundredth; triangles of a quarter of its height and the pull along it make it stiffer by 4 %.
talus.check.near("beam of 18 m with a block on it: sags, m", sag, 2500*g*0.4*L^3/(192*E*I) + 2500*g*t*L^4/(384*E*I), { rel = 0.06 })
local R, thick = 5, 0.12
for _, count in ipairs { 40, 60 } do
  local blocks = {}
  for i = 1, count do
    local s, e, a, b = math.pi*(i - 1)/count, math.pi*i/count, R*(1 - thick/2), R*(1 + thick/2)
    blocks[i] = { {a*math.cos(s), a*math.sin(s)}, {b*math.cos(s), b*math.sin(s)}, {b*math.cos(e), b*math.sin(e)}, {a*math.cos(e), a*math.sin(e)} }
  end
  local way = {}
  for _, time in ipairs { { mode = "static" }, { t_end = 0.2, dt = 5e-3, start = "settled" } } do
    local arch = talus.simulation {
      gravity = {0, -g}, contact = talus.joint { friction = math.rad(60) },
      regions = { talus.region { name = "floor", outline = talus.rect(-7, -0.5, 7, 0), material = rock, held = true }, talus.region { name = "arch", blocks = blocks, material = rock } },
      time = time,
    }
    arch:run()
    local most = 0
    for _, b in ipairs(arch.blocks) do most = math.max(most, b.u) end
    way[#way + 1] = most
  end
  talus.check.near(string.format("arch of %d voussoirs, settled against static: largest way, m", count), way[2], way[1], { rel = 1e-3 })
end
