-- Remeshing to a wanted error.
return {
  {
    kind = "refine", call = "talus.refine",
    doc = "Runs a static scene on one mesh after another until the estimated error of its stress is small enough: `sim.error.relative`, in"
      .. " energy norm. Sizes follow from the estimate so that every block has the same error (theory, § 8). Returns the last simulation"
      .. " `sim`, `error` (estimated, reached), `wanted`, `blocks`, `seconds` (CPU, of all rounds), `rounds` (a list of `{ blocks, error, seconds }`,"
      .. " seconds so far) and `size`, the function of x and y of the last mesh. Where the error would need more than `max_blocks` it ends with"
      .. " an error that says how many. A load or support at a point gives an infinite energy, which no mesh resolves: put it on an edge.",
    fields = {
      { name = "scene", type = "function", required = true,
        doc = "`function(size)` that returns the simulation, `size` being what to give as `mesh = { size = size }`: a number first, then a"
          .. " function of x and y" },
      { name = "error", type = "number", above = 0, most = 0.5, default = 0.02, doc = "wanted, relative, of the whole scene" },
      { name = "size", type = "number", above = 0, unit = "m", required = true, doc = "edge of the first mesh; none becomes longer" },
      { name = "max_blocks", type = "integer", least = 1, default = 20000, doc = "most blocks of a mesh" },
      { name = "rounds", type = "integer", least = 1, most = 50, default = 8, doc = "most meshes" },
      { name = "log", type = "boolean", default = true, doc = "a line for each round" },
    },
  },
}
