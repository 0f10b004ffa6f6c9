-- Some runs of slide.lua: good ones, one that is refused, one whose check fails.
local talus = require "talus"
talus.study {
  scene = "slide.lua",
  cases = { { angle = 20 }, { angle = 30 }, { angle = 35, note = "fail" }, { angle = 40, note = "refuse" } },
  parameters = { friction = talus.range(10, 30, 3) },
  seeds = 2,
  collect = {
    way = "results.way",
    top = { history = "top.ux", at = 0.1 },
    fastest = { history = "kinetic_energy", take = "max" },
    blocks = "sizes.blocks",
    half = function(run) return run.parameters.angle/2 end,
  },
}
