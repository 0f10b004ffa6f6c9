-- How far what comes of the cast blast depends on the mesh and on the strengths of single bonds: 11_cast_blast.lua on three meshes,
-- each of twice as many blocks as the one before, with two scatters of strength each, to their piles.
-- Run: talus sweep examples/studies/cast_blast.lua -j 2        (6 runs of three minutes to a quarter of an hour)
-- Results: out/cast_blast_study/results.csv and index.html, a folder for each run in out/cast_blast_study/runs.
-- Teaches: cases, seeds, results of the scene's own.
local talus = require "talus"

talus.study {
  title = "Cast blast: meshes and scatter",
  scene = "../11_cast_blast.lua",
  cases = { { near = 0.09, far = 0.8 }, { near = 0.065, far = 0.45 }, { near = 0.05, far = 0.29 } },
  seeds = 2,
  collect = {
    blocks   = "sizes.blocks",
    volume   = "results.volume_ratio",
    vented_at = "results.vented_at", vented_volume = "results.vented_volume",
    x50      = "results.x50",
    moved    = "results.moved", cast = "results.cast",
    shift_x  = "results.shift_x", shift_y = "results.shift_y",
    rise     = "results.rise", rise_at = "results.rise_at",
    speed    = "results.speed",
    gas      = "energy.gas_work", unexplained = "energy.unexplained_ratio",
  },
  dir = "out/cast_blast_study",
}
