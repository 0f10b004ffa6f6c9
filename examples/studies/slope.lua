-- How far the slope of 03_slope.lua has slid after 1.5 s, over the friction of its joints and the dip of the set that daylights.
-- Run: talus sweep examples/studies/slope.lua -j 2        (20 runs, 20 s CPU)
-- Results: out/slope_study/results.csv and index.html, a folder for each run in out/slope_study/runs.
-- Teaches: a grid of parameters, ranges, what to collect: a result, the history of a probe, run.json, a function of the run.
local talus = require "talus"

talus.study {
  title = "Slope: friction and dip",
  scene = "../03_slope.lua",
  parameters = { friction = {15, 20, 25, 30, 35}, dip = talus.range(26, 35, 4) },
  collect = {
    way     = "results.way",
    speed   = { value = function(run)
      local h = run.history
      return math.sqrt(h["layer.vx"][#h.time]^2 + h["layer.vy"][#h.time]^2)
    end, unit = "m/s" },
    at_1_s  = { history = "layer.uy", at = 1, label = "u_y at 1 s" },
    blocks  = "sizes.blocks",
  },
  dir = "out/slope_study",
}
