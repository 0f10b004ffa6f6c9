-- Charges and the gas they give.
return {
  {
    kind = "charge", call = "talus.charge",
    doc = "An explosive in a hole of a region. Its gas presses on the hole's wall and enters the failed joints that hang"
      .. " together with it, as far as its front has got; it vents where it reaches a free surface.",
    fields = {
      { name = "name", type = "string", default_doc = "`charge 1`, …", doc = "for output" },
      { name = "region", type = "region", default_doc = "the only region with such a hole", doc = "the region of the hole" },
      { name = "hole", type = "string", required = true, doc = "the hole's name" },
      { name = "delay", type = "number", least = 0, unit = "s", default = 0, doc = "time at which it goes off" },
      { name = "eos", type = "any", required = true,
        of = { { type = "function" }, { type = "object", kinds = { "polytropic", "jwl" } } },
        doc = "a `talus.eos`, or `function(v)` that returns the pressure (Pa) at v = V/V0, V0 the volume of the hole when it"
          .. " goes off: > 0, and falling as v grows" },
      { name = "gas_speed", type = "any", of = { { type = "number", least = 0, unit = "m/s" }, { type = "function" } },
        default = 100, doc = "of the gas in cracks: a number or `function(t)`, t seconds after it went off; the gas has come as"
          .. " far from the hole's centre as ∫ speed dt, and is at the wall before that", source = "Ning et al. 2011" },
      { name = "venting", type = "function", default_doc = "the pressure is gone at once",
        doc = "`function(t)` that returns the part of the pressure left, t seconds after the gas has reached a free surface" },
    },
  },
  {
    kind = "polytropic", call = "talus.eos.polytropic", doc = "P = P0 (V0/V)^γ.",
    fields = {
      { name = "pressure", type = "number", above = 0, unit = "Pa", required = true, doc = "P0" },
      { name = "gamma", type = "number", above = 0, most = 10, default = 1.4, doc = "γ", source = "Ning et al. 2011: 1.4" },
    },
  },
  {
    kind = "jwl", call = "talus.eos.jwl",
    doc = "The isentrope of Jones, Wilkins and Lee: P = A e^(-R1 w) + B e^(-R2 w) + C w^-(1+ω), C = ω (E - A/R1 e^-R1 - B/R2"
      .. " e^-R2), w the volume over that of the explosive. `talus.explosives` has constants.",
    fields = {
      { name = "explosive", type = "enum", values = { "TNT", "ANFO", "emulsion" }, default_doc = "the constants below",
        doc = "ready-made constants" },
      { name = "A", type = "number", above = 0, unit = "Pa", doc = "A" },
      { name = "B", type = "number", above = 0, unit = "Pa", doc = "B" },
      { name = "R1", type = "number", above = 0, doc = "R1" },
      { name = "R2", type = "number", above = 0, doc = "R2" },
      { name = "omega", type = "number", above = 0, doc = "ω" },
      { name = "E", type = "number", above = 0, unit = "J/m3", doc = "energy per volume of explosive" },
      { name = "filled", type = "number", above = 0, most = 1, default = 1,
        doc = "part of the hole's area that the explosive fills (decoupling): w = v/filled" },
    },
  },
}
