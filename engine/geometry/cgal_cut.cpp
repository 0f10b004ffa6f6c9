#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_non_caching_segment_basic_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>

#include "geometry/network.h"
#include "geometry/polygon.h"

namespace talus {
namespace {

struct FaceData {
  bool reached = false, inside = false;
  bool stays = false;  // a sliver with no neighbour to go to
};

// The network's edges meet at common ends only, so the arrangement needs exact predicates and constructs nothing.
// Vertices carry the index of their point, halfedges their trace (-1: boundary).
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Arr_non_caching_segment_basic_traits_2<Kernel>;
using Arrangement = CGAL::Arrangement_2<Traits, CGAL::Arr_extended_dcel<Traits, int, int, FaceData>>;
using Halfedge = Arrangement::Halfedge_handle;
using Face = Arrangement::Face_handle;
using Vertex = Arrangement::Vertex_handle;

template <class Visit>
void for_each_halfedge(Face face, const Visit& visit) {
  const auto around = [&](Arrangement::Ccb_halfedge_circulator h) {
    const auto first = h;
    do {
      visit(Halfedge(h));
    } while (++h != first);
  };
  if (face->has_outer_ccb()) around(face->outer_ccb());
  for (auto inner = face->inner_ccbs_begin(); inner != face->inner_ccbs_end(); ++inner) around(*inner);
}

// One cut, from the network of input edges to the cells.
class Cutter {
 public:
  explicit Cutter(const TessellationInput& input);
  Tessellation run(double least_area);

 private:
  void number_vertices();
  void label_edges();
  void mark_inside();
  void remove_dangling();
  double area(Face face) const;
  Face smallest_sliver(double least_area);
  void merge_into_neighbour(Face sliver);
  bool needed(Vertex v) const;
  void add_cell(Face face);
  void label_interfaces();
  [[noreturn]] void refuse(const Vec2& at, const char* what) const;

  Network network_;
  const std::vector<Vec2>& points_;  // of the network
  Arrangement arrangement_;
  Tessellation result_;
  std::vector<std::vector<int>> traces_;  // traces_[cell][i]: of the edge that leaves point i of the cell
};

Cutter::Cutter(const TessellationInput& input) : network_(make_network(input)), points_(network_.points) {
  std::vector<Traits::X_monotone_curve_2> edges;
  for (const auto& [p, q, trace] : network_.edges)
    edges.emplace_back(Kernel::Point_2(points_[p].x(), points_[p].y()),
                       Kernel::Point_2(points_[q].x(), points_[q].y()));
  CGAL::insert_non_intersecting_curves(arrangement_, edges.begin(), edges.end());
}

void Cutter::number_vertices() {
  std::map<std::pair<double, double>, int> index;
  for (std::size_t i = 0; i < points_.size(); ++i)
    index.emplace(std::pair(points_[i].x(), points_[i].y()), static_cast<int>(i));
  for (Vertex v : arrangement_.vertex_handles()) v->set_data(index.at({v->point().x(), v->point().y()}));
}

void Cutter::label_edges() {
  std::map<std::pair<int, int>, int> traces;
  for (const auto& [p, q, trace] : network_.edges) traces.emplace(std::minmax(p, q), trace);
  for (Halfedge h : arrangement_.edge_handles()) {
    const int trace = traces.at(std::minmax(h->source()->data(), h->target()->data()));
    h->set_data(trace);
    h->twin()->set_data(trace);
  }
}

// From the unbounded face inwards: only the boundary, not a trace, divides inside from outside.
void Cutter::mark_inside() {
  std::vector<Face> front{arrangement_.unbounded_face()};
  front.back()->data().reached = true;
  while (!front.empty()) {
    const Face face = front.back();
    front.pop_back();
    for_each_halfedge(face, [&](Halfedge h) {
      const Face next = h->twin()->face();
      if (next->data().reached) return;
      next->data().reached = true;
      next->data().inside = face->data().inside != (h->data() < 0);
      front.push_back(next);
    });
  }
}

void Cutter::remove_dangling() {
  std::vector<Halfedge> dangling;
  for (Halfedge h : arrangement_.edge_handles())
    if (h->face() == h->twin()->face()) dangling.push_back(h);
  for (Halfedge h : dangling) arrangement_.remove_edge(h);
}

// Loops of holes run clockwise and so take their area off.
double Cutter::area(Face face) const {
  const Vec2 origin = points_[face->outer_ccb()->source()->data()];
  double doubled = 0;
  for_each_halfedge(face, [&](Halfedge h) {
    doubled += cross(points_[h->source()->data()] - origin, points_[h->target()->data()] - origin);
  });
  return doubled / 2;
}

Face Cutter::smallest_sliver(double least_area) {
  Face smallest;
  for (Face face : arrangement_.face_handles()) {
    if (!face->data().inside || face->data().stays) continue;
    const double a = area(face);
    if (a >= least_area) continue;
    least_area = a;
    smallest = face;
  }
  return smallest;
}

void Cutter::merge_into_neighbour(Face sliver) {
  struct Shared {
    Face neighbour;
    double length = 0;
    std::vector<Halfedge> edges;
  };
  std::vector<Shared> shares;
  for_each_halfedge(sliver, [&](Halfedge h) {
    const Face neighbour = h->twin()->face();
    if (!neighbour->data().inside) return;
    auto share = std::find_if(shares.begin(), shares.end(), [&](const Shared& s) { return s.neighbour == neighbour; });
    if (share == shares.end()) share = shares.insert(shares.end(), Shared{neighbour, 0, {}});
    share->length += (points_[h->target()->data()] - points_[h->source()->data()]).norm();
    share->edges.push_back(h);
  });
  if (shares.empty()) {
    sliver->data().stays = true;
    return;
  }
  const auto longest = std::max_element(shares.begin(), shares.end(),
                                        [](const Shared& s, const Shared& t) { return s.length < t.length; });
  for (Halfedge h : longest->edges) arrangement_.remove_edge(h);
}

// A point between two edges in line is needed only where they are of different traces, or where it was given.
bool Cutter::needed(Vertex v) const {
  if (v->data() < network_.boundary_points || v->degree() != 2) return true;
  const auto in = v->incident_halfedges(), out = std::next(in);
  if (in->data() != out->data()) return true;
  const Vec2 &a = points_[in->source()->data()], &b = points_[out->source()->data()];
  return distance_to_segment(a, b, points_[v->data()]) > 2 * network_.tolerance;
}

void Cutter::add_cell(Face face) {
  if (face->number_of_inner_ccbs() > 0) refuse(points_[(*face->inner_ccbs_begin())->source()->data()], "have a hole");
  std::vector<int> loop, traces;
  const auto first = face->outer_ccb();
  auto h = first;
  do {
    if (!needed(h->source())) continue;
    loop.push_back(h->source()->data());
    traces.push_back(h->data());
  } while (++h != first);
  std::vector<int> sorted = loop;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) refuse(points_[*twice], "touch itself");
  result_.cells.push_back(std::move(loop));
  traces_.push_back(std::move(traces));
}

void Cutter::refuse(const Vec2& at, const char* what) const {
  std::ostringstream text;
  text << "a block cut out by the traces would " << what << " at (" << at.x() << ", " << at.y()
       << "): lead a trace through to it, or leave out the traces round it, or mesh the region";
  throw std::invalid_argument(text.str());
}

void Cutter::label_interfaces() {
  for (Tessellation::Interface& i : result_.interfaces) {
    const std::vector<int>& loop = result_.cells[i.a];
    i.trace = traces_[i.a][std::find(loop.begin(), loop.end(), i.p) - loop.begin()];
  }
}

Tessellation Cutter::run(double least_area) {
  number_vertices();
  label_edges();
  mark_inside();
  remove_dangling();
  for (Face sliver = smallest_sliver(least_area); sliver != Face(); sliver = smallest_sliver(least_area))
    merge_into_neighbour(sliver);
  for (Face face : arrangement_.face_handles())
    if (face->data().inside) add_cell(face);
  result_.points = points_;
  drop_unused_points(result_);
  connect(result_);
  label_interfaces();
  return std::move(result_);
}

}  // namespace

Tessellation cut(const TessellationInput& input, double sliver) {
  return Cutter(input).run(sliver * signed_area(input.outline));
}

}  // namespace talus
