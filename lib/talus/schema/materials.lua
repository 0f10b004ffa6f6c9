-- Materials and the properties of joints.
return {
  {
    kind = "material", call = "talus.material", doc = "What blocks are made of: isotropic and linearly elastic.",
    fields = {
      { name = "name", type = "string", default_doc = "`material 1`, …",
        doc = "for output and `sim:material(name)`" },
      { name = "density", type = "number", above = 0, unit = "kg/m3", required = true, live = true,
        doc = "mass per volume" },
      { name = "young", type = "number", above = 0, unit = "Pa", required = true, live = true,
        doc = "Young's modulus E" },
      { name = "poisson", type = "number", least = 0, below = 0.5, required = true, live = true,
        doc = "Poisson's ratio" },
      { name = "plane", type = "enum", values = { "stress", "strain" }, default = "stress",
        doc = "plane stress or plane strain, for 1 m thickness" },
    },
  },
  {
    kind = "joint", call = "talus.joint",
    doc = "Properties of an interface: of the bonds between the blocks of a region and of contacts. Bonded, it"
        .. " carries tension and shear up to its strength; bonds of a joint that gives neither `tension` nor `cohesion`"
        .. " never fail. Broken or never bonded, it is a contact with friction.",
    fields = {
      { name = "name", type = "string", default_doc = "`joint 1`, …", doc = "for output and `sim:joint(name)`" },
      { name = "friction", type = "number", least = 0, below = math.pi/2, unit = "rad", default = math.pi/6,
        default_doc = "30 deg", live = true, doc = "friction angle", source = "Mohr–Coulomb" },
      { name = "cohesion", type = "number", least = 0, unit = "Pa", default = 0, live = true,
        doc = "cohesion of bonds and of traces; required beside tension, unless a criterion judges. Other contacts carry friction alone" },
      { name = "tension", type = "number", least = 0, unit = "Pa", default_doc = "cohesion/tan(friction) where cohesion is given", live = true,
        doc = "tensile strength of bonds; without it Mohr–Coulomb's line goes on to where it ends. What is no bond carries none" },
      { name = "residual", type = "object", kinds = { "residual" }, inline = true,
        default_doc = "friction kept, cohesion 0.05 MPa (or the joint's own, if less), no tension",
        doc = "what a failed bond still carries, at once", source = "Ning et al. 2011" },
      { name = "reduction", type = "any",
        of = { { type = "function" },
               { type = "object", kinds = { "softening", "slip_weakening", "barton_bandis" } } },
        doc = "instead of residual: a `talus.laws`, or `function(intact, slip, opening, normal)` that returns what a failed"
          .. " bond still carries, `{ friction = …, cohesion = …, tension = … }`, after the largest slip and opening so far"
          .. " (m) under the normal traction (Pa); a field left out is 0, friction that of `intact`" },
      { name = "criterion", type = "function",
        default_doc = "maximum tension and Mohr–Coulomb on the mean traction of the edge",
        doc = "`function(t)` that returns how far a bond's strength is used; it fails at 1. `t` has the tractions `normal`"
          .. " (tension positive) and `shear`, and the strengths `tension`, `cohesion` (Pa), `friction` (rad); where it asks for them,"
          .. " also the bond's `id` (as in `sim.joints`), `length` (m, at the start), `x`, `y` (m, of its middle now), `dip` (rad, of"
          .. " its edge against +x, above −π/2 to π/2) and `property` (name of its talus.joint); tried with a bond of length 1 at (0, 0)."
          .. " It leaves the strengths in `t` as they are. The answer is finite and >= 0, best in proportion to the traction: static load"
          .. " increments are found by it. Whether the bond fails in tension or in shear is not the criterion's to say: tension, where it"
          .. " pulls at least as hard as it shears", source = "Ning et al. 2011, eq. 1–2" },
      { name = "scatter", type = "object", kinds = { "weibull" }, doc = "of the strength from bond to bond" },
      { name = "bond", type = "enum", values = { "exact", "spring" }, default = "exact",
        doc = "how intact bonds are held: `exact` (consistent flux plus penalty, no joint compliance) or `spring` "
          .. "(springs at the ends of an edge)", source = "exact: Nitsche 1971; spring: Ning et al. 2011" },
      { name = "penalty", type = "number", above = 1, default = 1.1, live = true,
        doc = "exact bonds: multiple of the least stiffness that is positive definite by proof" },
      { name = "stiffness", type = "any", of = {
          { type = "number", above = 0 }, { type = "object", kinds = { "stiffness" }, inline = true } },
        default = 100, live = true,
        doc = "normal stiffness of contacts and spring bonds: a number α for α·E/h per length, h the size of the"
            .. " blocks, "
          .. "or a `stiffness` table",
            source = "stiff against a block and harmless to the condition; per contact: Shi 1988" },
      { name = "shear_ratio", type = "number", above = 0, most = 10, default = 0.4, live = true,
        doc = "shear stiffness / normal stiffness", source = "Shi 1988: 1/2.5" },
      { name = "restitution", type = "number", least = 0, most = 1, default = 1, live = true,
        doc = "normal restitution of contacts, the most they give back: what has met at a speed v parts at no more than this part of v. 1:"
          .. " what the step leaves, by itself a third of v where it is long beside the contact's period (theory, § 3); what this takes is damping"
          .. " in the energy ledger", source = "Newton's law of impact" },
    },
  },
  {
    kind = "residual", call = "", doc = "What a failed bond still carries.",
    fields = {
      { name = "friction", type = "number", least = 0, below = math.pi/2, unit = "rad",
        default_doc = "that of the joint", doc = "friction angle" },
      { name = "cohesion", type = "number", least = 0, unit = "Pa", default_doc = "0.05 MPa, or the joint's own if less",
        doc = "for the roughness of the crack" },
      { name = "tension", type = "number", least = 0, unit = "Pa", default = 0, doc = "tensile strength" },
    },
  },
  {
    kind = "softening", call = "talus.laws.softening",
    doc = "A failed bond softens as it opens and slides: with r = opening/δ_I + slip/δ_II tension and cohesion fall"
      .. " to the part 1 - r (linear) or exp(-r) (exponential) of what they were above the residual; δ follows from the"
      .. " fracture energies. Along a tracked crack in tension a bond holds no more than the traction that it failed with.",
    fields = {
      { name = "shape", type = "enum", values = { "linear", "exponential" }, default = "linear", doc = "of the curve" },
      { name = "G_I", type = "number", above = 0, unit = "J/m2", required = true, doc = "fracture energy in tension" },
      { name = "G_II", type = "number", above = 0, unit = "J/m2", default_doc = "as G_I",
        doc = "fracture energy in shear, above residual cohesion and friction" },
      { name = "residual", type = "object", kinds = { "residual" }, inline = true, default_doc = "as for a joint",
        doc = "what is left in the end" },
    },
  },
  {
    kind = "slip_weakening", call = "talus.laws.slip_weakening",
    doc = "A failed bond loses its tension at once; cohesion and friction fall linearly with slip.",
    fields = {
      { name = "distance", type = "number", above = 0, unit = "m", required = true, doc = "slip at which the residual is reached" },
      { name = "residual", type = "object", kinds = { "residual" }, inline = true, default_doc = "as for a joint",
        doc = "what is left in the end" },
    },
  },
  {
    kind = "barton_bandis", call = "talus.laws.barton_bandis",
    doc = "A rough crack: friction angle φ_r + JRC log10(JCS/σ_n) under the normal pressure σ_n, no cohesion, no tension.",
    fields = {
      { name = "jrc", type = "number", least = 0, most = 20, required = true, doc = "joint roughness coefficient" },
      { name = "jcs", type = "number", above = 0, unit = "Pa", required = true, doc = "joint wall compressive strength" },
      { name = "friction", type = "number", least = 0, below = math.pi/2, unit = "rad", default_doc = "that of the joint",
        doc = "residual friction angle φ_r" },
    },
  },
  {
    kind = "hoek_brown", call = "talus.laws.hoek_brown", returns = "table<string, number>",
    doc = "Strengths of a joint after Hoek and Brown's criterion: returns `{ friction, cohesion, tension }`, fields for talus.joint."
      .. " Friction and cohesion are those of the straight line that fits σ1 over σ3 best (least squares) from the tensile strength to"
      .. " `confinement`; tension is where the curve ends.",
    fields = {
      { name = "ucs", type = "number", above = 0, unit = "Pa", required = true, doc = "uniaxial compressive strength of the intact rock",
        source = "Hoek, Carranza-Torres & Corkum 2002" },
      { name = "mi", type = "number", above = 0, required = true, doc = "constant of the intact rock, about 4 to 33" },
      { name = "gsi", type = "number", least = 0, most = 100, default = 100, doc = "geological strength index; 100: intact rock" },
      { name = "disturbance", type = "number", least = 0, most = 1, default = 0, doc = "D, by blasting and relaxation" },
      { name = "confinement", type = "number", above = 0, unit = "Pa", default_doc = "ucs/4", doc = "the largest σ3 that the line is for" },
    },
  },
  {
    kind = "weibull", call = "talus.laws.weibull",
    doc = "Strengths of bonds scattered by Weibull's distribution about those of the joint, their mean.",
    fields = {
      { name = "modulus", type = "number", least = 1, most = 1000, required = true, doc = "shape; scatter about 1.2/modulus" },
      { name = "seed", type = "integer", least = 0, most = 4294967295, default = 1, doc = "the same seed gives the same strengths" },
    },
  },
  {
    kind = "stiffness", call = "",
    doc = "The stiffness of a joint in full: `stiffness = { per = \"area\", value = 100*u.GPa }`.",
    fields = {
      { name = "per", type = "enum", values = { "length", "area", "contact" }, default = "length",
        doc = "`length`: value is α in α·E/h; `area`: k_n of a rock joint, whatever the blocks; `contact`: a fixed stiffness"
            .. " for each contact and each end of a bond",
        source = "area: Goodman, Taylor & Brekke 1968" },
      { name = "value", type = "number", above = 0, unit = "1, Pa/m or N/m",
        doc = "α, k_n (fresh joints: 10 to 1000 GPa/m, more where pressed harder, Bandis, Lumsden & Barton 1983), or the stiffness of one contact" },
      { name = "times_young", type = "number", above = 0,
        doc = "per contact, instead of value: multiple of E of the region's material (between regions: of the"
            .. " softest one)" },
    },
  },
}
