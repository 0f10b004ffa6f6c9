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
      { name = "delay_scatter", type = "number", least = 0, unit = "s", default_doc = "none",
        doc = "standard deviation of the delay, normally distributed; what would come before 0 comes at 0. `sim.charges[1].delay` is the"
          .. " delay that came out" },
      { name = "seed", type = "integer", least = 0, most = 4294967295, default = 1,
        doc = "of the scatter; the same seed gives the charges of a scene the same delays, each its own" },
      { name = "explosive", type = "any",
        of = { { type = "enum", values = { "TNT", "ANFO", "emulsion" } }, { type = "object", kinds = { "explosive" }, inline = true } },
        doc = "what it is, by name or by its constants: its gas is on the isentrope of JWL (`talus.eos.jwl`). This or `eos`" },
      { name = "density", type = "number", above = 0, unit = "kg/m3", default_doc = "that of the explosive's constants",
        doc = "of the explosive as it is loaded: it begins at as much more room for its mass" },
      { name = "diameter", type = "number", above = 0, unit = "m", default_doc = "it fills the hole",
        doc = "of the explosive, at most the hole's; the rest of the hole is empty (decoupling)" },
      { name = "eos", type = "any",
        of = { { type = "function" }, { type = "object", kinds = { "polytropic", "jwl" } } },
        doc = "a `talus.eos`, or `function(v, t, chamber)` that returns the pressure (Pa) at v = V/V0, V0 the volume of the hole when it"
          .. " goes off: > 0, and falling as v grows; t seconds after that. This or `explosive`. The gas's work in a step is by the law"
          .. " at the middle of the step. Chamber: {name, volume, first_volume (m3 per metre), pressure (Pa), front (m)}, as it was at"
          .. " the beginning of the step; tried with 1 m3 under 1 MPa, from v = 1 to 10 000. That the pressure"
          .. " falls is seen to in the run too. Where rock has closed in on the gas (v < 1) the law is asked for v = 1" },
      { name = "gas_speed", type = "any", of = { { type = "number", least = 0, unit = "m/s" }, { type = "function" } },
        default = 100, doc = "of the gas in cracks: a number or `function(t, chamber)`, t seconds after it went off; the gas has come as"
          .. " far from the hole's centre as ∫ speed dt, and is at the wall before that; of gas that has met, as with venting", source = "Ning et al. 2011" },
      { name = "venting", type = "any", of = { { type = "function" }, { type = "object", kinds = { "orifice" } } },
        default_doc = "the pressure is gone at once",
        doc = "a `talus.venting.orifice`, or `function(t, chamber)` that returns the part of the pressure left, t seconds after the gas"
          .. " has reached a free surface, or has thrown out the stemming. Where gas of several charges has met, what the charge says that"
          .. " went off first, or of those at one time the first in the list, holds for all of it" },
      { name = "stemming", type = "object", kinds = { "stemming" }, default_doc = "the collar stays closed",
        doc = "what closes the hole: the chamber vents when it is out" },
    },
  },
  {
    kind = "stemming", call = "talus.stemming",
    doc = "A column of broken rock in the collar of a hole, which runs out of the plane. The gas pushes it, only its inertia holds it: x'' ="
      .. " P/(ρL). At x = L it is out, and the chamber vents as the charge's `venting` says. Friction along the hole and what the gas gains in"
      .. " room behind the column are left out: it holds a little longer than this.",
    fields = {
      { name = "length", type = "number", above = 0, unit = "m", required = true, doc = "L" },
      { name = "density", type = "number", above = 0, unit = "kg/m3", default = 1600, doc = "ρ, of the column with its pores",
        source = "dry crushed rock: 2700 kg/m3 with 40 % of pores" },
      { name = "charge_length", type = "number", above = 0, unit = "m", default_doc = "none",
        doc = "of the loaded part of the hole, whose gas the collar lets out through the area of the hole; required beside an orifice"
          .. " without an `opening`" },
    },
  },
  {
    kind = "explosive", call = "",
    doc = "The constants of an explosive, as `talus.explosives` has them for some.",
    fields = {
      { name = "density", type = "number", above = 0, unit = "kg/m3", required = true, doc = "at which the constants hold" },
      { name = "A", type = "number", above = 0, unit = "Pa", required = true, doc = "A" },
      { name = "B", type = "number", above = 0, unit = "Pa", required = true, doc = "B" },
      { name = "R1", type = "number", above = 0, required = true, doc = "R1" },
      { name = "R2", type = "number", above = 0, required = true, doc = "R2" },
      { name = "omega", type = "number", above = 0, required = true, doc = "ω" },
      { name = "E", type = "number", above = 0, unit = "J/m3", required = true, doc = "energy per volume of explosive" },
    },
  },
  {
    kind = "orifice", call = "talus.venting.orifice",
    doc = "The gas flows out as an ideal gas through a nozzle, isentropic: choked as long as outside/inside ≤ (2/(γ+1))^(γ/(γ-1)), slower"
      .. " after that, and ends at the atmosphere's pressure, after which it presses no more. What is left follows the same law in as"
      .. " much more room.",
    fields = {
      { name = "coefficient", type = "number", above = 0, most = 1, default = 0.84, doc = "of discharge",
        source = "Perry 1949: 0.84, sharp edges, choked" },
      { name = "opening", type = "number", least = 0, unit = "m", default_doc = "the apertures of the joints that the gas has come"
        .. " through, where they end at free surfaces, summed", doc = "width of what the gas leaves through" },
      { name = "density", type = "number", above = 0, unit = "kg/m3", default_doc = "the mass of the explosive in the area of the hole",
        doc = "of the gas in the hole when the charge goes off; required beside an `eos`" },
      { name = "gamma", type = "number", above = 1, most = 10, default_doc = "that of the polytropic gas, 1 + ω of JWL, 1.4 of a function",
        doc = "γ of the gas as it leaves" },
      { name = "atmosphere", type = "number", above = 0, unit = "Pa", default = 101325, doc = "pressure outside" },
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
