-- The simulation: what it is made of, time, numerics and output.
local probe = { type = "object", kinds = { "probe" }, inline = true }
local picture = { type = "object", kinds = { "picture" }, inline = true }

return {
  {
    kind = "simulation", call = "talus.simulation",
    doc = "Puts a scene together and builds it. A simulation that the script does not step is run by the program"
        .. " when "
      .. "the script has ended.",
    fields = {
      { name = "title", type = "string", default_doc = "the script's name, without folder and `.lua`",
        doc = "for output" },
      { name = "regions", type = "list", of = { type = "object", kinds = { "region" } }, count = 1,
        required = true, doc = "the regions" },
      { name = "gravity", type = "vector", unit = "m/s2", default = { 0, 0 }, doc = "acceleration of gravity" },
      { name = "contact", type = "object", kinds = { "joint" }, default_doc = "a joint with its defaults",
        doc = "property of contacts between regions" },
      { name = "contacts", type = "list", of = { type = "object", kinds = { "contact" } },
        doc = "rules for pairs of regions, one a pair" },
      { name = "fix", type = "list", of = { type = "object", kinds = { "fix" } }, doc = "what is held or moved" },
      { name = "loads", type = "list", of = { type = "object", kinds = { "point_load", "edge_load", "pressure" } },
        doc = "loads" },
      { name = "boundaries", type = "list", of = { type = "object", kinds = { "viscous" } },
        doc = "edges that let waves out" },
      { name = "charges", type = "list", of = { type = "object", kinds = { "charge" } },
        doc = "explosives in holes; dynamic mode" },
      { name = "probes", type = "map",
        of = { type = "any", of = { probe, { type = "point", unit = "m" } } },
        doc = "`{ tip = {7.9, 0.5} }`" },
      { name = "time", type = "object", kinds = { "time" }, inline = true, required = true,
        doc = "how far and how" },
      { name = "numerics", type = "object", kinds = { "numerics" }, inline = true,
        default_doc = "`talus.profile.default`", doc = "choices of method" },
      { name = "fracture", type = "object", kinds = { "fracture" }, inline = true, default_doc = "its defaults",
        doc = "how bonds fail" },
      { name = "output", type = "object", kinds = { "output" }, inline = true, default_doc = "nothing is written",
        doc = "what is written" },
      { name = "on_step", type = "function", doc = "`function(sim)`, called once after each accepted step" },
      { name = "on_fracture", type = "function",
        doc = "`function(sim, cracks)`, called after a step in which bonds failed, before on_step: a list of `{ joint, mode ="
          .. " \"tension\" or \"shear\", kind = \"initiated\", \"propagated\" or \"coalesced\", x, y, length, time, normal, shear,"
          .. " utilisation }`, tractions in Pa" },
      { name = "on_gas", type = "function",
        doc = "`function(sim, events)`, called after a step in which a charge went off, a chamber vented or two met: a list of"
          .. " `{ kind = \"detonation\", \"venting\" or \"merging\", charge, other, time, volume, pressure, by, x, y }`, by ="
          .. " \"surface\" or \"stemming\" what a chamber vents through, x, y (m) where: the point of the free surface that its gas has"
          .. " come to, or the middle of the hole; volume (m3/m) and pressure (Pa) of the chamber before it vents, and after two have met" },
      { name = "stop", type = "function",
        doc = "`function(sim)`, called after each accepted step, after on_step: the run ends where it returns true" },
      { name = "on_output", type = "function",
        doc = "`function(sim)`, called after each output time was written" },
      { name = "max_blocks", type = "integer", least = 1, default = 200000,
        doc = "a mesh that would give more is refused" },
    },
  },
  {
    kind = "time", call = "", doc = "Time control of a simulation.",
    fields = {
      { name = "mode", type = "enum", values = { "dynamic", "static" }, default = "dynamic",
        doc = "`static` solves for equilibrium" },
      { name = "t_end", type = "number", least = 0, unit = "s", default = 1,
        default_doc = "static: 1; dynamic: required",
        doc = "end, > 0 in dynamic mode; static: load histories run from 0 to it, and velocities of a `fix` act so long" },
      { name = "steps", type = "integer", least = 1, most = 1000000, default = 1,
        doc = "static: load steps; where bonds can fail, or what is held moves by more than displacement_ratio in one, more are put between them" },
      { name = "dt", type = "number", above = 0, unit = "s", default_doc = "automatic", doc = "fixed time step" },
      { name = "dt_min", type = "number", above = 0, unit = "s", default_doc = "1e-6 of the first step",
        doc = "least step; below it the run stops with an error" },
      { name = "dt_max", type = "number", above = 0, unit = "s", default_doc = "t_end/10", doc = "largest step" },
      { name = "tolerance", type = "number", above = 0, most = 0.1, default_doc = "errors of steps are not looked at",
        doc = "in motion: steps are as long as their estimated error allows, each taken again as two halves (theory, § 2); what the errors"
            .. " of all steps together may come to at t_end, as part of the fastest motion so far. Three solutions a step. Where something"
            .. " jumps, as in an impact, steps become no shorter for it than dt_min, 1e-5 of t_end if that is not given;"
            .. " `sim.totals.inaccurate` counts them" },
      { name = "displacement_ratio", type = "number", above = 0, most = 0.1, default = 0.005,
        doc = "largest displacement a step / half the height of the scene, along gravity (without it half its least width), of what may meet something in it: what flies by itself, or together, may go farther; where steps are automatic and no bonds can fail, what is pressed also turns by about 0.05 rad a step at most", source = "Shi 1988" },
      { name = "start", type = "enum", values = { "rest", "settled" }, default = "rest",
        doc = "`rest`: as given; `settled`: from static equilibrium; where friction cannot hold the scene, with joints that do not slide; where it topples even so, at rest as given, with a note" },
      { name = "max_steps", type = "integer", least = 0, default = 0, default_doc = "no bound",
        doc = "most steps" },
    },
  },
  {
    kind = "numerics", call = "",
    doc = "Choices of method. `numerics = talus.profile.ning2011` takes a profile as it is, "
      .. "`numerics = { profile = \"ning2011\", sleeping = true }` changes something in it.",
    fields = {
      { name = "profile", type = "enum", values = { "default", "ning2011" }, default = "default",
        doc = "where the other choices come from, see Profiles" },
      { name = "integrator", type = "enum", values = { "theta", "newmark" }, default = "theta",
        doc = "velocity θ-scheme, or Newmark (½, 1)" },
      { name = "theta", type = "number", least = 0.5, most = 1, default = 0.75,
        doc = "θ of the θ-scheme; ½ keeps waves, but bonded blocks that turn fly apart below about 0.6", source = "damps as Newmark (0.5625, 1)" },
      { name = "dynamic_parameter", type = "number", least = 0, most = 1, default = 1,
        doc = "part of the velocity that a step inherits (newmark)", source = "Shi 1988" },
      { name = "damping", type = "any",
        of = { { type = "function" }, { type = "object", kinds = { "velocity_damping" } } }, default_doc = "none",
        doc = "a `talus.damping.velocity`, or `function(speed, dt)` that returns the part of its velocity, [0, 1], that a block"
          .. " keeps after each step, from the speed of its centroid (m/s) and the step (s)" },
      { name = "contact_tolerance", type = "number", above = 0, most = 1e-2, default = 1e-8,
        doc = "contact residual / force scale of a block" },
      { name = "static_tolerance", type = "number", above = 0, most = 1e-2, default = 1e-8,
        doc = "out-of-balance force / force scale" },
      { name = "max_iterations", type = "integer", least = 1, most = 10000, default = 60,
        doc = "open–close iterations before a step is cut" },
      { name = "threads", type = "integer", least = 1, most = 1024, default = 1,
        doc = "for the linear solver. It takes one whatever this says: a second one gains less than it costs, and runs beside each other (`talus sweep`) take all there are. The results are the same to the last bit" },
      { name = "islands", type = "boolean", default = true,
        doc = "blocks that neither touch nor hang together are solved apart; false: the scene as one, for study" },
      { name = "sleeping", type = "boolean", default = false,
        doc = "islands that have come to rest, to rounding, cost nothing until something comes near them or a change reaches"
            .. " them: places and forces are those without it, to the bit; `sim.contacts` has theirs first" },
      { name = "solver", type = "enum", values = { "auto", "factor", "sweeps", "splitting" }, default = "auto",
        doc = "of contacts in motion, for study: Newton's steps with a factor, sweeps over contact forces, or the splitting, alone."
            .. " Equilibrium is always solved with a factor" },
      { name = "recovery", type = "boolean", default = true,
        doc = "smoothed stress for output and probes, beside the raw one" },
    },
  },
  {
    kind = "velocity_damping", call = "talus.damping.velocity",
    doc = "Velocities fall by exp(−rate·Δt) a step, so that what is taken does not depend on the step.",
    fields = {
      { name = "rate", type = "number", least = 0, unit = "1/s", required = true,
        doc = "of velocity; energy falls at twice the rate" },
    },
  },
  {
    kind = "fracture", call = "", doc = "How bonds fail that have reached their strength.",
    fields = {
      { name = "order", type = "enum", values = { "critical", "all", "one" }, default = "critical",
        doc = "which fail before the others are judged anew under the same load: the most critical with those within `band`"
          .. " of it, all, or the most critical alone. In motion a bond waits only for those it shares a corner with" },
      { name = "band", type = "number", least = 0, below = 1, default = 0.05,
        doc = "part of the highest utilisation" },
      { name = "overshoot", type = "number", above = 0, most = 1, default = 0.01,
        doc = "static: part of its strength by which an increment of load may overload the first bond" },
      { name = "path", type = "enum", values = { "mesh", "tracked" },
        default_doc = "`tracked` for bonds of triangles that soften by `talus.laws.softening` without `scatter`; `mesh` for others",
        doc = "which bond at the tip of a crack fails in tension: the one that is due, by which a crack strays with the mesh and needs"
          .. " more load; or the one there that ends nearest to the way of the highest hoop stress, which is followed from where the"
          .. " crack would be without a mesh, as soon as that stress reaches the tension strength. `tracked` is for bonds that stand"
          .. " for a continuum, not for grains or scattered strengths" },
    },
  },
  {
    kind = "output", call = "", doc = "What is written, and where.",
    fields = {
      { name = "dir", type = "string", default_doc = "nothing is written",
        doc = "folder, from where the program runs; `-o` goes before it" },
      { name = "every", type = "number", above = 0, unit = "s", default_doc = "first and last only",
        doc = "time between outputs" },
      { name = "vtk", type = "boolean", default = true, doc = "VTK series of blocks and joints" },
      { name = "error", type = "boolean", default = false,
        doc = "estimates the error of stress where blocks are bonded: `stress_error` of blocks and `traction_jump` of joints in VTK, and"
            .. " that of each region at the end in run.json. `sim.error` gives it at any time; otherwise it is not computed" },
      { name = "picture", type = "any",
        of = { { type = "boolean" }, { type = "string" }, picture },
        default = true, doc = "SVG pictures: true, false, the name of a field of blocks or joints (of which a block shows its largest), or a `picture`"
            .. " table. The colours of each picture span the values"
            .. " of its own time, its axes the blocks where they are then: compare pictures by the numbers at the bar" },
      { name = "fields", type = "map", of = { type = "function" },
        doc = "arrays of one's own: `{ name = function(block) return number end }`" },
    },
  },
  {
    kind = "picture", call = "", doc = "How pictures look.",
    fields = {
      { name = "field", type = "string", default = "s1",
        doc = "what to colour by, see Fields of blocks and of joints: `\"utilisation\"`, say" },
      { name = "scale", type = "number", least = 0, default = 0, default_doc = "1",
        doc = "magnification of displacements" },
    },
  },
}
