-- 24. Penetrated start (blocks overlapping by 1e-3 L): separates without gaining more than 1e-3 of the overlap's penalty energy.
-- Two squares side by side, a corner in a face, corner in corner, and one block overlapping two neighbours; no gravity.
-- The overlap's penalty energy: k_n o²/2 over its contacts, with the default stiffness α E/h per length, α = 100. (0.1 s CPU)
local talus = require "talus"
local L, young = 1, 10e9
local o = 1e-3*L
local rock = talus.material { name = "rock", density = 2500, young = young, poisson = 0.2 }
local s = math.sqrt(2)/2
local scenes = {
  ["face in face"] = { { talus.rect(0, 0, 1, 1), talus.rect(1 - o, 0, 2 - o, 1) }, 100*young/L*L },
  ["offset faces"] = { { talus.rect(0, 0, 1, 1), talus.rect(1 - o, 0.3, 2 - o, 1.3) }, 100*young/L*0.7 },
  ["corner in face"] = { { talus.rect(0, 0, 1, 1), talus.polygon { {1 - o, 0.5}, {1 - o + s, 0.5 - s}, {1 - o + 2*s, 0.5}, {1 - o + s, 0.5 + s} } }, 100*young/2 },
  ["corner in corner"] = { { talus.rect(0, 0, 1, 1), talus.rect(1 - o, 1 - o, 2 - o, 2 - o) }, 100*young/2 },
  ["two neighbours"] = { { talus.rect(0, 0, 1, 1), talus.rect(1, 0, 2, 1), talus.rect(0.5, 1 - o, 1.5, 2 - o) }, 100*young/L*L },
}
for name, case in pairs(scenes) do
  for _, apart in ipairs { false, true } do
    local sim = talus.simulation {
      contact = talus.joint { name = "contact", friction = 0.5 },
      regions = { talus.region { name = "blocks", blocks = case[1], material = rock } },
      time = { mode = "dynamic", t_end = 0.2, dt = 1e-3 },
    }
    local last = sim.blocks[#sim.blocks]
    local start = 0
    if apart then  -- pulled off at 0.1 m/s
      local n = name == "corner in corner" and {0.1*s, 0.1*s} or name == "two neighbours" and {0, 0.1} or {0.1, 0}
      last.velocity = n
      start = 0.5*last.mass*0.01
    end
    local penalty, most = 0.5*case[2]*o^2, 0
    for _ in sim:steps() do most = math.max(most, sim.energy.kinetic + sim.energy.strain) end
    talus.check.below(string.format("overlap of 1e-3 L, %s%s: energy gained over that of the overlap", name, apart and ", pulled off" or ""),
                      (most - start)/penalty, 1e-3)
    if apart then
      talus.check.above(string.format("overlap of 1e-3 L, %s, pulled off: speed kept", name), last.speed/0.1, 0.999)
    end
  end
end
