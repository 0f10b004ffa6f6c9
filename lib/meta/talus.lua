---@meta talus
-- Annotations for the Lua language server, written by `talus --annotations`; do not edit.

---@class talus
local talus = {}

---@class talus.material
---@field name? string for output and `sim:material(name)`
---@field density number kg/m3; > 0; mass per volume
---@field young number Pa; > 0; Young's modulus E
---@field poisson number in [0, 0.5); Poisson's ratio
---@field plane? "stress"|"strain" plane stress or plane strain, for 1 m thickness

---What blocks are made of: isotropic and linearly elastic.
---@param fields talus.material
---@return talus.material
function talus.material(fields) end

---@class talus.joint
---@field name? string for output and `sim:joint(name)`
---@field friction? number rad; in [0, 1.570796327); friction angle
---@field cohesion? number Pa; >= 0; cohesion of bonds and of traces; required beside tension, unless a criterion judges. Other contacts carry friction alone
---@field tension? number Pa; >= 0; tensile strength of bonds; without it Mohr–Coulomb's line goes on to where it ends. What is no bond carries none
---@field residual? talus.residual|table what a failed bond still carries, at once
---@field reduction? function|talus.softening|talus.slip_weakening|talus.barton_bandis instead of residual: a `talus.laws`, or `function(intact, slip, opening, normal)` that returns what a failed bond still carries, `{ friction = …, cohesion = …, tension = … }`, after the largest slip and opening so far (m) under the normal traction (Pa); a field left out is 0, friction that of `intact`
---@field criterion? function `function(t)` that returns how far a bond's strength is used; it fails at 1. `t` has the tractions `normal` (tension positive) and `shear`, and the strengths `tension`, `cohesion` (Pa), `friction` (rad); where it asks for them, also the bond's `id` (as in `sim.joints`), `length` (m, at the start), `x`, `y` (m, of its middle now), `dip` (rad, of its edge against +x, above −π/2 to π/2) and `property` (name of its talus.joint); tried with a bond of length 1 at (0, 0). It leaves the strengths in `t` as they are. The answer is finite and >= 0, best in proportion to the traction: static load increments are found by it. Whether the bond fails in tension or in shear is not the criterion's to say: tension, where it pulls at least as hard as it shears
---@field scatter? talus.weibull of the strength from bond to bond
---@field bond? "exact"|"spring" how intact bonds are held: `exact` (consistent flux plus penalty, no joint compliance) or `spring` (springs at the ends of an edge)
---@field penalty? number > 1; exact bonds: multiple of the least stiffness that is positive definite by proof
---@field stiffness? number|talus.stiffness|table normal stiffness of contacts and spring bonds: a number α for α·E/h per length, h the size of the blocks, or a `stiffness` table
---@field shear_ratio? number in (0, 10]; shear stiffness / normal stiffness
---@field restitution? number in [0, 1]; normal restitution of contacts, the most they give back: what has met at a speed v parts at no more than this part of v. 1: what the step leaves, by itself a third of v where it is long beside the contact's period (theory, § 3); what this takes is damping in the energy ledger

---Properties of an interface: of the bonds between the blocks of a region and of contacts. Bonded, it carries tension and shear up to its strength; bonds of a joint that gives neither `tension` nor `cohesion` never fail. Broken or never bonded, it is a contact with friction.
---@param fields talus.joint
---@return talus.joint
function talus.joint(fields) end

---@class talus.residual
---@field friction? number rad; in [0, 1.570796327); friction angle
---@field cohesion? number Pa; >= 0; for the roughness of the crack
---@field tension? number Pa; >= 0; tensile strength

---@class talus.softening
---@field shape? "linear"|"exponential" of the curve
---@field G_I number J/m2; > 0; fracture energy in tension
---@field G_II? number J/m2; > 0; fracture energy in shear, above residual cohesion and friction
---@field residual? talus.residual|table what is left in the end

talus.laws = {}

---A failed bond softens as it opens and slides: with r = opening/δ_I + slip/δ_II tension and cohesion fall to the part 1 - r (linear) or exp(-r) (exponential) of what they were above the residual; δ follows from the fracture energies. Along a tracked crack in tension a bond holds no more than the traction that it failed with.
---@param fields talus.softening
---@return talus.softening
function talus.laws.softening(fields) end

---@class talus.slip_weakening
---@field distance number m; > 0; slip at which the residual is reached
---@field residual? talus.residual|table what is left in the end

---A failed bond loses its tension at once; cohesion and friction fall linearly with slip.
---@param fields talus.slip_weakening
---@return talus.slip_weakening
function talus.laws.slip_weakening(fields) end

---@class talus.barton_bandis
---@field jrc number in [0, 20]; joint roughness coefficient
---@field jcs number Pa; > 0; joint wall compressive strength
---@field friction? number rad; in [0, 1.570796327); residual friction angle φ_r

---A rough crack: friction angle φ_r + JRC log10(JCS/σ_n) under the normal pressure σ_n, no cohesion, no tension.
---@param fields talus.barton_bandis
---@return talus.barton_bandis
function talus.laws.barton_bandis(fields) end

---@class talus.hoek_brown
---@field ucs number Pa; > 0; uniaxial compressive strength of the intact rock
---@field mi number > 0; constant of the intact rock, about 4 to 33
---@field gsi? number in [0, 100]; geological strength index; 100: intact rock
---@field disturbance? number in [0, 1]; D, by blasting and relaxation
---@field confinement? number Pa; > 0; the largest σ3 that the line is for

---Strengths of a joint after Hoek and Brown's criterion: returns `{ friction, cohesion, tension }`, fields for talus.joint. Friction and cohesion are those of the straight line that fits σ1 over σ3 best (least squares) from the tensile strength to `confinement`; tension is where the curve ends.
---@param fields talus.hoek_brown
---@return table<string, number>
function talus.laws.hoek_brown(fields) end

---@class talus.weibull
---@field modulus number in [1, 1000]; shape; scatter about 1.2/modulus
---@field seed? integer in [0, 4294967295]; the same seed gives the same strengths

---Strengths of bonds scattered by Weibull's distribution about those of the joint, their mean.
---@param fields talus.weibull
---@return talus.weibull
function talus.laws.weibull(fields) end

---@class talus.stiffness
---@field per? "length"|"area"|"contact" `length`: value is α in α·E/h; `area`: k_n of a rock joint, whatever the blocks; `contact`: a fixed stiffness for each contact and each end of a bond
---@field value? number 1, Pa/m or N/m; > 0; α, k_n (fresh joints: 10 to 1000 GPa/m, more where pressed harder, Bandis, Lumsden & Barton 1983), or the stiffness of one contact
---@field times_young? number > 0; per contact, instead of value: multiple of E of the region's material (between regions: of the softest one)

---@class talus.outline
---@field [integer] any corners in order, either way round
---@field name? string for holes: what `talus.grade` calls it

---A simple polygon: `talus.polygon { {0, 0}, {2, 0}, {1, 1} }`.
---@param fields talus.outline
---@return talus.outline
function talus.polygon(fields) end

---@class talus.rect
---@field from number[] m; x1, y1
---@field to number[] m; x2, y2
---@field name? string for holes: what `talus.grade` calls it

---A rectangle by two opposite corners: `talus.rect(x1, y1, x2, y2 [, name])`. The result is an outline.
---@param fields talus.rect
---@return talus.rect
function talus.rect(fields) end

---@class talus.circle
---@field at number[] m; centre
---@field radius number m; > 0; radius
---@field sides? integer in [3, 10000]; number of sides
---@field name? string for holes: what `talus.grade` calls it

---A regular polygon with its corners on a circle. The result is an outline.
---@param fields talus.circle
---@return talus.circle
function talus.circle(fields) end

---@class talus.line
---@field from number[] m; one end
---@field to number[] m; the other end

---A segment: `talus.line(x1, y1, x2, y2)` or `talus.segment({x1, y1}, {x2, y2})`.
---@param fields talus.line
---@return talus.line
function talus.line(fields) end

---@class talus.point
---@field at number[] m; where

---A point: `talus.point(x, y)`.
---@param fields talus.point
---@return talus.point
function talus.point(fields) end

---@class talus.running_bond
---@field at number[] m; lower left corner
---@field courses integer in [1, 10000]; layers of bricks
---@field per_course integer in [1, 10000]; bricks in a full layer
---@field length number m; > 0; of a brick, along x
---@field height number m; > 0; of a brick, along y

---Outlines of the bricks of a wall, every other course shifted by half a brick, for `blocks` of a region. The shifted courses end in half bricks.
---@param fields talus.running_bond
---@return talus.running_bond
function talus.running_bond(fields) end

---@class talus.grade
---@field [integer] any where the mesh is fine
---@field far number m; > 0; size away from all of them

---A mesh size that grows linearly away from some places: `talus.grade { { at = "hole", size = 0.05 }, far = 0.4 }`.
---@param fields talus.grade
---@return talus.grade
function talus.grade(fields) end

---@class talus.grade_source
---@field at number[]|number[][]|string|table where: a point or a line, a bent line as a list of points, a trace or the edge of an outline; or the name of a hole or a trace of the region
---@field size number m; > 0; size there
---@field reach? number m; > 0; distance over which the size grows to `far`

---@class talus.region
---@field name? string what fixities and loads call it
---@field outline? table the region's outline
---@field blocks? (table)[]|table instead of outline: one outline for each block
---@field bonded? boolean of ready blocks: those that share a whole edge, corners at the same place to a 1e-9th of the region, are bonded there like those of a mesh
---@field holes? (table)[]|table outlines of holes; a name is given by the shape. Of bonded ready blocks: where they leave a hole for a charge, its corners those of the blocks round it
---@field material talus.material what it is made of
---@field joint? talus.joint of its bonds and of contacts between its own blocks
---@field mesh? talus.mesh|table how it is divided into bonded blocks
---@field cuts? (talus.trace|talus.joint_set)[]|table joints that cut it; lists of traces as from a file may stand among them
---@field slivers? "merge"|"refuse"|"keep" blocks that cuts leave thinner than sliver_part: joined to a neighbour, with shorter edges closed; refused; or kept. A note says how many; triangles of a mesh are not merged
---@field sliver_part? number in [0, 0.2]; of the mesh size, or of the square root of the mean block area where there is no mesh; a block's thickness is 2·area/perimeter
---@field order? 1|2|"rigid"|fun(x: number, y: number): integer|string `1`: blocks deform with constant strain (6 unknowns); `2`: with a strain that varies linearly (12); `"rigid"`: not at all (3). A function of the centroid's x and y gives each block its own. Contacts follow the edges of a block of 2 as they bend; where anything may touch these have corners in their middles, and more where they are slender
---@field held? boolean fixed as a whole: no unknowns; moves only by a `talus.fix` with a motion
---@field velocity? number[] m/s; at the start
---@field spin? number rad/s; at the start, counter-clockwise
---@field spin_centre? number[] m; centre of spin
---@field stress? talus.stress|table at the start
---@field body_force? table N/m3; force per volume, beside gravity

---A part of the scene: an outline, whole, cut by joints or meshed into blocks; or a set of ready blocks.
---@param fields talus.region
---@return talus.region
function talus.region(fields) end

---@class talus.mesh
---@field kind? "triangles"|"voronoi"|"cross"|"diagonal"|"alternating" `triangles`: unstructured; `voronoi`: convex grains; `cross`: rectangles cut by both diagonals; `diagonal`, `alternating`: by one
---@field size? number|talus.grade|fun(x: number, y: number): number wanted length of edges, of grains the square root of their mean area: a number, a `talus.grade` or a function of x and y
---@field seed? integer in [0, 4294967295]; `voronoi`: of the places of the grains; the same seed gives the same grains
---@field nx? integer in [1, 100000]; patterns, instead of size: rectangles along x
---@field ny? integer in [1, 100000]; patterns, instead of size: rectangles along y

---@class talus.trace
---@field points number[][]|table two or more points, or a `talus.line`
---@field name? string what `talus.grade` calls it
---@field joint? talus.joint property of its faces, whatever of the region slides along them
---@field bonded? boolean glued with the strength of the joint; otherwise the blocks touch by contact

---A joint that cuts its region, straight or bent.
---@param fields talus.trace
---@return talus.trace
function talus.trace(fields) end

---@class talus.joint_set
---@field dip number rad; in [-6.283185307, 6.283185307]; angle of the joints against +x, counter-clockwise
---@field spacing number m; > 0; distance between joints, normal to them
---@field persistence? number in (0, 1]; jointed part of a line's length: trace_length/(trace_length + gap), of which two give the third
---@field trace_length? number m; > 0; length of a jointed part, where persistence < 1
---@field gap? number m; > 0; length of the rock bridge between two jointed parts of a line
---@field trace_length_scatter? number in [0, 1); relative scatter of trace_length, uniform
---@field gap_scatter? number in [0, 1); relative scatter of gap, uniform
---@field spacing_scatter? number in [0, 1); relative scatter of the spacing, uniform
---@field dip_scatter? number rad; in [0, 0.7853981634]; scatter of the dip, uniform
---@field through? number[] m; a point on one of the joints
---@field seed? integer in [0, 4294967295]; of the scatter; the same seed gives the same joints
---@field joint? talus.joint property of the interfaces
---@field bonded? boolean glued with the strength of the joint; otherwise the blocks touch by contact

---Parallel joints that cut their region.
---@param fields talus.joint_set
---@return talus.joint_set
function talus.joint_set(fields) end

---@class talus.stress
---@field sxx? number Pa; at the origin
---@field syy? number Pa; at the origin
---@field sxy? number Pa; at the origin
---@field gradient_x? number[] Pa/m; change along x
---@field gradient_y? number[] Pa/m; change along y

---@class talus.traces_from_csv
---@field file string first argument: name, from the scene's folder on
---@field joint? talus.joint property of the interfaces
---@field bonded? boolean as of a `talus.trace`
---@field scale? number m; > 0; metres for a unit of the file

---Traces from a table, for `cuts` of a region: `talus.traces_from_csv("faults.csv", { joint = … })`. Columns by a header: `trace,x,y`, a point a row, the rows of a trace following each other; or `x1,y1,x2,y2`, a straight trace a row, with `trace` for its name if there is one. Other columns are not read. Separated by commas, semicolons or tabs; empty lines and those that begin with # are skipped. Traces outside of the region, or that end inside a block, are counted in a note.
---@param fields talus.traces_from_csv
---@return talus.traces_from_csv
function talus.traces_from_csv(fields) end

---@class talus.traces_from_dxf
---@field file string first argument: name, from the scene's folder on
---@field layers? (string)[]|table layers to read, in capitals or not
---@field joint? talus.joint property of the interfaces
---@field joints_by_layer? table<string, talus.joint> property of the traces of some layers: `{ faults = weak }`
---@field bonded? boolean as of a `talus.trace`
---@field scale? number m; > 0; metres for a unit of the file
---@field chord? number in (0, 0.5]; arcs become chords: greatest distance between the two, of the radius

---Traces from a drawing (ASCII DXF), for `cuts` of a region: `talus.traces_from_dxf("plan.dxf", { layers = { "faults" } })`. LINE, LWPOLYLINE and POLYLINE with bulges, ARC and CIRCLE are read; a note counts what is not, and says which unit was taken.
---@param fields talus.traces_from_dxf
---@return talus.traces_from_dxf
function talus.traces_from_dxf(fields) end

---@class talus.outlines_from_dxf
---@field file string first argument: name, from the scene's folder on
---@field layer? string layer to read
---@field scale? number m; > 0; metres for a unit of the file
---@field chord? number in (0, 0.5]; arcs become chords: greatest distance between the two, of the radius

---An outline from a drawing, the one closed line of a layer: `talus.outline_from_dxf("plan.dxf", { layer = "slope" })`. `talus.outlines_from_dxf` gives a list of all of them, for `holes`; each has its layer for a name.
---@param fields talus.outlines_from_dxf
---@return talus.outlines_from_dxf
function talus.outline_from_dxf(fields) end

---@class talus.gmsh
---@field file string first argument: name, from the scene's folder on
---@field scale? number m; > 0; metres for a unit of the file

---A mesh of Gmsh (.msh, version 2 or 4.1, ASCII): its triangles and quadrangles as ready blocks, for `blocks` of a region with `bonded = true`. Returns `blocks` (all of them), `surfaces.name` (those of a physical surface), `curves.name` (a list of lines, the straight parts of a physical curve, for `on` of a fixity or load) and `loops.name` (the outline of a physical curve that closes, for `holes` of the region; the hole has the curve's name). An element of several groups goes with the first; those of second order are taken by their corners; a note says what was read. Between regions there are contacts, also where their elements share edges.
---@param fields talus.gmsh
---@return talus.gmsh
function talus.gmsh(fields) end

---@class talus.fix
---@field name? string for `sim:fix(name)`, `sim:load(name)`
---@field region string|talus.region its name, or the region itself
---@field on? string|string[]|table a `talus.line` (boundary edges on it), or sides of the region's box: `"left"`, `"right"`, `"top"`, `"bottom"`, one or a list, or a `talus.point` (the region's point nearest to it)
---@field x? boolean held along x
---@field y? boolean held along y
---@field displacement? table m; prescribed displacement since the start; 0 along what is not held
---@field velocity? table m/s; prescribed velocity
---@field spin? number rad/s; prescribed spin of a whole region of one block about its centroid (of several: each about its own); in motion only

---Holds a region, an edge or a point, or moves it as prescribed. Where two hold the same direction of one place they move it alike.
---@param fields talus.fix
---@return talus.fix
function talus.fix(fields) end

---@class talus.point_load
---@field name? string for `sim:fix(name)`, `sim:load(name)`
---@field at number[] m; where, at the start
---@field region? string|talus.region its name, or the region itself
---@field force table N; force, global directions

---A force on a material point, per metre of thickness.
---@param fields talus.point_load
---@return talus.point_load
function talus.point_load(fields) end

---@class talus.edge_load
---@field name? string for `sim:fix(name)`, `sim:load(name)`
---@field region string|talus.region its name, or the region itself
---@field on string|string[]|table a `talus.line` (boundary edges on it), or sides of the region's box: `"left"`, `"right"`, `"top"`, `"bottom"`, one or a list
---@field traction table Pa; force per area

---A traction on boundary edges, in global directions.
---@param fields talus.edge_load
---@return talus.edge_load
function talus.edge_load(fields) end

---@class talus.pressure
---@field name? string for `sim:fix(name)`, `sim:load(name)`
---@field region string|talus.region its name, or the region itself
---@field on string|string[]|table a `talus.line` (boundary edges on it), or sides of the region's box: `"left"`, `"right"`, `"top"`, `"bottom"`, one or a list
---@field value number|number[][]|fun(t: number): number Pa; pressure, positive towards the rock

---A pressure on boundary edges; it follows the edges.
---@param fields talus.pressure
---@return talus.pressure
function talus.pressure(fields) end

---@class talus.viscous
---@field region string|talus.region its name, or the region itself
---@field on string|string[]|table a `talus.line` (boundary edges on it), or sides of the region's box: `"left"`, `"right"`, `"top"`, `"bottom"`, one or a list

---Edges that let waves out (Lysmer & Kuhlemeyer 1969): dashpots with the P and S speeds of the rock behind them. While equilibrium is sought (`start = "settled"`, static mode) they are held like a fixed edge; what they carry then stays as a constant traction. Dashpots bear no weight: without a settled start, and under loads that come and stay, the region sinks or drifts on them.
---@param fields talus.viscous
---@return talus.viscous
function talus.viscous(fields) end

---@class talus.contact
---@field between (string|talus.region)[]|table two regions, by name or themselves; the same twice for its own blocks
---@field joint talus.joint property of the contacts

---The joint property of contacts between two regions.
---@param fields talus.contact
---@return talus.contact
function talus.contact(fields) end

---@class talus.probe
---@field at number[] m; where, at the start
---@field region? string|talus.region its name, or the region itself

---A material point whose motion and stress are recorded. `{x, y}` alone will do.
---@param fields talus.probe
---@return talus.probe
function talus.probe(fields) end

---@class talus.charge
---@field name? string for output
---@field region? string|talus.region the region of the hole
---@field hole string the hole's name
---@field delay? number s; >= 0; time at which it goes off
---@field delay_scatter? number s; >= 0; standard deviation of the delay, normally distributed; what would come before 0 comes at 0. `sim.charges[1].delay` is the delay that came out
---@field seed? integer in [0, 4294967295]; of the scatter; the same seed gives the charges of a scene the same delays, each its own
---@field explosive? "TNT"|"ANFO"|"emulsion"|talus.explosive|table what it is, by name or by its constants: its gas is on the isentrope of JWL (`talus.eos.jwl`). This or `eos`
---@field density? number kg/m3; > 0; of the explosive as it is loaded: it begins at as much more room for its mass
---@field diameter? number m; > 0; of the explosive, at most the hole's; the rest of the hole is empty (decoupling)
---@field eos? function|talus.polytropic|talus.jwl a `talus.eos`, or `function(v, t, chamber)` that returns the pressure (Pa) at v = V/V0, V0 the volume of the hole when it goes off: > 0, and falling as v grows; t seconds after that. This or `explosive`. The gas's work in a step is by the law at the middle of the step. Chamber: {name, volume, first_volume (m3 per metre), pressure (Pa), front (m)}, as it was at the beginning of the step; tried with 1 m3 under 1 MPa, from v = 1 to 10 000. That the pressure falls is seen to in the run too. Where rock has closed in on the gas (v < 1) the law is asked for v = 1
---@field gas_speed? number|function of the gas in cracks: a number or `function(t, chamber)`, t seconds after it went off; the gas has come as far from the hole's centre as ∫ speed dt, and is at the wall before that; of gas that has met, as with venting
---@field venting? function|talus.orifice a `talus.venting.orifice`, or `function(t, chamber)` that returns the part of the pressure left, t seconds after the gas has reached a free surface, or has thrown out the stemming. Where gas of several charges has met, what the charge says that went off first, or of those at one time the first in the list, holds for all of it
---@field stemming? talus.stemming what closes the hole: the chamber vents when it is out

---An explosive in a hole of a region. Its gas presses on the hole's wall and enters the failed joints that hang together with it, as far as its front has got; it vents where it reaches a free surface.
---@param fields talus.charge
---@return talus.charge
function talus.charge(fields) end

---@class talus.stemming
---@field length number m; > 0; L
---@field density? number kg/m3; > 0; ρ, of the column with its pores
---@field charge_length? number m; > 0; of the loaded part of the hole, whose gas the collar lets out through the area of the hole; required beside an orifice without an `opening`

---A column of broken rock in the collar of a hole, which runs out of the plane. The gas pushes it, only its inertia holds it: x'' = P/(ρL). At x = L it is out, and the chamber vents as the charge's `venting` says. Friction along the hole and what the gas gains in room behind the column are left out: it holds a little longer than this.
---@param fields talus.stemming
---@return talus.stemming
function talus.stemming(fields) end

---@class talus.explosive
---@field density number kg/m3; > 0; at which the constants hold
---@field A number Pa; > 0; A
---@field B number Pa; > 0; B
---@field R1 number > 0; R1
---@field R2 number > 0; R2
---@field omega number > 0; ω
---@field E number J/m3; > 0; energy per volume of explosive

---@class talus.orifice
---@field coefficient? number in (0, 1]; of discharge
---@field opening? number m; >= 0; width of what the gas leaves through
---@field density? number kg/m3; > 0; of the gas in the hole when the charge goes off; required beside an `eos`
---@field gamma? number in (1, 10]; γ of the gas as it leaves
---@field atmosphere? number Pa; > 0; pressure outside

talus.venting = {}

---The gas flows out as an ideal gas through a nozzle, isentropic: choked as long as outside/inside ≤ (2/(γ+1))^(γ/(γ-1)), slower after that, and ends at the atmosphere's pressure, after which it presses no more. What is left follows the same law in as much more room.
---@param fields talus.orifice
---@return talus.orifice
function talus.venting.orifice(fields) end

---@class talus.polytropic
---@field pressure number Pa; > 0; P0
---@field gamma? number in (0, 10]; γ

talus.eos = {}

---P = P0 (V0/V)^γ.
---@param fields talus.polytropic
---@return talus.polytropic
function talus.eos.polytropic(fields) end

---@class talus.jwl
---@field explosive? "TNT"|"ANFO"|"emulsion" ready-made constants
---@field A? number Pa; > 0; A
---@field B? number Pa; > 0; B
---@field R1? number > 0; R1
---@field R2? number > 0; R2
---@field omega? number > 0; ω
---@field E? number J/m3; > 0; energy per volume of explosive
---@field filled? number in (0, 1]; part of the hole's area that the explosive fills (decoupling): w = v/filled

---The isentrope of Jones, Wilkins and Lee: P = A e^(-R1 w) + B e^(-R2 w) + C w^-(1+ω), C = ω (E - A/R1 e^-R1 - B/R2 e^-R2), w the volume over that of the explosive. `talus.explosives` has constants.
---@param fields talus.jwl
---@return talus.jwl
function talus.eos.jwl(fields) end

---@class talus.simulation
---@field title? string for output
---@field regions (talus.region)[]|table the regions
---@field gravity? number[] m/s2; acceleration of gravity
---@field contact? talus.joint property of contacts between regions
---@field contacts? (talus.contact)[]|table rules for pairs of regions, one a pair
---@field fix? (talus.fix)[]|table what is held or moved
---@field loads? (talus.point_load|talus.edge_load|talus.pressure)[]|table loads
---@field boundaries? (talus.viscous)[]|table edges that let waves out
---@field charges? (talus.charge)[]|table explosives in holes; dynamic mode
---@field probes? table<string, talus.probe|table|number[]> `{ tip = {7.9, 0.5} }`
---@field time talus.time|table how far and how
---@field numerics? talus.numerics|table choices of method
---@field fracture? talus.fracture|table how bonds fail
---@field output? talus.output|table what is written
---@field on_step? function `function(sim)`, called once after each accepted step
---@field on_fracture? function `function(sim, cracks)`, called after a step in which bonds failed, before on_step: a list of `{ joint, mode = "tension" or "shear", kind = "initiated", "propagated" or "coalesced", x, y, length, time, normal, shear, utilisation }`, tractions in Pa
---@field on_gas? function `function(sim, events)`, called after a step in which a charge went off, a chamber vented or two met: a list of `{ kind = "detonation", "venting" or "merging", charge, other, time, volume, pressure, by, x, y }`, by = "surface" or "stemming" what a chamber vents through, x, y (m) where: the point of the free surface that its gas has come to, or the middle of the hole; volume (m3/m) and pressure (Pa) of the chamber before it vents, and after two have met
---@field stop? function `function(sim)`, called after each accepted step, after on_step: the run ends where it returns true
---@field on_output? function `function(sim)`, called after each output time was written
---@field max_blocks? integer >= 1; a mesh that would give more is refused

---Puts a scene together and builds it. A simulation that the script does not step is run by the program when the script has ended.
---@param fields talus.simulation
---@return talus.run
function talus.simulation(fields) end

---@class talus.time
---@field mode? "dynamic"|"static" `static` solves for equilibrium
---@field t_end? number s; >= 0; end, > 0 in dynamic mode; static: load histories run from 0 to it, and velocities of a `fix` act so long
---@field steps? integer in [1, 1000000]; static: load steps; where bonds can fail, or what is held moves by more than displacement_ratio in one, more are put between them
---@field dt? number s; > 0; fixed time step
---@field dt_min? number s; > 0; least step; below it the run stops with an error
---@field dt_max? number s; > 0; largest step
---@field tolerance? number in (0, 0.1]; in motion: steps are as long as their estimated error allows, each taken again as two halves (theory, § 2); what the errors of all steps together may come to at t_end, as part of the fastest motion so far. Three solutions a step. Where something jumps, as in an impact, steps become no shorter for it than dt_min, 1e-5 of t_end if that is not given; `sim.totals.inaccurate` counts them
---@field displacement_ratio? number in (0, 0.1]; largest displacement a step / half the height of the scene, along gravity (without it half its least width), of what may meet something in it: what flies by itself, or together, may go farther; where steps are automatic and no bonds can fail, what is pressed also turns by about 0.05 rad a step at most
---@field start? "rest"|"settled" `rest`: as given; `settled`: from static equilibrium; where friction cannot hold the scene, with joints that do not slide; where it topples even so, at rest as given, with a note
---@field max_steps? integer >= 0; most steps

---@class talus.numerics
---@field profile? "default"|"ning2011" where the other choices come from, see Profiles
---@field integrator? "theta"|"newmark" velocity θ-scheme, or Newmark (½, 1)
---@field theta? number in [0.5, 1]; θ of the θ-scheme; ½ keeps waves, but bonded blocks that turn fly apart below about 0.6
---@field dynamic_parameter? number in [0, 1]; part of the velocity that a step inherits (newmark)
---@field damping? function|talus.velocity_damping a `talus.damping.velocity`, or `function(speed, dt)` that returns the part of its velocity, [0, 1], that a block keeps after each step, from the speed of its centroid (m/s) and the step (s)
---@field contact_tolerance? number in (0, 0.01]; contact residual / force scale of a block
---@field static_tolerance? number in (0, 0.01]; out-of-balance force / force scale
---@field max_iterations? integer in [1, 10000]; open–close iterations before a step is cut
---@field threads? integer in [1, 1024]; for the linear solver. It takes one whatever this says: a second one gains less than it costs, and runs beside each other (`talus sweep`) take all there are. The results are the same to the last bit
---@field islands? boolean blocks that neither touch nor hang together are solved apart; false: the scene as one, for study
---@field sleeping? boolean islands that have come to rest, to rounding, cost nothing until something comes near them or a change reaches them: places and forces are those without it, to the bit; `sim.contacts` has theirs first
---@field solver? "auto"|"factor"|"sweeps"|"splitting" of contacts in motion, for study: Newton's steps with a factor, sweeps over contact forces, or the splitting, alone. Equilibrium is always solved with a factor
---@field recovery? boolean smoothed stress for output and probes, beside the raw one

---@class talus.velocity_damping
---@field rate number 1/s; >= 0; of velocity; energy falls at twice the rate

talus.damping = {}

---Velocities fall by exp(−rate·Δt) a step, so that what is taken does not depend on the step.
---@param fields talus.velocity_damping
---@return talus.velocity_damping
function talus.damping.velocity(fields) end

---@class talus.fracture
---@field order? "critical"|"all"|"one" which fail before the others are judged anew under the same load: the most critical with those within `band` of it, all, or the most critical alone. In motion a bond waits only for those it shares a corner with
---@field band? number in [0, 1); part of the highest utilisation
---@field overshoot? number in (0, 1]; static: part of its strength by which an increment of load may overload the first bond
---@field path? "mesh"|"tracked" which bond at the tip of a crack fails in tension: the one that is due, by which a crack strays with the mesh and needs more load; or the one there that ends nearest to the way of the highest hoop stress, which is followed from where the crack would be without a mesh, as soon as that stress reaches the tension strength. `tracked` is for bonds that stand for a continuum, not for grains or scattered strengths

---@class talus.output
---@field dir? string folder, from where the program runs; `-o` goes before it
---@field every? number s; > 0; time between outputs
---@field vtk? boolean VTK series of blocks and joints
---@field error? boolean estimates the error of stress where blocks are bonded: `stress_error` of blocks and `traction_jump` of joints in VTK, and that of each region at the end in run.json. `sim.error` gives it at any time; otherwise it is not computed
---@field picture? boolean|string|talus.picture|table SVG pictures: true, false, the name of a field of blocks or joints (of which a block shows its largest), or a `picture` table. The colours of each picture span the values of its own time, its axes the blocks where they are then: compare pictures by the numbers at the bar
---@field fields? table<string, function> arrays of one's own: `{ name = function(block) return number end }`

---@class talus.picture
---@field field? string what to colour by, see Fields of blocks and of joints: `"utilisation"`, say
---@field scale? number >= 0; magnification of displacements

---@class talus.plot
---@field [integer] any the lines
---@field title? string above it
---@field x_label? string `_` begins a subscript
---@field x_unit? string "m", "Pa": shown with the prefix that fits
---@field y_label? string as x_label
---@field y_unit? string as x_unit
---@field log_x? boolean logarithmic; values <= 0 are left out
---@field log_y? boolean logarithmic; values <= 0 are left out
---@field equal? boolean one scale for x and y, as for a section through rock

---@class talus.series
---@field name? string for the legend
---@field x (number)[]|table values along x; 0/0 interrupts the line
---@field y (number)[]|table as many along y
---@field line? boolean points joined
---@field markers? boolean points marked
---@field dashed? boolean a dashed line

---@class talus.distribution
---@field sizes (number)[]|table m; of the pieces
---@field weights? (number)[]|table area, volume or mass of each, in any unit

talus.blast = {}

---The size distribution of given pieces, measured ones say, as `talus.blast.fragmentation` makes it of a run's.
---@param fields talus.distribution
---@return talus.distribution
function talus.blast.distribution(fields) end

---@class talus.fragmentation
---@field regions? (string|talus.region)[]|table which, by name or themselves
---@field where? function `function(fragment)`, one of `sim.fragments`: whether it counts
---@field file? string name, without ending, of the table (.csv) and picture (.svg) in output.dir

---The size distribution of fragments, by area; size √(4A/π). Returns `sizes` (m) and `passing` (part of the area in fragments up to that size), `x20`, `x50`, `x80` (m; between sizes straight in ln x), `count`, `area` (m2), `floor` (m, the same median of single blocks: the mesh lets nothing be finer) and `single` (part of the area in fragments that are one block: the nearer to 1 the more the curve is the mesh's), and from three sizes on `rosin_rammler = { x50, n, residual }`, P = 1 − exp(−ln 2·(x/x50)^n) (Rosin & Rammler 1933), and `swebrec = { x50, xmax, b, residual }`, P = 1/(1 + (ln(xmax/x)/ln(xmax/x50))^b) (Ouchterlony 2005), xmax the largest fragment: least squares in P, weighted by area; residual: root of the mean square, in P.
---@param fields talus.fragmentation
---@return talus.fragmentation
function talus.blast.fragmentation(fields) end

---@class talus.pile
---@field regions? (string|talus.region)[]|table which, by name or themselves
---@field moved? number m; >= 0; only blocks that have moved as far as this
---@field where? function `function(block)`: whether it belongs to the pile
---@field ground? number|function height of the ground, a number or `function(x)`
---@field direction? 1|-1 of the throw, along x
---@field face? number m; x from which throw is counted
---@field line? number m; x beyond which rock counts as cast
---@field spacing? number m; > 0; of the profile
---@field file? string name, without ending, of the profile (.csv) and picture (.svg) in output.dir

---The muck pile as it lies now. Returns the profile `x`, `top`, `ground` (m; cells of `spacing`, at their middles; where nothing lies top = ground); `height` (m, largest top − ground) at `crest`; `toe` (x at which the profile that goes on from the crest ends) and `throw` (m, from the face to it); `shift` ({x, y}, m, of the centroid); `bulk` (m2, between top and ground), `solid` (m2, area of the blocks), `swell` (bulk/solid); `cast` (part of the solid area beyond the line); `farthest` ({block, x, distance} from the face) and `highest` (sim.highest, of the whole run).
---@param fields talus.pile
---@return talus.pile
function talus.blast.pile(fields) end

---@class talus.vibration
---@field at? string|number[] where R is counted from: a charge's name or a point
---@field mass? number kg; > 0; W, charge per delay (and metre)
---@field probes? (string)[]|table which
---@field file? string name, without ending, of the table (.csv) and picture (.svg) in output.dir

---Peak particle velocity at the probes, the largest |v| after any step, over the scaled distance R/√W, and PPV = K (R/√W)^-β by a straight line through the logarithms (Duvall & Fogelson 1962). Returns `points`, a list of `{ name, distance, scaled, ppv, time }`, nearest first, `K`, `beta`, `residual` (root mean square of ln PPV). Waves of a plane scene spread as from a line of holes: β is smaller than in the field.
---@param fields talus.vibration
---@return talus.vibration
function talus.blast.vibration(fields) end

---@class talus.backbreak
---@field line number|talus.line an upright line at this x, or a `talus.line`
---@field behind? "left"|"right" the side of the line that is behind: of a `talus.line` as seen along it, of an upright one as seen upwards
---@field regions? (string|talus.region)[]|table which, by name or themselves
---@field file? string name, without ending, of the table (.csv) and picture (.svg) of the length of failed bonds over their least distance behind the line in output.dir

---Damage behind a line, by where joints lay at the start. Returns `length`, `tension`, `shear` (m of failed bonds), `area` (m2 of the blocks beside them), `depth` (m, of the farthest behind the line).
---@param fields talus.backbreak
---@return talus.backbreak
function talus.blast.backbreak(fields) end

---@class talus.compression
---@field material talus.material of specimen and plates
---@field joint talus.joint of its bonds
---@field size number m; > 0; edge of its triangles
---@field width? number m; > 0; of the specimen
---@field height? number m; > 0; of the specimen
---@field pressure? number Pa; >= 0; on its sides
---@field strain? number in (0, 0.2); to which the plate goes where the rock does not break before
---@field steps? integer in [2, 10000]; even increments of the plate's way
---@field keep? number in (0, 1); the test ends when the load has fallen to this part of its highest
---@field title? string for output
---@field output? talus.output|table as of a simulation
---@field file? string name, without ending, of the curve as table (.csv) and picture (.svg) in output.dir

talus.lab = {}

---Compresses a rectangle of bonded triangles between two plates without friction, the upper one moved; with `pressure` on its sides, which come first, a biaxial test. Returns `strength` (Pa, the highest axial stress, load over width), `young` (Pa, slope of axial stress over strain below half of it; with plane strain E/(1 − ν²)), `strain` and `stress` (lists, compression positive), `broke`, `collapsed` (a piece came free, where a static run ends: the rock might have borne more), `width`, `height` and the simulation `sim`.
---@param fields talus.compression
---@return talus.compression
function talus.lab.compression(fields) end

---@class talus.brazilian
---@field material talus.material of specimen and plates
---@field joint talus.joint of its bonds
---@field size number m; > 0; edge of its triangles
---@field diameter? number m; > 0; of the disc
---@field steps? integer in [2, 10000]; even increments of the plate's way
---@field keep? number in (0, 1); the test ends when the load has fallen to this part of its highest
---@field title? string for output
---@field output? talus.output|table as of a simulation

---Splits a disc with two flats of 7.2° between plates without friction. Returns `strength` (Pa, 2P/(πD)·(sin 2a/a − 1), a = 3.6°, of the highest load P), `load` (N/m), `diameter`, `broke`, `fell` (to `keep` of its peak before the way of the plate ended: else the strength may be that of the halves) and the simulation `sim`.
---@param fields talus.brazilian
---@return talus.brazilian
function talus.lab.brazilian(fields) end

---@class talus.calibrate
---@field material talus.material of specimen and plates
---@field ucs number Pa; > 0; wanted uniaxial compressive strength
---@field tensile number Pa; > 0; wanted Brazilian tensile strength
---@field size number m; > 0; edge of its triangles
---@field friction? number rad; in [0, 1.570796327); of the joints; the first guess where a confined strength is given
---@field confined? talus.confined|table a strength under pressure
---@field residual? talus.residual|table what failed bonds still carry, in the tests
---@field across? integer in [5, 100]; triangle edges across the width of the compressed specimen; the disc has twice as many across its diameter
---@field meshes? integer in [1, 20]; the mean of as many meshes, each 2 % finer
---@field tolerance? number in (0, 0.5); part by which strengths may miss
---@field most? integer in [1, 50]; rounds before it gives up, with the best so far

---Joint values that give wanted strengths on a mesh of a given size, by repeated small tests (`talus.lab`): cohesion from the uniaxial strength, tension from the Brazilian one, friction from a confined strength where one is given. Returns `joint` (`{ friction, cohesion, tension }`, fields for talus.joint), `reached` (`{ young, ucs, tensile, confined }`, Pa, as measured with these values), `off` (largest part by which a strength misses), `rounds`, `converged` and where that is false `reason`: also a test that finds no strength or stops ends it so. Young's modulus needs no joint values: bonds add no compliance. What it cannot reach: a Brazilian strength above about a tenth of the uniaxial one, as flats of 7.2° are crushed before the disc splits (`converged` is false then, `reached` says what came of it). Brittle strengths scatter by some per cent from mesh to mesh (`meshes`).
---@param fields talus.calibrate
---@return table
function talus.calibrate(fields) end

---@class talus.confined
---@field pressure number Pa; > 0; at the sides
---@field strength number Pa; > 0; the axial stress it bears; above ucs and above the pressure

---@class talus.refine
---@field scene function `function(size)` that returns the simulation, `size` being what to give as `mesh = { size = size }`: a number first, then a function of x and y
---@field error? number in (0, 0.5]; wanted, relative, of the whole scene
---@field size number m; > 0; edge of the first mesh; none becomes longer
---@field max_blocks? integer >= 1; most blocks of a mesh
---@field rounds? integer in [1, 50]; most meshes
---@field log? boolean a line for each round

---Runs a static scene on one mesh after another until the estimated error of its stress is small enough: `sim.error.relative`, in energy norm. Sizes follow from the estimate so that every block has the same error (theory, § 8). Returns the last simulation `sim`, `error` (estimated, reached), `wanted`, `blocks`, `seconds` (CPU, of all rounds), `rounds` (a list of `{ blocks, error, seconds }`, seconds so far) and `size`, the function of x and y of the last mesh. Where the error would need more than `max_blocks` it ends with an error that says how many. A load or support at a point gives an infinite energy, which no mesh resolves: put it on an edge.
---@param fields talus.refine
---@return talus.refine
function talus.refine(fields) end

---@class talus.study
---@field scene string the scene's file, from the study's folder on
---@field parameters? table<string, any> a grid: `{ friction = {20, 30, 40}, size = talus.range(0.1, 0.4, 4) }`, names as in the scene's `talus.param`
---@field cases? (table<string, any>)[]|table values that go together: `{ { width = 1, height = 2 }, { width = 2, height = 3 } }`
---@field sample? talus.latin_hypercube points spread over ranges
---@field seeds? integer|(integer)[]|table repetitions of every run with another seed: how many (1, 2, …), or a list of seeds; plots show their means
---@field seed_parameter? string the scene's parameter that takes the seed
---@field where? function `function(p)`, the parameters of a run: whether it is made
---@field order? (string)[]|table parameters as the table's columns and the plots have them: the first varies slowest in the table and is the plots' x axis
---@field collect? table<string, any> columns of the table: a path in run.json (`"energy.kinetic"`), a table of the fields of collect, or a `function(run)`
---@field dir? string folder of the results
---@field title? string of the results page
---@field time_limit? number s; > 0; wall time after which a run is stopped
---@field slurm? talus.slurm|table what a run asks of Slurm, with `--slurm`

---Many runs of one scene, made by `talus sweep study.lua`, see [sweeps](sweeps.md). The runs are every combination of `cases`, `parameters`, `sample` and `seeds`; a parameter is in one of them.
---@param fields talus.study
---@return talus.study
function talus.study(fields) end

---@class talus.collect
---@field run? string path in run.json: `"sizes.blocks"`, `"checks[1].value"`, `"results.x50"`
---@field history? string column of history.csv, without its unit: `"tip.uy"`, `"kinetic_energy"`
---@field take? "last"|"first"|"max"|"min"|"mean"|"largest" of the history; `largest`: by its absolute value
---@field at? number s; >= 0; the history at this time, straight between output times
---@field value? function `function(run)` of `run.json`, `run.history["tip.uy"]`, `run.history.time`, `run.parameters`, `run:table("pile")`, `run:simulation(2)`, `run.name`; returns a number, a text, true or false
---@field simulation? integer >= 1; of the scene, where it makes several
---@field unit? string for table and plots
---@field label? string for the plots; `_` begins a subscript
---@field log? boolean logarithmic axis

---@class talus.latin_hypercube
---@field n integer in [1, 100000]; how many
---@field seed? integer in [0, 4294967295]; the same seed gives the same points
---@field ranges table<string, any> `{ friction = {20, 40}, cohesion = {1e3, 1e6} }`
---@field log? (string)[]|table names of those that are spread over the logarithm
---@field whole? (string)[]|table names of those that take whole numbers

---n points spread over ranges: each range is cut into n equal parts, and each part has one point (McKay, Beckman & Conover 1979).
---@param fields talus.latin_hypercube
---@return talus.latin_hypercube
function talus.latin_hypercube(fields) end

---@class talus.slurm
---@field time? number s; > 0; `--time`, rounded up to minutes
---@field memory? number MB; > 0; `--mem`
---@field cpus? integer >= 1; `--cpus-per-task`, threads that a run may use
---@field partition? string `--partition`
---@field account? string `--account`
---@field at_once? integer >= 1; runs at a time
---@field extra? (string)[]|table more options of sbatch: `{ "--qos=long" }`

---@class talus.block
---@field id any ; number of the block, from 1, in VTK too
---@field region any ; name of its region
---@field material any ; name of its material
---@field vertices any ; corners now, list of {x, y} (m); of one of second order, where anything may touch, with the middles of its edges, and more of slender ones
---@field order any ; 0 rigid or held, 1 first order, 2 second order
---@field fixed any ; 1 for a held block
---@field fragment any ; which fragment it belongs to, from 0: blocks that hang together by intact bonds
---@field area any m2; area now
---@field density any kg/m3; density of its material
---@field mass any kg/m; mass per metre of thickness
---@field centroid any m; place of the centroid now
---@field displacement any m; displacement of the centroid since the start
---@field u any m; magnitude of the centroid's displacement
---@field ux any m; displacement along x
---@field uy any m; displacement along y
---@field velocity any m/s; velocity of the centroid
---@field speed any m/s; magnitude of the centroid's velocity
---@field rotation any rad; rotation since the start, counter-clockwise
---@field spin any rad/s; rate of rotation
---@field strain any ; exx, eyy, gxy since the start, global axes
---@field exx any ; strain along x
---@field eyy any ; strain along y
---@field gxy any ; shear strain (engineering)
---@field stress any Pa; sxx, syy, sxy of the block, tension positive
---@field sxx any Pa; stress along x, tension positive
---@field syy any Pa; stress along y, tension positive
---@field sxy any Pa; shear stress
---@field szz any Pa; stress out of the plane: ν(sxx + syy) in plane strain, 0 in plane stress
---@field s1 any Pa; principal stress, the most tensile, tension positive
---@field s2 any Pa; principal stress, the most compressive, tension positive
---@field s1_direction any rad; direction of s1 against +x
---@field mises any Pa; von Mises stress
---@field stress_smooth any Pa; sxx, syy, sxy at the centroid, smoothed
---@field sxx_smooth any Pa; stress along x at the centroid, smoothed
---@field syy_smooth any Pa; stress along y at the centroid, smoothed
---@field sxy_smooth any Pa; shear stress at the centroid, smoothed
---@field s1_smooth any Pa; principal stress, the most tensile, smoothed
---@field s2_smooth any Pa; principal stress, the most compressive, smoothed
---@field stress_error any Pa; estimated error of its stress, mean in energy over the block: √(E e²/A), e² = ∫ Δσ·D⁻¹Δσ dA; 0 where nothing is smoothed

---@class talus.joint_state
---@field id any ; number of the joint, from 1, in VTK too
---@field block_a any ; number of the block on its left, from 1, in VTK too
---@field block_b any ; number of the block on its right, from 1, in VTK too
---@field state any ; "intact" or "failed"
---@field mode any ; how it failed: "none", "tension" or "shear"; a real joint never did
---@field crack any ; what it was when it failed: "none", "initiated", "propagated" or "coalesced"
---@field kind any ; "exact" or "spring"
---@field trace any ; joint trace it lies on, from 1; 0 for a joint of the mesh
---@field property any ; name of its talus.joint
---@field utilisation any ; part of its strength that is used, by its criterion; of a failed one: when it failed
---@field failed_at any s; time of failure
---@field cohesion any Pa; cohesion now
---@field tension any Pa; tensile strength now
---@field friction any rad; friction angle now
---@field length any m; length at the start
---@field normal_traction any Pa; mean normal traction, tension positive
---@field shear_traction any Pa; mean shear traction
---@field traction_jump any Pa; what the stresses of its blocks disagree by in their traction on it, root mean square; 0 beside a rigid one
---@field opening any m; mean opening
---@field slip any m; mean sliding
---@field mid any m; place of its middle now
---@field mid_start any m; place of its middle at the start

---@class talus.contact_state
---@field id any ; number of the contact, from 1, in VTK too; valid until the next step
---@field block_i any ; number of the block of the vertex, from 1; `block_a` in VTK
---@field block_j any ; number of the block of the edge, from 1; `block_b` in VTK
---@field vertex any ; corner of block_i, from 1
---@field edge any ; edge of block_j, from 1; it begins at that corner
---@field state any ; "open", "stick" or "slip"
---@field kind any ; "angle-angle", "angle-edge" or "edge-edge"
---@field property any ; name of its talus.joint
---@field length any m; part of the interface it stands for
---@field gap any m; gap, negative when pressed together
---@field normal_force any N/m; normal force, positive when pressed together
---@field shear_force any N/m; friction force along the edge
---@field normal_traction any Pa; -normal_force / length: tension positive, like every traction; 0 without length
---@field shear_traction any Pa; shear_force / length; 0 without length
---@field stretch any m; elastic part of the sliding
---@field slip any m; plastic part of the sliding, accumulated
---@field point any m; place of the vertex now

---@class talus.probe_state
---@field name any ; its name
---@field block any ; 1-based number of the block it sits on
---@field x any m; place now
---@field y any m; place now
---@field ux any m; displacement along x
---@field uy any m; displacement along y
---@field vx any m/s; velocity along x
---@field vy any m/s; velocity along y
---@field speed any m/s; magnitude of the velocity
---@field peak_speed any m/s; highest speed of the motion so far, peak particle velocity; after each step
---@field peak_at any s; when that was
---@field sxx any Pa; stress along x, tension positive; smoothed where the run has a recovery
---@field syy any Pa; stress along y, smoothed
---@field sxy any Pa; shear stress, smoothed
---@field s1 any Pa; principal stress, the most tensile, smoothed
---@field s2 any Pa; principal stress, the most compressive, smoothed
---@field raw_sxx any Pa; stress along x of its block
---@field raw_syy any Pa; stress along y of its block
---@field raw_sxy any Pa; shear stress of its block

---@class talus.run
---@field time number s
---@field dt number s, of the last step
---@field finished boolean
---@field last table
---@field energy table<string, number> J/m
---@field totals table
---@field state table
---@field blocks table<integer, talus.block>
---@field joints table<integer, talus.joint_state>
---@field contacts table<integer, talus.contact_state>
---@field probes table<string, talus.probe_state>
---@field cracks table
---@field fragments table
---@field reactions table
---@field charges table
---@field highest table?
---@field strained table?
---@field collapsed boolean
local run = {}

---@return string
function run:explain(...) end

---@return talus.fix
function run:fix(...) end

---@return string
function run:hash(...) end

---@return talus.joint
function run:joint(...) end

---@return table
function run:load(...) end

function run:log(...) end

---@return talus.material
function run:material(...) end

function run:output(...) end

function run:plot(...) end

---@return talus.region
function run:region(...) end

function run:restore(...) end

---@return table
function run:run(...) end

---@return userdata
function run:save(...) end

---@return table?
function run:step(...) end

---@return fun(): table?
function run:steps(...) end

function run:stop(...) end

function run:table(...) end

---Factors to SI: 35*talus.units.GPa.
talus.units = {
  m = 1,  -- metre
  mm = 0.001,  -- millimetre
  cm = 0.01,  -- centimetre
  km = 1000,  -- kilometre
  s = 1,  -- second
  ms = 0.001,  -- millisecond
  us = 9.9999999999999995e-07,  -- microsecond
  min = 60,  -- minute
  kg = 1,  -- kilogram
  g = 0.001,  -- gram
  t = 1000,  -- tonne
  N = 1,  -- newton
  kN = 1000,  -- kilonewton
  MN = 1000000,  -- meganewton
  Pa = 1,  -- pascal
  kPa = 1000,  -- kilopascal
  MPa = 1000000,  -- megapascal
  GPa = 1000000000,  -- gigapascal
  J = 1,  -- joule
  kJ = 1000,  -- kilojoule
  MJ = 1000000,  -- megajoule
  rad = 1,  -- radian
  deg = 0.017453292519943295,  -- degree
}

---A parameter of the scene, from the command line with -p name=value.
---@generic T
---@param name string
---@param default T
---@param meaning? string
---@return T
function talus.param(name, default, meaning) end

return talus
