-- What holds, moves and loads the regions, contacts between them, and probes.
local name = { name = "name", type = "string", default_doc = "`fix 1`, `load 1`, …",
  doc = "for `sim:fix(name)`, `sim:load(name)`" }
local function region(required, default_doc, doc)
  return { name = "region", type = "region", required = required, default_doc = default_doc, doc = doc }
end
local function on(required, default_doc)
  return { name = "on", type = "on", required = required, default_doc = default_doc,
    doc = "a `talus.line` (boundary edges on it), or sides of the region's box: `\"left\"`, `\"right\"`,"
        .. " `\"top\"`, `\"bottom\"`, one or a list" }
end
local on_point = on(false, "the whole region")
on_point.points = true
on_point.doc = on_point.doc .. ", or a `talus.point` (the region's point nearest to it)"

return {
  {
    kind = "fix", call = "talus.fix", doc = "Holds a region, an edge or a point, or moves it as prescribed. Where two hold the same direction of one place they move it alike.",
    fields = {
      name,
      region(true, nil, "its name, or the region itself"),
      on_point,
      { name = "x", type = "boolean", default_doc = "true unless only y is given", doc = "held along x" },
      { name = "y", type = "boolean", default_doc = "true unless only x is given", doc = "held along y" },
      { name = "displacement", type = "histories", unit = "m", default_doc = "none", live = true,
        doc = "prescribed displacement since the start; 0 along what is not held" },
      { name = "velocity", type = "histories", unit = "m/s", default_doc = "none", live = true,
        doc = "prescribed velocity" },
      { name = "spin", type = "number", unit = "rad/s", default = 0, live = true,
        doc = "prescribed spin of a whole region of one block about its centroid (of several: each about its own); in motion only" },
    },
  },
  {
    kind = "point_load", call = "talus.point_load", doc = "A force on a material point, per metre of thickness.",
    fields = {
      name,
      { name = "at", type = "point", unit = "m", required = true, doc = "where, at the start" },
      region(false, "the one that holds the point; of a held and a free one the free one", "its name, or the region itself"),
      { name = "force", type = "histories", unit = "N", required = true, live = true,
        doc = "force, global directions" },
    },
  },
  {
    kind = "edge_load", call = "talus.edge_load", doc = "A traction on boundary edges, in global directions.",
    fields = {
      name, region(true, nil, "its name, or the region itself"), on(true),
      { name = "traction", type = "histories", unit = "Pa", required = true, live = true, doc = "force per area" },
    },
  },
  {
    kind = "pressure", call = "talus.pressure", doc = "A pressure on boundary edges; it follows the edges.",
    fields = {
      name, region(true, nil, "its name, or the region itself"), on(true),
      { name = "value", type = "history", unit = "Pa", required = true, live = true,
        doc = "pressure, positive towards the rock" },
    },
  },
  {
    kind = "viscous", call = "talus.viscous",
    doc = "Edges that let waves out (Lysmer & Kuhlemeyer 1969): dashpots with the P and S speeds of the rock behind them. While"
      .. " equilibrium is sought (`start = \"settled\"`, static mode) they are held like a fixed edge; what they carry then stays"
      .. " as a constant traction. Dashpots bear no weight: without a settled start, and under loads that come and stay, the"
      .. " region sinks or drifts on them.",
    fields = { region(true, nil, "its name, or the region itself"), on(true) },
  },
  {
    kind = "contact", call = "talus.contact", doc = "The joint property of contacts between two regions.",
    fields = {
      { name = "between", type = "list", of = { type = "region" }, count = 2, required = true,
        doc = "two regions, by name or themselves; the same twice for its own blocks" },
      { name = "joint", type = "object", kinds = { "joint" }, required = true, doc = "property of the contacts" },
    },
  },
  {
    kind = "probe", call = "talus.probe",
    doc = "A material point whose motion and stress are recorded. `{x, y}` alone will do.",
    fields = {
      { name = "at", type = "point", unit = "m", required = true, doc = "where, at the start" },
      region(false, "the one that holds the point; of a held and a free one the free one", "its name, or the region itself"),
    },
  },
}
