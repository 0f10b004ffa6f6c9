-- 11. 1 GPa on blocks of 1 cm (ρ 2600, E 55 GPa): a plane wall moves at P/(ρc) ± 2 % over 10 transits (c the P speed of the plane
-- state); a ring of them: no inverted block, penetration < 1 % L, at most 5 step cuts in a row.
-- The wall: 40 blocks that only touch, in a frictionless channel, in both plane states; the corners of its face over all ten transits. The
-- ring: 4 x 63 blocks that only touch round a hole of 0.1 m, blown apart for 0.2 ms, with the friction of rock.
-- Source: one-dimensional elastic wave, v = P/(ρc), held sideways: c² = E/(ρ(1 − ν²)) in plane stress,
-- E(1 − ν)/(ρ(1 + ν)(1 − 2ν)) in plane strain. (ring: 10 s CPU)
local talus = require "talus"
local tools = require "tools"
local full = talus.param("full", false, "0.2 ms of the ring instead of 0.05")
local density, young, poisson, L, P = 2600, 55e9, 0.3, 0.01, 1e9
local rock = talus.material { name = "rock", density = density, young = young, poisson = poisson }
local joint = talus.joint { name = "joint", friction = math.rad(45) }

for _, plane in ipairs { "stress", "strain" } do
  local c = math.sqrt((plane == "stress" and young/(1 - poisson^2) or young*(1 - poisson)/(1 + poisson)/(1 - 2*poisson))/density)
  local stuff = talus.material { density = density, young = young, poisson = poisson, plane = plane }
  for _, mode in ipairs { "automatic", "transit/20" } do
    local blocks = {}
    for i = 1, 40 do blocks[i] = talus.rect((i - 1)*L, 0, i*L, L) end
    local time = { mode = "dynamic", t_end = 10*L/c }
    if mode ~= "automatic" then time.dt = L/c/20 end
    local sim = talus.simulation {
      contact = joint,
      regions = { talus.region { name = "wall", blocks = blocks, material = stuff } },
      fix = { talus.fix { region = "wall", on = {"top", "bottom"}, y = true, x = false } },
      loads = { talus.pressure { region = "wall", on = "left", value = P } },
      time = time,
    }
    local name = ("plane %s, dt %s"):format(plane, mode)
    tools.cost("wall, " .. name, tools.watch(sim), 40)
    local face = math.huge  -- at 0 when the pressure comes
    for _, corner in ipairs(sim.blocks[1].vertices) do face = math.min(face, corner[1]) end
    talus.check.near("1 GPa on a wall of 1 cm blocks, " .. name .. ": speed of its face over P/(rho c)", face/sim.time/(P/density/c), 1,
                     { rel = 0.02 })
  end
end

local around, layers, R = 63, 4, 0.1
local blocks, loads = {}, {}
for layer = 1, layers do
  for k = 1, around do
    local a, b, r = 2*math.pi*(k - 1)/around, 2*math.pi*k/around, R + (layer - 1)*L
    local function at(radius, angle) return { radius*math.cos(angle), radius*math.sin(angle) } end
    blocks[#blocks + 1] = { at(r, a), at(r + L, a), at(r + L, b), at(r, b) }
    if layer == 1 then
      loads[k] = talus.pressure { region = "ring", on = talus.segment(at(r, a), at(r, b)), value = P }
    end
  end
end
local sim = talus.simulation {
  contact = joint, regions = { talus.region { name = "ring", blocks = blocks, material = rock } }, loads = loads,
  time = { mode = "dynamic", t_end = full and 2e-4 or 5e-5 },
}
local deepest, least = 0, 1
local areas = sim.blocks:field "area"
local seen = tools.watch(sim, function()
  local gaps, forces = sim.contacts:field "gap", sim.contacts:field "normal_force"
  for k = 1, #gaps do if forces[k] > 0 then deepest = math.max(deepest, -gaps[k]) end end
  for i, area in ipairs(sim.blocks:field "area") do least = math.min(least, area/areas[i]) end
end)
tools.cost("ring", seen, #blocks)
talus.check.near("ring under 1 GPa: time reached, s", sim.time, full and 2e-4 or 5e-5, { rel = 1e-9 })
talus.check.above("ring under 1 GPa: least area over that of the start", least, 0.5)
talus.check.below("ring under 1 GPa: largest penetration over L", deepest/L, 0.01)
talus.check.below("ring under 1 GPa: most cuts of one step and most cut steps in a row", math.max(seen.cuts_in_row, seen.most_cuts), 5.5)
