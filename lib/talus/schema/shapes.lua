-- Points, lines, outlines, and mesh sizes. Lengths in m.
local points = { type = "point", unit = "m" }
local hole_name = { name = "name", type = "string", default_doc = "none",
  doc = "for holes: what `talus.grade` calls it" }

return {
  {
    kind = "outline", call = "talus.polygon",
    doc = "A simple polygon: `talus.polygon { {0, 0}, {2, 0}, {1, 1} }`.",
    fields = {
      { name = "points", type = "list", of = points, count = 3, positional = true, required = true,
        doc = "corners in order, either way round" },
      hole_name,
    },
  },
  {
    kind = "rect", call = "talus.rect",
    doc = "A rectangle by two opposite corners: `talus.rect(x1, y1, x2, y2 [, name])`. The result is an outline.",
    fields = {
      { name = "from", type = "point", unit = "m", required = true, doc = "x1, y1" },
      { name = "to", type = "point", unit = "m", required = true, doc = "x2, y2" },
      hole_name,
    },
  },
  {
    kind = "circle", call = "talus.circle",
    doc = "A regular polygon with its corners on a circle. The result is an outline.",
    fields = {
      { name = "at", type = "point", unit = "m", required = true, doc = "centre" },
      { name = "radius", type = "number", above = 0, unit = "m", required = true, doc = "radius" },
      { name = "sides", type = "integer", least = 3, most = 10000, default = 32, doc = "number of sides" },
      hole_name,
    },
  },
  {
    kind = "line", call = "talus.line",
    doc = "A segment: `talus.line(x1, y1, x2, y2)` or `talus.segment({x1, y1}, {x2, y2})`.",
    fields = {
      { name = "from", type = "point", unit = "m", required = true, doc = "one end" },
      { name = "to", type = "point", unit = "m", required = true, doc = "the other end" },
    },
  },
  {
    kind = "point", call = "talus.point", doc = "A point: `talus.point(x, y)`.",
    fields = { { name = "at", type = "point", unit = "m", required = true, doc = "where" } },
  },
  {
    kind = "running_bond", call = "talus.running_bond",
    doc = "Outlines of the bricks of a wall, every other course shifted by half a brick, for `blocks` of a"
        .. " region. "
      .. "The shifted courses end in half bricks.",
    fields = {
      { name = "at", type = "point", unit = "m", required = true, doc = "lower left corner" },
      { name = "courses", type = "integer", least = 1, most = 10000, required = true, doc = "layers of bricks" },
      { name = "per_course", type = "integer", least = 1, most = 10000, required = true,
        doc = "bricks in a full layer" },
      { name = "length", type = "number", above = 0, unit = "m", required = true, doc = "of a brick, along x" },
      { name = "height", type = "number", above = 0, unit = "m", required = true, doc = "of a brick, along y" },
    },
  },
  {
    kind = "grade", call = "talus.grade",
    doc = "A mesh size that grows linearly away from some places: "
      .. "`talus.grade { { at = \"hole\", size = 0.05 }, far = 0.4 }`.",
    fields = {
      { name = "sources", type = "list", of = { type = "object", kinds = { "grade_source" }, inline = true },
        count = 1,
        positional = true, required = true, doc = "where the mesh is fine" },
      { name = "far", type = "number", above = 0, unit = "m", required = true,
        doc = "size away from all of them" },
    },
  },
  {
    kind = "grade_source", call = "", doc = "One fine place of a `talus.grade`.",
    fields = {
      { name = "at", type = "place", required = true,
        doc = "where: a point or a line, a bent line as a list of points, a trace or the edge of an outline; or the name"
            .. " of a hole or a trace of the region" },
      { name = "size", type = "number", above = 0, unit = "m", required = true, doc = "size there" },
      { name = "reach", type = "number", above = 0, unit = "m", default_doc = "(far - size)/0.3",
        doc = "distance over which the size grows to `far`", source = "0.3 m per m keeps neighbours alike" },
    },
  },
}
