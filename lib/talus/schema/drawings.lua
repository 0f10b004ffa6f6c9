-- Files of traces and outlines; the options come after the file's name.
local file = { name = "file", type = "string", required = true,
  doc = "first argument: name, from the scene's folder on" }
local scale = { name = "scale", type = "number", above = 0, unit = "m", default_doc = "as $INSUNITS says, else 1",
  doc = "metres for a unit of the file" }
local joint = { name = "joint", type = "object", kinds = { "joint" }, default_doc = "the region's joint",
  doc = "property of the interfaces" }
local bonded = { name = "bonded", type = "boolean", default = false, doc = "as of a `talus.trace`" }
local chord = { name = "chord", type = "number", above = 0, most = 0.5, default = 0.01,
  doc = "arcs become chords: greatest distance between the two, of the radius",
  source = "22 chords for a circle" }

return {
  {
    kind = "traces_from_csv", call = "talus.traces_from_csv",
    doc = "Traces from a table, for `cuts` of a region: `talus.traces_from_csv(\"faults.csv\", { joint = … })`. Columns by"
      .. " a header: `trace,x,y`, a point a row, the rows of a trace following each other; or `x1,y1,x2,y2`, a straight"
      .. " trace a row, with `trace` for its name if there is one. Other columns are not read. Separated by commas,"
      .. " semicolons or tabs; empty lines and those that begin with # are skipped. Traces outside of the region, or that"
      .. " end inside a block, are counted in a note.",
    fields = {
      file, joint, bonded,
      { name = "scale", type = "number", above = 0, unit = "m", default_doc = "1", doc = scale.doc },
    },
  },
  {
    kind = "traces_from_dxf", call = "talus.traces_from_dxf",
    doc = "Traces from a drawing (ASCII DXF), for `cuts` of a region: `talus.traces_from_dxf(\"plan.dxf\", { layers = {"
      .. " \"faults\" } })`. LINE, LWPOLYLINE and POLYLINE with bulges, ARC and CIRCLE are read; a note counts what is"
      .. " not, and says which unit was taken.",
    fields = {
      file,
      { name = "layers", type = "list", of = { type = "string" }, count = 1, default_doc = "all",
        doc = "layers to read, in capitals or not" },
      joint,
      { name = "joints_by_layer", type = "map", of = { type = "object", kinds = { "joint" } }, default_doc = "joint",
        doc = "property of the traces of some layers: `{ faults = weak }`" },
      bonded, scale, chord,
    },
  },
  {
    kind = "outlines_from_dxf", call = "talus.outline_from_dxf",
    doc = "An outline from a drawing, the one closed line of a layer: `talus.outline_from_dxf(\"plan.dxf\", { layer ="
      .. " \"slope\" })`. `talus.outlines_from_dxf` gives a list of all of them, for `holes`; each has its layer for a"
      .. " name.",
    fields = {
      file,
      { name = "layer", type = "string", default_doc = "all", doc = "layer to read" },
      scale, chord,
    },
  },
  {
    kind = "gmsh", call = "talus.gmsh",
    doc = "A mesh of Gmsh (.msh, version 2 or 4.1, ASCII): its triangles and quadrangles as ready blocks, for `blocks` of a region with `bonded"
      .. " = true`. Returns `blocks` (all of them), `surfaces.name` (those of a physical surface), `curves.name` (a list of lines, the"
      .. " straight parts of a physical curve, for `on` of a fixity or load) and `loops.name` (the outline of a physical curve that closes, for"
      .. " `holes` of the region; the hole has the curve's name). An element of several groups goes with the first; those of"
      .. " second order are taken by their corners; a note says what was read. Between regions there are contacts, also where their"
      .. " elements share edges.",
    fields = {
      file,
      { name = "scale", type = "number", above = 0, unit = "m", default = 1, doc = scale.doc },
    },
  },
}
