#pragma once
// A region divided into simple polygons with their shared edges. Made by `cut` (joint traces), `mesh`
// (triangles) or `pattern` (rectangles cut by diagonals).
#include <functional>
#include <string>
#include <vector>

#include "geometry/vec2.h"

namespace talus {

struct Tessellation {
  // Two cells share the straight edge p–q: cell a lies to the left of p→q, cell b to the right; a < b.
  struct Interface {
    int a, b;
    int p, q;        // indices of points
    int trace = -1;  // index of the trace it lies on, or -1
  };
  std::vector<Vec2> points;
  std::vector<std::vector<int>> cells;  // counter-clockwise, simple, no repeated point
  std::vector<Interface> interfaces;    // ordered by (a, b, p)

  Polyline outline(const std::vector<int>& cell) const {
    Polyline corners;
    for (const int p : cell) corners.push_back(points[size_t(p)]);
    return corners;
  }
};

struct TessellationInput {
  Polyline outline;              // counter-clockwise, simple
  std::vector<Polyline> holes;   // counter-clockwise, simple, inside the outline, touching nothing
  std::vector<Polyline> traces;  // cut lines; parts outside the outline and inside holes are ignored
};

// Cells are the faces of the arrangement of outline, holes and traces (CGAL Arrangement_2, exact).
// Points nearer than 1e-9 of the outline's extent are one, and a trace that passes a point or an edge so closely
// goes through it; the boundary does not move, and every point of the input that is kept is so to the bit.
// Trace ends that bound no face are dropped, collinear points kept only where an interface needs them or the
// outline or a hole has them. Faces of less than `sliver` times the outline's area are merged into the neighbour
// with the longest shared edge. Interfaces where traces coincide carry the lowest.
// Throws std::invalid_argument with words for the user when a cell would have a hole or touch itself, or a
// trace has a point that is not finite.
Tessellation cut(const TessellationInput& input, double sliver = 1e-10);

// Conforming Delaunay triangles (CGAL), with outline, holes and traces as constrained edges: a trace that ends in
// the rock is there as interfaces with its index. Points of outline and holes are kept to the bit, and so are
// those of traces, which join as in `cut` where they come closer than 0.02 of the size on the boundary.
// size_at(point) is the wanted edge length (m). Measured on rectangles, discs and graded fields: the mean edge is
// 0.99 to 1.04 of it, nine in ten lie within 0.75 and 1.4, none is above 1.45, none below 0.5 but where the input
// itself is finer; there are 2.25 to 2.45 · ∫ dA / size² triangles. Least angle 20.7° but at narrower corners of
// the input (26 to 35° in uniform fields). 5 ms for 2500 triangles, 0.6 s for 150 000.
// Deterministic; the same scene shifted, turned or scaled gives the same triangles but for round-off.
// `most` bounds the number of triangles: more throws std::length_error, before meshing where the size alone asks
// for more, with the expected number. Throws std::invalid_argument where size_at is not positive and finite.
Tessellation mesh(const TessellationInput& input, const std::function<double(Vec2)>& size_at, long most);

// Convex grains (CGAL, Voronoi): the mean area of a grain is the square of the wanted size_at(point) (m). Sites are
// placed by the seed, with pairs mirrored at the boundary and at the traces, so that grains end there by themselves
// and share whole edges across; relaxed by Lloyd's method; and the borders between them cut as traces are. What a
// trace cuts off a grain that is thinner (2·area/perimeter) than 0.25 of the size joins the grain beside it, and edges
// shorter than 0.2 of it are closed, which moves points by no more than that. Given points are kept to the bit.
// Deterministic; the same scene shifted, turned or scaled gives the same grains but for round-off.
// Throws as `mesh` and `cut` do.
Tessellation voronoi(const TessellationInput& input, const std::function<double(Vec2)>& size_at, unsigned seed,
                     long most);

enum class Pattern { cross, diagonal, alternating };
// A rectangle (four corners, any turn) as nx × ny rectangles, each cut by both diagonals (cells bottom, right,
// top, left), by the rising one, or by rising and falling ones in turn; nx counts along the side that is most
// nearly parallel to x. Rectangles go row by row from the bottom. Corners are exact; two regions side by side with
// the same division get the same points on their common edge, to the bit. No holes, no traces.
// Throws std::invalid_argument when the outline is no rectangle.
Tessellation pattern(const Polyline& outline, Pattern kind, int nx, int ny);
// The corners of a rectangle counter-clockwise, the first edge being the one that runs most nearly along +x: nx counts
// along it.
Polyline turned_corners(Polyline corners);

// Edges of cells on the boundary of the tessellation (no interface there): cell, p, q with the cell on the left.
struct BoundaryEdge {
  int cell, p, q;
};
std::vector<BoundaryEdge> boundary_edges(const Tessellation& t);

// Fills t.interfaces from t.cells, which must conform; trace = -1 throughout. Throws std::logic_error when an
// edge has more than one cell on a side.
void connect(Tessellation& t);

// Removes the points that no cell uses, keeping the order of the others.
void drop_unused_points(Tessellation& t);

}  // namespace talus
