-- Regions and how they are divided into blocks.
local property = { type = "object", kinds = { "joint" } }
local function joint_field(default_doc, doc)
  return { name = "joint", type = property.type, kinds = property.kinds, default_doc = default_doc, doc = doc }
end
local bonded = { name = "bonded", type = "boolean", default = false,
  doc = "glued with the strength of the joint; otherwise the blocks touch by contact" }

return {
  {
    kind = "region", call = "talus.region",
    doc = "A part of the scene: an outline, whole, cut by joints or meshed into blocks; or a set of ready blocks.",
    fields = {
      { name = "name", type = "string", default_doc = "`region 1`, …", doc = "what fixities and loads call it" },
      { name = "outline", type = "outline", doc = "the region's outline" },
      { name = "blocks", type = "list", of = { type = "outline" }, count = 1,
        doc = "instead of outline: one outline for each block" },
      { name = "bonded", type = "boolean", default = false,
        doc = "of ready blocks: those that share a whole edge, corners at the same place to a 1e-9th of the region, are bonded there like those"
            .. " of a mesh" },
      { name = "holes", type = "list", of = { type = "outline" },
        doc = "outlines of holes; a name is given by the shape. Of bonded ready blocks: where they leave a hole for a charge, its corners those of"
            .. " the blocks round it" },
      { name = "material", type = "object", kinds = { "material" }, required = true, doc = "what it is made of" },
      joint_field("`contact` of the simulation", "of its bonds and of contacts between its own blocks"),
      { name = "mesh", type = "object", kinds = { "mesh" }, inline = true, default_doc = "not meshed",
        doc = "how it is divided into bonded blocks" },
      { name = "cuts", type = "list", of = { type = "object", kinds = { "trace", "joint_set" } }, nested = true,
        doc = "joints that cut it; lists of traces as from a file may stand among them" },
      { name = "slivers", type = "enum", values = { "merge", "refuse", "keep" }, default = "merge",
        doc = "blocks that cuts leave thinner than sliver_part: joined to a neighbour, with shorter edges closed;"
            .. " refused; or kept. A note says how many; triangles of a mesh are not merged" },
      { name = "sliver_part", type = "number", least = 0, most = 0.2, default = 0.02,
        doc = "of the mesh size, or of the square root of the mean block area where there is no mesh; a block's"
            .. " thickness is 2·area/perimeter",
        source = "stiffness goes with 1/thickness: 50 times that of other blocks" },
      { name = "order", type = "order", values = { 1, 2, "rigid" }, default = 1,
        doc = "`1`: blocks deform with constant strain (6 unknowns); `2`: with a strain that varies linearly (12);"
            .. " `\"rigid\"`: not at all (3). A function of the centroid's x and y gives each block its own. Contacts follow the edges of a block of 2 as"
            .. " they bend; where anything may touch these have corners in their middles, and more where they are slender" },
      { name = "held", type = "boolean", default = false,
        doc = "fixed as a whole: no unknowns; moves only by a `talus.fix` with a motion" },
      { name = "velocity", type = "vector", unit = "m/s", default = { 0, 0 }, doc = "at the start" },
      { name = "spin", type = "number", unit = "rad/s", default = 0, doc = "at the start, counter-clockwise" },
      { name = "spin_centre", type = "point", unit = "m", default_doc = "the region's centroid",
        doc = "centre of spin" },
      { name = "stress", type = "object", kinds = { "stress" }, inline = true, default_doc = "none",
        doc = "at the start" },
      { name = "body_force", type = "histories", unit = "N/m3", default = { 0, 0 },
        doc = "force per volume, beside gravity" },
    },
  },
  {
    kind = "mesh", call = "",
    doc = "How a region is divided. A region with `nx`, `ny` must be a rectangle without holes and cuts.",
    fields = {
      { name = "kind", type = "enum", values = { "triangles", "voronoi", "cross", "diagonal", "alternating" },
        default = "triangles",
        doc = "`triangles`: unstructured; `voronoi`: convex grains; `cross`: rectangles cut by both diagonals; `diagonal`, `alternating`:"
            .. " by one" },
      { name = "size", type = "size",
        doc = "wanted length of edges, of grains the square root of their mean area: a number, a `talus.grade` or a"
            .. " function of x and y" },
      { name = "seed", type = "integer", least = 0, most = 4294967295, default = 1,
        doc = "`voronoi`: of the places of the grains; the same seed gives the same grains" },
      { name = "nx", type = "integer", least = 1, most = 100000,
        doc = "patterns, instead of size: rectangles along x" },
      { name = "ny", type = "integer", least = 1, most = 100000,
        doc = "patterns, instead of size: rectangles along y" },
    },
  },
  {
    kind = "trace", call = "talus.trace", doc = "A joint that cuts its region, straight or bent.",
    fields = {
      { name = "points", type = "polyline", required = true, doc = "two or more points, or a `talus.line`" },
      { name = "name", type = "string", default_doc = "none", doc = "what `talus.grade` calls it" },
      joint_field("the region's joint", "property of its faces, whatever of the region slides along them"),
      bonded,
    },
  },
  {
    kind = "joint_set", call = "talus.joint_set", doc = "Parallel joints that cut their region.",
    fields = {
      { name = "dip", type = "number", least = -2*math.pi, most = 2*math.pi, unit = "rad", required = true,
        doc = "angle of the joints against +x, counter-clockwise" },
      { name = "spacing", type = "number", above = 0, unit = "m", required = true,
        doc = "distance between joints, normal to them" },
      { name = "persistence", type = "number", above = 0, most = 1, default = 1,
        doc = "jointed part of a line's length: trace_length/(trace_length + gap), of which two give the third" },
      { name = "trace_length", type = "number", above = 0, unit = "m",
        doc = "length of a jointed part, where persistence < 1" },
      { name = "gap", type = "number", above = 0, unit = "m", default_doc = "from persistence",
        doc = "length of the rock bridge between two jointed parts of a line" },
      { name = "trace_length_scatter", type = "number", least = 0, below = 1, default = 0,
        doc = "relative scatter of trace_length, uniform" },
      { name = "gap_scatter", type = "number", least = 0, below = 1, default = 0,
        doc = "relative scatter of gap, uniform" },
      { name = "spacing_scatter", type = "number", least = 0, below = 1, default = 0,
        doc = "relative scatter of the spacing, uniform" },
      { name = "dip_scatter", type = "number", least = 0, most = math.pi/4, unit = "rad", default = 0,
        doc = "scatter of the dip, uniform" },
      { name = "through", type = "point", unit = "m", default_doc = "centre of the region's box",
        doc = "a point on one of the joints" },
      { name = "seed", type = "integer", least = 0, most = 4294967295, default = 1,
        doc = "of the scatter; the same seed gives the same joints" },
      joint_field("the region's joint", "property of the interfaces"),
      bonded,
    },
  },
  {
    kind = "stress", call = "",
    doc = "Initial stress of a region: value + gradient_x·x + gradient_y·y, tension positive.",
    fields = {
      { name = "sxx", type = "number", unit = "Pa", default = 0, doc = "at the origin" },
      { name = "syy", type = "number", unit = "Pa", default = 0, doc = "at the origin" },
      { name = "sxy", type = "number", unit = "Pa", default = 0, doc = "at the origin" },
      { name = "gradient_x", type = "triple", unit = "Pa/m", default = { 0, 0, 0 }, doc = "change along x" },
      { name = "gradient_y", type = "triple", unit = "Pa/m", default = { 0, 0, 0 }, doc = "change along y" },
    },
  },
}
