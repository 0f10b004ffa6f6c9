-- Laboratory tests of bonded rock, and what finds joint values from their results.
local function file(what)
  return { name = "file", type = "string", default_doc = "nothing is written",
    doc = "name, without ending, of " .. what .. " in output.dir" }
end
local material = { name = "material", type = "object", kinds = { "material" }, required = true, doc = "of specimen and plates" }
local joint = { name = "joint", type = "object", kinds = { "joint" }, required = true, doc = "of its bonds" }
local size = { name = "size", type = "number", above = 0, unit = "m", required = true, doc = "edge of its triangles" }
local title = { name = "title", type = "string", default_doc = "none", doc = "for output" }
local output = { name = "output", type = "object", kinds = { "output" }, inline = true, default_doc = "nothing is written",
  doc = "as of a simulation" }
local steps = { name = "steps", type = "integer", least = 2, most = 10000, default = 20, doc = "even increments of the plate's way" }
local keep = { name = "keep", type = "number", above = 0, below = 1, default = 0.7,
  doc = "the test ends when the load has fallen to this part of its highest" }

return {
  {
    kind = "compression", call = "talus.lab.compression",
    doc = "Compresses a rectangle of bonded triangles between two plates without friction, the upper one moved; with `pressure` on its"
      .. " sides, which come first, a biaxial test. Returns `strength` (Pa, the highest axial stress, load over width), `young` (Pa,"
      .. " slope of axial stress over strain below half of it; with plane strain E/(1 − ν²)), `strain` and `stress` (lists, compression"
      .. " positive), `broke`, `collapsed` (a piece came free, where a static run ends: the rock might have borne more), `width`, `height` and"
      .. " the simulation `sim`.",
    fields = {
      material, joint, size,
      { name = "width", type = "number", above = 0, unit = "m", default_doc = "10 sizes", doc = "of the specimen" },
      { name = "height", type = "number", above = 0, unit = "m", default_doc = "twice the width", doc = "of the specimen" },
      { name = "pressure", type = "number", least = 0, unit = "Pa", default = 0, doc = "on its sides" },
      { name = "strain", type = "number", above = 0, below = 0.2, default_doc = "1.5 times that of Mohr–Coulomb's strength",
        doc = "to which the plate goes where the rock does not break before" },
      steps, keep, title, output, file("the curve as table (.csv) and picture (.svg)"),
    },
  },
  {
    kind = "brazilian", call = "talus.lab.brazilian",
    doc = "Splits a disc with two flats of 7.2° between plates without friction. Returns `strength` (Pa, 2P/(πD)·(sin 2a/a − 1), a = 3.6°,"
      .. " of the highest load P), `load` (N/m), `diameter`, `broke`, `fell` (to `keep` of its peak before the way of the plate ended: else the strength may be that of the halves) and the simulation `sim`.",
    fields = {
      material, joint, size,
      { name = "diameter", type = "number", above = 0, unit = "m", default_doc = "20 sizes", doc = "of the disc" },
      steps, keep, title, output,
    },
  },
  {
    kind = "calibrate", call = "talus.calibrate", returns = "table",
    doc = "Joint values that give wanted strengths on a mesh of a given size, by repeated small tests (`talus.lab`): cohesion from the"
      .. " uniaxial strength, tension from the Brazilian one, friction from a confined strength where one is given. Returns `joint`"
      .. " (`{ friction, cohesion, tension }`, fields for talus.joint), `reached` (`{ young, ucs, tensile, confined }`, Pa, as measured"
      .. " with these values), `off` (largest part by which a strength misses), `rounds`, `converged` and where that is false `reason`: also a test that"
      .. " finds no strength or stops ends it so. Young's modulus needs no"
      .. " joint values: bonds add no compliance. What it cannot reach: a Brazilian strength above about a tenth of the uniaxial"
      .. " one, as flats of 7.2° are crushed before the disc splits (`converged` is false then, `reached` says what came of it). Brittle strengths"
      .. " scatter by some per cent from mesh to mesh (`meshes`).",
    fields = {
      material,
      { name = "ucs", type = "number", above = 0, unit = "Pa", required = true, doc = "wanted uniaxial compressive strength" },
      { name = "tensile", type = "number", above = 0, unit = "Pa", required = true, doc = "wanted Brazilian tensile strength" },
      size,
      { name = "friction", type = "number", least = 0, below = math.pi/2, unit = "rad", default = math.pi*35/180, default_doc = "35 deg",
        doc = "of the joints; the first guess where a confined strength is given" },
      { name = "confined", type = "object", kinds = { "confined" }, inline = true, default_doc = "friction stays",
        doc = "a strength under pressure" },
      { name = "residual", type = "object", kinds = { "residual" }, inline = true, default_doc = "as of a joint",
        doc = "what failed bonds still carry, in the tests" },
      { name = "across", type = "integer", least = 5, most = 100, default = 10,
        doc = "triangle edges across the width of the compressed specimen; the disc has twice as many across its diameter" },
      { name = "meshes", type = "integer", least = 1, most = 20, default = 1, doc = "the mean of as many meshes, each 2 % finer" },
      { name = "tolerance", type = "number", above = 0, below = 0.5, default = 0.03, doc = "part by which strengths may miss" },
      { name = "most", type = "integer", least = 1, most = 50, default = 6, doc = "rounds before it gives up, with the best so far" },
    },
  },
  {
    kind = "confined", call = "", doc = "A strength under pressure at the sides.",
    fields = {
      { name = "pressure", type = "number", above = 0, unit = "Pa", required = true, doc = "at the sides" },
      { name = "strength", type = "number", above = 0, unit = "Pa", required = true, doc = "the axial stress it bears; above ucs and above the pressure" },
    },
  },
}
