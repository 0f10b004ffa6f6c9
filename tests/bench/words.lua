-- What docs/performance.md says of each case, beside the numbers.
local words = {}

words.intro = [[
Error against the CPU time that it took: user seconds of a whole process (start, about 0.02 s, mesh, solution, no output), the least of two
runs (one where it takes over 3 s). Scenes: `tests/bench`. A point of the dashed front is beaten by no other of Talus in both. CalculiX and Box2D run in the
same script, on the same machine, in the same minutes.

**In short.** Second-order blocks for anything elastic: twice as fast at 1 %, twenty times at 0.1 %. Default bonds; springs only to repeat the
paper. `talus.refine` where stresses are concentrated and a bound on the error is wanted. θ = 0.5 for waves, 0.75 elsewhere, Δt 0.4 to 0.8 of a
wave's way through a first-order block, a sixteenth of that through a second-order one. Rigid blocks where nothing but sliding matters. One thread.]]

words.cantilever = { title = "Cantilever: tip deflection", what = [[The paper's beam, 8 × 1 m under a point load, against 2D elasticity
(quadratic elements, converged to 0.007 %). Axes: order, size, penalty, springs. CalculiX: quadrilaterals CPS8 and CPS4 in a regular grid.]],
  advice = [[Take second-order blocks of h = 0.5 for 0.2 % and of 0.25 for 0.1 %; first-order ones need h = 0.03 for that. Keep the penalty: ten times as much
costs first-order blocks a factor of two to three in error, second-order ones little. Springs of 40E look good at one size, where two errors cancel, and get worse with finer blocks.]] }
words.hole = { title = "Plate with a hole: its widening", what = [[Kirsch's plate, half side 4 m, hole of 1 m, under the tractions of the exact
stress; against 6 σ a/E. Talus has the hole as a polygon of 48 sides with loads in pieces, which moves its answer by about 0.01 %; the polygon also forces small
blocks at the hole on the coarsest meshes. CalculiX has a quarter of the plate in a mapped grid, which is a quarter of the work.]],
  advice = [[Second order at every accuracy. Refinement costs more than it gives where one displacement is asked for: what it resolves is stress.]] }
words.hole_stress = { title = "Plate with a hole: error of stress", what = [[The same plate: error of the raw stress in energy norm, from 1600 samples.
Time includes all rounds of `talus.refine` and the 1600 probes.]],
  advice = [[Second order; with `talus.refine` below 1 %. For first-order blocks refinement saves blocks, not time, at these sizes.]] }
words.brazilian = { title = "Brazilian disc: stress at the centre", what = [[A disc under pressure on two arcs, a polygon of 132 sides, against Hondros (1959). The sides of the polygon bound the
mesh from above, so that coarse sizes have fine blocks at the rim; what is left at the end, some 0.03 %, is the polygon.]],
  advice = [[Second order at h of a sixth of the radius. The error of first-order blocks at one point has a sign that changes from mesh to mesh: do not read a rate from it.]] }
words.wave = { title = "A wave in a bar", what = [[A pulse of 2 m (sin², 1 ms) in a bar of blocks in a row, when it has gone 3 m; velocities of all blocks against d'Alembert. Axes:
θ, Newmark, order, size, Δt, tolerance.]],
  advice = [[θ = 0.5: at 0.75, and with Newmark (½, 1), the error is that of damping and falls with Δt only, seven times larger at h = 0.05. First-order blocks are best at steps of 0.8 h/c, where
the errors of space and time cancel in part (the curve by Δt, of which 0.31 % is such a point); second-order ones below 0.5 %. `tolerance` finds a step by itself at about twice the
cost; asked for less than the mesh's own error it buys nothing.]] }
words.incline = { title = "Incline", what = [[A block slides down 30° at a friction of 20° for 2 s, against the closed form. Errors of Talus are rounding and the settled start, those of
Box2D first order in Δt until its single precision ends it.]],
  advice = [[Any step: constant acceleration is exact at every Δt. Rigid, unless stresses are wanted.]] }
words.wall = { title = "Wall at rest", what = [[A running-bond wall put down at rest, for a second; the farthest that a brick gets, over its height. Steps of 1/60 s. For deformable bricks it is
their own compression. Box2D keeps a skin round its polygons (1 cm): bricks that touch at the start are pushed apart, which is what its error shows; more iterations
do not change it. It is made for other ends. Walls of three sizes are on one picture: the front is of no meaning between them.]],
  advice = [[Where centimetres do not matter and nothing but looks does, Box2D is five to thirteen times faster. Otherwise rigid bricks; deformable ones at twice the cost. Sleeping gains little in a second that begins with
settling. At 10 × 10 and 20 × 20 `solver = "factor"` takes a quarter to a half of what auto takes, which is made for more; `"sweeps"` alone takes ten to twenty times as much.]] }
words.spinner = { title = "Spinning disc", what = [[A free disc of bonded blocks, two turns at 50 rad/s; stress at its centre, mean over the second turn, against the centrifugal one. Axes: order, size, steps a turn, θ.]],
  advice = [[First-order blocks of h = 0.4 and 200 steps a turn for 0.3 %; 50 steps are too few. The outline is a polygon of 64 sides, whose area is 0.16 % less than
the circle's, and so is the stress, about: below that the errors say nothing. θ = 0.5 is not for turning bodies: the disc flies apart (not on the picture; theory, § 2, says why).]] }
words.splitting = { title = "Splitting load of a disc", what = [[The flattened disc of the paper, with a bonded trace along the loaded diameter so that each mesh has the same path for the crack, and blocks of 0.8 mm at the flats, so that each mesh has the pressure of the plates.]],
  advice = [[First-order blocks of 3.6 mm: with path and plates resolved both orders are within 1.2 % at every size, and what is left scatters, as a bond fails by the mean over its own
length. On meshes without a trace the path costs some per cent more (theory, § 12), and without fine blocks at the flats first-order ones of 3.6 mm are 6 % off.]] }
words.blast = { title = "Gas in a borehole: V(t)", what = [[A hole under 50 MPa of gas that opens three cracks on given paths (5 MPa, G = 200 J/m²) in elastic rock and runs along them; the
volume of hole and cracks at ten times of 100 µs, root mean square of the differences.]],
  advice = [[Second-order blocks below 2 %: of 0.12 m they are nearer than first-order ones of 0.015 m, in a third of the time. Both orders go to the same V(t). A Δt of 2 µs is worth 2 % and
the error falls in proportion to it: take the step down with the size. Where rock may break anywhere and keeps nothing of its strength (no G, no path),
V(t) depends on which edges the mesh has, and no order mends that: on such a scene (100 MPa, 40 µs, no paths, 284 and 624 blocks) two meshes and two orders end within 5 %
of each other, with no trend. Second-order blocks gave 26 to 40 % more there until their contacts were put right (theory, § 1).]] }
words.pile = { title = "Cast blast: centroid of the pile", what = [[A bench of 4 × 3 m, blown off a hole 1.2 m behind its free face, with the drag of `examples/11` (L = 2 m); how far the centroid of
the bench has gone when the pile lies, at 1.6 s. Each point is one run.]],
  advice = [[Do not read an order from this. The pile is the outcome of some hundred collisions: two runs that differ in one crack part for good, and the gas blows out up to
2 ms earlier or later with the edges that the mesh happens to have. The same rock with its hole moved by centimetres scatters as much as sizes, orders and steps
differ. Take first-order blocks at the size that the fragments should have, and the mean of some runs (`seeds` of a study) instead of one finer one;
halving the steps buys nothing beside that.]],
  spread = { what = "The same scene with its hole moved by 0 to 4 cm along and up, first order, h 0.6", of = function(point)
    return point.series:match "hole moved" or point.series == "order 1" and point.label == "h 0.6"
  end } }
words.dda = { title = "Walls, beside a DDA program of Shi's kind", what = [[CPU a step of 2 ms; bricks of 1 GPa on fixed contact stiffness, from rest. The other column is **not of this machine and not of this run**: measured once
for a program in C (block LDLᵀ with minimum degree renewed each step, one thread, 2026); it is not scaled, as the kernel's time on that machine is not known. That program takes a step when states no longer flip, Talus when
the residual of the coupled law is below 1e-8. The smaller the wall, the more of Talus' step goes into being right where few blocks are cheap to solve anew: it is the slower one at 106, and the faster from some 1000 blocks on.]],
  measured = { ["10x10"] = 0.00092, ["20x20"] = 0.0117, ["25x40"] = 0.056 } }

return words
