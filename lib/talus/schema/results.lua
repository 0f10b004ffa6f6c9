-- What is made of a run afterwards: pictures of one's own, and what a blasting engineer asks for.
local function list(name, doc)
  return { name = name, type = "list", of = { type = "number", gaps = true }, required = true, doc = doc }
end
local regions = { name = "regions", type = "list", of = { type = "region" }, default_doc = "all that are not held",
  doc = "which, by name or themselves" }
local function file(what)
  return { name = "file", type = "string", default_doc = "nothing is written",
    doc = "name, without ending, of " .. what .. " in output.dir" }
end

return {
  {
    kind = "plot", call = "sim:plot(name, …)",
    doc = "A picture of lines or points, `<output.dir>/<name>.svg`: `sim:plot(\"stress_strain\", { x_label = \"ε\", y_label = \"σ\","
      .. " y_unit = \"Pa\", { name = \"left\", x = {…}, y = {…} } })`. Nothing is written where the simulation writes nothing.",
    fields = {
      { name = "series", type = "list", of = { type = "object", kinds = { "series" }, inline = true }, positional = true, nested = true,
        required = true, count = 1, doc = "the lines" },
      { name = "title", type = "string", default = "", default_doc = "none", doc = "above it" },
      { name = "x_label", type = "string", default = "", default_doc = "none", doc = "`_` begins a subscript" },
      { name = "x_unit", type = "string", default = "", default_doc = "none", doc = "\"m\", \"Pa\": shown with the prefix that fits" },
      { name = "y_label", type = "string", default = "", default_doc = "none", doc = "as x_label" },
      { name = "y_unit", type = "string", default = "", default_doc = "none", doc = "as x_unit" },
      { name = "log_x", type = "boolean", default = false, doc = "logarithmic; values <= 0 are left out" },
      { name = "log_y", type = "boolean", default = false, doc = "logarithmic; values <= 0 are left out" },
      { name = "equal", type = "boolean", default = false, doc = "one scale for x and y, as for a section through rock" },
    },
  },
  {
    kind = "series", call = "", doc = "A line of a plot.",
    fields = {
      { name = "name", type = "string", default_doc = "not in the legend", doc = "for the legend" },
      list("x", "values along x; 0/0 interrupts the line"), list("y", "as many along y"),
      { name = "line", type = "boolean", default = true, doc = "points joined" },
      { name = "markers", type = "boolean", default = false, doc = "points marked" },
      { name = "dashed", type = "boolean", default = false, doc = "a dashed line" },
    },
  },
  {
    kind = "distribution", call = "talus.blast.distribution",
    doc = "The size distribution of given pieces, measured ones say, as `talus.blast.fragmentation` makes it of a run's.",
    fields = {
      { name = "sizes", type = "list", of = { type = "number", above = 0 }, count = 1, unit = "m", required = true, doc = "of the pieces" },
      { name = "weights", type = "list", of = { type = "number", above = 0 }, default_doc = "π/4·size², the pieces' areas",
        doc = "area, volume or mass of each, in any unit" },
    },
  },
  {
    kind = "fragmentation", call = "talus.blast.fragmentation(sim, …)",
    doc = "The size distribution of fragments, by area; size √(4A/π). Returns `sizes` (m) and `passing` (part of the area in"
      .. " fragments up to that size), `x20`, `x50`, `x80` (m; between sizes straight in ln x), `count`, `area` (m2), `floor` (m, the"
      .. " same median of single blocks: the mesh lets nothing be finer) and `single` (part of the area in fragments that are one"
      .. " block: the nearer to 1 the more the curve is the mesh's), and from three sizes on `rosin_rammler = { x50, n, residual }`,"
      .. " P = 1 − exp(−ln 2·(x/x50)^n) (Rosin & Rammler 1933), and `swebrec = { x50, xmax, b, residual }`, P = 1/(1 + (ln(xmax/x)/ln(xmax/x50))^b) (Ouchterlony 2005), xmax the"
      .. " largest fragment: least squares in P, weighted by area; residual: root of the mean square, in P.",
    fields = {
      regions,
      { name = "where", type = "function", default_doc = "what is not at a support or viscous edge: rock left in place is no muck",
        doc = "`function(fragment)`, one of `sim.fragments`: whether it counts" },
      file("the table (.csv) and picture (.svg)"),
    },
  },
  {
    kind = "pile", call = "talus.blast.pile(sim, …)",
    doc = "The muck pile as it lies now. Returns the profile `x`, `top`, `ground` (m; cells of `spacing`, at their middles; where nothing lies"
      .. " top = ground); `height` (m, largest top − ground) at `crest`; `toe` (x at which the profile that goes on from the crest ends) and"
      .. " `throw` (m, from the face to it); `shift` ({x, y}, m, of the centroid); `bulk` (m2, between top and ground), `solid` (m2, area of"
      .. " the blocks), `swell` (bulk/solid); `cast` (part of the solid area beyond the line); `farthest` ({block, x, distance} from the face)"
      .. " and `highest` (sim.highest, of the whole run).",
    fields = {
      regions,
      { name = "moved", type = "number", least = 0, unit = "m", default = 0, doc = "only blocks that have moved as far as this" },
      { name = "where", type = "function", default_doc = "all", doc = "`function(block)`: whether it belongs to the pile" },
      { name = "ground", type = "any", of = { { type = "number", unit = "m" }, { type = "function" } },
        default_doc = "the top of the other blocks; where there are none, the lowest corner of the pile",
        doc = "height of the ground, a number or `function(x)`" },
      { name = "direction", type = "enum", values = { 1, -1 }, default_doc = "that of the centroid's shift", doc = "of the throw, along x" },
      { name = "face", type = "number", unit = "m", default_doc = "the end of the regions' outlines in that direction",
        doc = "x from which throw is counted" },
      { name = "line", type = "number", unit = "m", default_doc = "the face", doc = "x beyond which rock counts as cast" },
      { name = "spacing", type = "number", above = 0, unit = "m", default_doc = "1/400 of the pile's length", doc = "of the profile" },
      file("the profile (.csv) and picture (.svg)"),
    },
  },
  {
    kind = "vibration", call = "talus.blast.vibration(sim, …)",
    doc = "Peak particle velocity at the probes, the largest |v| after any step, over the scaled distance R/√W, and PPV = K (R/√W)^-β by a"
      .. " straight line through the logarithms (Duvall & Fogelson 1962). Returns `points`, a list of `{ name, distance, scaled, ppv, time }`, nearest first, `K`,"
      .. " `beta`, `residual` (root mean square of ln PPV). Waves of a plane scene spread as from a line of holes: β is smaller than in the field.",
    fields = {
      { name = "at", type = "any", of = { { type = "string" }, { type = "point", unit = "m" } }, default_doc = "the first charge",
        doc = "where R is counted from: a charge's name or a point" },
      { name = "mass", type = "number", above = 0, unit = "kg",
        default_doc = "that of the charge R is counted from, where it is given by an explosive; else 1, which leaves R as it is",
        doc = "W, charge per delay (and metre)" },
      { name = "probes", type = "list", of = { type = "string" }, default_doc = "all", doc = "which" },
      file("the table (.csv) and picture (.svg)"),
    },
  },
  {
    kind = "backbreak", call = "talus.blast.backbreak(sim, …)",
    doc = "Damage behind a line, by where joints lay at the start. Returns `length`, `tension`, `shear` (m of failed bonds), `area` (m2 of the"
      .. " blocks beside them), `depth` (m, of the farthest behind the line).",
    fields = {
      { name = "line", type = "any", of = { { type = "number", unit = "m" }, { type = "object", kinds = { "line" } } }, required = true,
        doc = "an upright line at this x, or a `talus.line`" },
      { name = "behind", type = "enum", values = { "left", "right" }, default = "left",
        doc = "the side of the line that is behind: of a `talus.line` as seen along it, of an upright one as seen upwards" },
      regions,
      file("the table (.csv) and picture (.svg) of the length of failed bonds over their least distance behind the line"),
    },
  },
}
