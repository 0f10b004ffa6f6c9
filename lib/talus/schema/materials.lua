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
        .. " carries "
      .. "tension and shear up to its strength; broken or never bonded, it is a contact with friction.",
    fields = {
      { name = "name", type = "string", default_doc = "`joint 1`, …", doc = "for output and `sim:joint(name)`" },
      { name = "friction", type = "number", least = 0, below = math.pi/2, unit = "rad", default = math.pi/6,
        default_doc = "30 deg", live = true, doc = "friction angle", source = "Mohr–Coulomb" },
      { name = "cohesion", type = "number", least = 0, unit = "Pa", default = 0, live = true, doc = "cohesion" },
      { name = "tension", type = "number", least = 0, unit = "Pa", default = 0, live = true,
        doc = "tensile strength" },
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
    },
  },
  {
    kind = "stiffness", call = "",
    doc = "The stiffness of a joint in full: `stiffness = { per = \"contact\", times_young = 40 }`.",
    fields = {
      { name = "per", type = "enum", values = { "length", "contact" }, default = "length",
        doc = "`length`: value is α in α·E/h; `contact`: a fixed stiffness for each contact and each end of a"
            .. " bond" },
      { name = "value", type = "number", above = 0, unit = "1 or N/m",
        doc = "α, or the stiffness of one contact" },
      { name = "times_young", type = "number", above = 0,
        doc = "per contact, instead of value: multiple of E of the region's material (between regions: of the"
            .. " softest one)" },
    },
  },
}
