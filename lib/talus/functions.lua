-- Calls that take no table of fields, for the reference page.
return {
  {
    title = "A running simulation",
    doc = "What `talus.simulation` returns. It can be read at any time and changed between steps and in handlers (loads and displacements of supports that change between two load steps of a static run, and displacements between two steps in motion, come over the next one); "
      .. "inside a step (in a law) it can only be read.",
    { "sim:step()",
      "one accepted step; its status {step, time, dt, iterations, cuts, factorisations, residual, displacement,"
        .. " closed_contacts, failures (bonds), utilisation (static: the highest that the load step reached)}, or nil when the run is finished" },
    { "for status in sim:steps() do", "steps until the run is finished" },
    { "sim:run()", "the same, without stopping in between; the status of the last step" },
    { "sim:stop()", "finishes the run after this step" },
    { "sim:output()", "writes one output time now" },
    { "sim:log(format, …)", "prints a line with the time, formatted as by string.format" },
    { "sim:save(), sim:save(file)",
      "the state of the simulation, and `sim.state`, as a value to give to sim:restore; with a name it is written there"
        .. " too, see [saving](saving.md)" },
    { "sim:restore(state or file)", "goes back to a saved state, bit by bit; between steps only" },
    { "sim.state", "a table for the script's own data, saved and restored with the simulation: numbers, texts, true,"
        .. " false and tables of these" },
    { "sim:hash()", "16 hexadecimal digits that tell states apart, `state_hash` in run.json" },
    { "sim.time, sim.dt", "time now, last step (s)" },
    { "sim.finished, sim.last", "whether the run is finished; status of the last step" },
    { "sim.energy", "the energy ledger now: {kinetic, strain, contact, gravity, total, external, boundary, friction, damping,"
        .. " viscous, fracture, numerical, unexplained, scale} (J per metre), those that the scene can have; see Energies" },
    { "sim.error", "the estimated error of stress now, in energy norm: {relative (to the stress that has come since the start), regions (the"
      .. " same by name), norm (√(J/m))}; computed when it is read. nil where no blocks are bonded or `numerics.recovery` is off" },
    { "sim.totals",
      "{steps, steps_at_rest (nothing moved, nothing was solved), steps_by_sweeps (without a factor), islands {at_rest, single"
        .. " (a block alone), by_sweeps, with_factor, asleep}, iterations, sweeps (over the contacts), splittings (iterations), pivots (sets of states that pivots found), cuts, factorisations, largest_iterations, largest_residual, failures (bonds), largest_utilisation (in static load steps: by how much a strength was passed), seconds}; seconds: CPU time by part" },
    { "sim.cracks", "cracks of bonds that have failed and hang together: { {joints, length, tension, shear}, … } with the lengths of"
        .. " all in `tension` and `shear` (m)" },
    { "sim.fragments", "what hangs together by intact bonds: { {blocks (how many), first (block), region, held (whether it is at a support"
        .. " or viscous edge), area, mass, size, x, y, ux, uy, vx, vy}, … }; size: diameter of the disc of its area (m)" },
    { "sim.highest", "in motion: {block, rise, time}, the highest that the centroid of any block has risen above its place at the start, against gravity (along y without)"
        .. " (m, s); nil where none has" },
    { "sim.strained", "{block, strain, time}, the largest principal strain of any block so far, by its size (of second-order blocks their mean); nil where none has"
        .. " strained. Linear elasticity is for small ones: beyond 0.1 a note says so" },
    { "sim:explain(joint)", "in plain words, why a bond has failed or has not: tractions, strengths, how far they are used, which governs,"
        .. " when, and what is left; a joint of this simulation or its number" },
    { "sim.reactions.name", "{x, y} (N per metre) of the fixities of that name on what they hold; in motion those of the last step" },
    { "sim.collapsed", "whether a static run has ended at a load that nothing holds" },
    { "sim.charges[1], sim.charges.name", "the chamber that holds the charge's gas, to be read only: {name, state (\"waiting\", \"pressing\", \"vented\"),"
        .. " vented, vented_at (s), volume, first_volume (m3 per metre), pressure (Pa), front (m), work (J/m, by its law), joined (m3 per"
        .. " metre, filled as it entered cracks), reach (m of joints that it has entered), reached ({ {joint, from, to}, … }, parts of"
        .. " them), delay (s, with its scatter), mass (kg per metre, of a charge given by its explosive), left (part of its gas that has not"
        .. " blown out through an orifice), opening (m, of that), stemming (m, how far it has moved), x, y, radius (m, of the charge's hole at the start)}" },
    { "sim:material(name), sim:joint(name), sim:fix(name), sim:load(name), sim:region(name)",
      "the object as the script made it, by name or number: `sim:load(\"push\").force = {0, -2e3}`" },
    { "sim.blocks[7].sxx", "a field of one block (or joint, contact, probe), numbered from 1" },
    { "#sim.blocks", "how many; `ipairs` and `pairs` go through them. A number outside is an error, but for the one after the last, which is nil" },
    { "sim.blocks:field(\"sxx\")", "a field of all of them, as a list" },
    { "sim.blocks:select(function(block) return block.uy < 0 end)",
      "a list of those for which the function returns true" },
    { "sim.blocks:where { region = \"beam\" }", "a list of those whose fields equal the given values" },
    { "sim.probes.tip.uy", "probes by name" },
    { "block.velocity = {vx, vy}, block.spin = w", "sets a block's velocity (m/s) and spin (rad/s)" },
  },
  {
    title = "After a run",
    doc = "Their options are in the tables above; each also has `file`, the name of a table and a picture in output.dir. They measure the"
      .. " state as it is when they are called.",
    { "sim:plot(name, { {x = …, y = …}, … })", "a picture of one's own, `<output.dir>/<name>.svg`" },
    { "sim:table(name, { {\"x [m]\", xs}, … })", "columns of numbers with their names, all of one length, `<output.dir>/<name>.csv`" },
    { "talus.blast.fragmentation(sim, {…})", "fragment sizes: x20, x50, x80, Rosin–Rammler and Swebrec" },
    { "talus.blast.distribution {…}", "the same of given sizes" },
    { "talus.blast.pile(sim, {…})", "muck pile: profile, height, toe, throw, centroid shift, swell, cast, flyrock" },
    { "talus.blast.vibration(sim, {…})", "peak particle velocity at the probes and its attenuation" },
    { "talus.blast.backbreak(sim, {…})", "bonds that failed behind a line" },
  },
  {
    title = "Checks",
    doc = "Each prints one line, PASS or FAIL, and is kept in run.json. Any FAIL makes the exit status 1.",
    { "talus.check.near(name, value, expected, {rel = r, abs = a})",
      "abs(value - expected) <= max(r*abs(expected), a)" },
    { "talus.check.below(name, value, bound)", "value < bound" },
    { "talus.check.above(name, value, bound)", "value > bound" },
    { "talus.check.between(name, value, low, high)", "low <= value <= high" },
    { "talus.check.equal(name, value, expected)", "value == expected" },
    { "talus.check.truth(name, value)", "value is true" },
  },
  {
    title = "Parameters and running",
    doc = "`talus scene.lua -p size=0.1 -o out/fine`. With -o, the second and later simulations of a script"
        .. " write to "
      .. "`<dir>/2`, `<dir>/3`, …; without it each needs an output.dir of its own.",
    { "talus.param(name, default [, meaning])",
      "default, or what `-p name=value` says: a number, a text, true or false, as the default is. All are"
        .. " declared before the first simulation" },
    { "talus.result(name, value [, unit])",
      "prints a value and keeps it in run.json, as `results.<name>`, for a [study](sweeps.md) to collect: a number, a text, true or false" },
    { "talus.range(from, to, count), talus.log_range(from, to, count)",
      "a list of `count` numbers, evenly spaced; each a fixed factor from the one before" },
    { "talus scene.lua --restart file",
      "runs the script again and continues from the state in the file, see [saving](saving.md)" },
    { "require \"part\"",
      "runs part.lua in the scene's folder once. A scene has no files and no processes: of Lua's libraries io and debug"
        .. " are not there, and of os only time, clock and date" },
  },
}
