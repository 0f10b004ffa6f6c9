#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_2/Face_badness.h>
#include <CGAL/Triangulation_vertex_base_2.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "geometry/network.h"
#include "geometry/size_field.h"

namespace talus {
namespace {

// Relations measured over discs, rectangles and graded fields, see tessellation.h.
constexpr double longest_edge = 1.45;         // of a triangle, wanted edge lengths
constexpr double triangles_per_square = 2.4;  // triangles = this · ∫ dA / size²
constexpr double shape_bound = 0.125;         // squared sine of the least angle: 20.7°
// rad: below, its square nears round-off, and the mesher can no longer cut both sides abreast of each other.
constexpr double least_angle = 1e-6;
constexpr double closest_traces = 0.02;  // wanted edge lengths: traces closer than that are merged
constexpr double narrow_angle = 0.75;    // rad: edges that meet at less are left whole, see `Mesher::divide`

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// A vertex with the index of its point. The time stamp makes CGAL order vertices by age, not by address: the
// mesh would else differ from run to run.
template <class Base = CGAL::Triangulation_vertex_base_2<Kernel>>
class VertexBase : public Base {
 public:
  using Base::Base;
  template <class Tds>
  struct Rebind_TDS {
    using Other = VertexBase<typename Base::template Rebind_TDS<Tds>::Other>;
  };

  int index = -1;

  using Has_timestamp = CGAL::Tag_true;
  std::size_t time_stamp() const { return time_stamp_; }
  void set_time_stamp(std::size_t stamp) { time_stamp_ = stamp; }

 private:
  std::size_t time_stamp_ = static_cast<std::size_t>(-1);
};

using FaceBase = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase<>, FaceBase>,
                                               CGAL::Exact_predicates_tag>;
using Vertex = Triangulation::Vertex_handle;
using Face = Triangulation::Face_handle;

Vec2 position(Vertex v) {
  return {v->point().x(), v->point().y()};
}
Kernel::Point_2 exact(const Vec2& p) {
  return {p.x(), p.y()};
}

// CGAL's criteria concept: a triangle is bad when its longest edge exceeds the size field's bound at its
// centroid, or its least angle is small. Too long comes before badly shaped, the worst first.
class Criteria {
 public:
  struct Quality {
    double length = 0;  // longest edge / bound
    double sine2 = 1;   // of the least angle
    bool operator<(const Quality& other) const {
      if (length > 1 || other.length > 1) return length > other.length;
      return sine2 < other.sine2;
    }
  };

  class Is_bad {
   public:
    explicit Is_bad(const SizeField& size) : size_(size) {}
    CGAL::Mesh_2::Face_badness operator()(const Quality& q) const {
      if (q.length > 1) return CGAL::Mesh_2::IMPERATIVELY_BAD;
      return q.sine2 < shape_bound ? CGAL::Mesh_2::BAD : CGAL::Mesh_2::NOT_BAD;
    }
    CGAL::Mesh_2::Face_badness operator()(const Face& face, Quality& q) const {
      const Vec2 a = position(face->vertex(0)), b = position(face->vertex(1)), c = position(face->vertex(2));
      double sides[] = {(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()};
      std::sort(sides, sides + 3);
      const double bound = longest_edge * size_.at((a + b + c) / 3);
      const double doubled_area = cross(b - a, c - a);
      const double longest = std::sqrt(sides[2]);
      if (doubled_area < MeshFrame::resolution * longest) return CGAL::Mesh_2::NOT_BAD;  // flat in this frame
      q.length = longest / bound;
      q.sine2 = doubled_area * doubled_area / (sides[1] * sides[2]);
      return (*this)(q);
    }

   private:
    const SizeField& size_;
  };

  explicit Criteria(const SizeField& size) : size_(&size) {}
  Is_bad is_bad_object() const { return Is_bad(*size_); }

 private:
  const SizeField* size_;
};

class Mesher {
 public:
  Mesher(const TessellationInput& input, const std::function<double(Vec2)>& size_at, long most)
      : frame_(MeshFrame::about_box(input.outline)),
        size_(frame_, size_at),
        network_(make_network(input, closest_traces * frame_.unit() * least_size(input))),
        most_(most) {}
  Tessellation run(const TessellationInput& input);

 private:
  // Part of edge `edge` of the network between two points.
  struct Piece {
    int edge, p, q;
  };

  double least_size(const TessellationInput& input) const;
  void check_clearance(const TessellationInput& input) const;
  void place_given_points();
  std::vector<bool> edges_at_narrow_angles() const;
  void leave_whole();
  void divide();
  void triangulate();
  Vertex next_along(Vertex at, Vertex to) const;
  void label_edges();
  void add_point_on_edge(Vertex v, const Network::Edge& edge);
  void mark_domain();
  void estimate_triangles();
  void estimate_edges();
  void refine();
  long count_triangles() const;
  Tessellation result();
  [[noreturn]] void refuse_angle(int point) const;
  [[noreturn]] void refuse_field() const;
  [[noreturn]] void refuse_mesh() const;

  static std::uint64_t key(int p, int q) {
    const auto [low, high] = std::minmax(p, q);
    return static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
  }

  MeshFrame frame_;
  SizeField size_;
  Network network_;
  long most_;
  double expected_ = 0;                            // number of triangles by the size field alone
  std::vector<Vec2> world_, local_;                // by point index
  std::vector<Piece> pieces_;                      // of all constraints
  std::vector<Vertex> vertices_;                   // of the points that pieces_ refer to
  std::unordered_map<std::uint64_t, int> traces_;  // of constrained edges, -1: boundary; by key()
  Triangulation triangulation_;
};

// At the points of the boundary, where sizes are graded to.
double Mesher::least_size(const TessellationInput& input) const {
  double least = std::numeric_limits<double>::infinity();
  const auto look_at = [&](const Polyline& loop) {
    for (const Vec2& p : loop) least = std::min(least, size_.at(frame_.local_of_given(p)));
  };
  look_at(input.outline);
  for (const Polyline& hole : input.holes) look_at(hole);
  return std::min(least, 1.0);
}

void Mesher::place_given_points() {
  for (const Vec2& p : network_.points) {
    world_.push_back(p);
    local_.push_back(frame_.local_of_given(p));
  }
}

void Mesher::leave_whole() {
  for (int e = 0; e < static_cast<int>(network_.edges.size()); ++e)
    pieces_.push_back({e, network_.edges[e].p, network_.edges[e].q});
}

std::vector<bool> Mesher::edges_at_narrow_angles() const {
  struct Ray {
    int point;
    double angle;
    int edge;
  };
  std::vector<Ray> rays;
  for (int e = 0; e < static_cast<int>(network_.edges.size()); ++e) {
    const auto [p, q, trace] = network_.edges[e];
    const Vec2 along = local_[q] - local_[p];
    rays.push_back({p, std::atan2(along.y(), along.x()), e});
    rays.push_back({q, std::atan2(-along.y(), -along.x()), e});
  }
  std::sort(rays.begin(), rays.end(), [](const Ray& r, const Ray& s) {
    return std::tie(r.point, r.angle, r.edge) < std::tie(s.point, s.angle, s.edge);
  });
  std::vector<bool> narrow(network_.edges.size(), false);
  for (std::size_t first = 0, end; first < rays.size(); first = end) {
    for (end = first; end < rays.size() && rays[end].point == rays[first].point;) ++end;
    for (std::size_t i = first; i < end; ++i) {
      const Ray &ray = rays[i], &next = rays[i + 1 < end ? i + 1 : first];
      const double angle = next.angle - ray.angle + (i + 1 < end ? 0 : 2 * M_PI);
      if (angle < least_angle) refuse_angle(ray.point);
      if (angle < narrow_angle) narrow[ray.edge] = narrow[next.edge] = true;
    }
  }
  return narrow;
}

// A thin or finely traced region has more edges on its constraints than its area asks for.
void Mesher::estimate_edges() {
  double edges = 0;
  for (const auto& [p, q, trace] : network_.edges) edges += size_.edges_along(local_[p], local_[q]);
  expected_ = std::max(expected_, edges);
  if (expected_ > 1.2 * static_cast<double>(most_)) refuse_field();
}

// Cuts the constraints into edges of the wanted length, more even than the mesher's halving. Not where two
// meet at a narrow angle: there it cuts both at the same distances from the corner, and cuts of ours, not
// abreast of each other, would make it refine without need.
void Mesher::divide() {
  pieces_.clear();
  const std::vector<bool> narrow = edges_at_narrow_angles();
  for (int e = 0; e < static_cast<int>(network_.edges.size()); ++e) {
    const auto [p, q, trace] = network_.edges[e];
    int from = p;
    if (!narrow[e]) {
      for (double t : size_.divisions(local_[p], local_[q])) {
        const int to = static_cast<int>(world_.size());
        local_.push_back(local_[p] + t * (local_[q] - local_[p]));
        world_.push_back(world_[p] + t * (world_[q] - world_[p]));
        pieces_.push_back({e, from, to});
        from = to;
      }
    }
    pieces_.push_back({e, from, q});
  }
}

void Mesher::triangulate() {
  triangulation_.clear();
  vertices_.assign(world_.size(), Vertex());
  Face near;
  const auto insert = [&](int p) {
    if (vertices_[p] != Vertex()) return;
    vertices_[p] = triangulation_.insert(exact(local_[p]), near);
    if (vertices_[p]->index < 0) vertices_[p]->index = p;
    near = vertices_[p]->face();
  };
  for (const Piece& piece : pieces_) {
    insert(piece.p);
    insert(piece.q);
  }
  for (const Piece& piece : pieces_)
    if (vertices_[piece.p] != vertices_[piece.q])
      triangulation_.insert_constraint(vertices_[piece.p], vertices_[piece.q]);
}

// The end of the constrained edge at `at` that leads most nearly towards `to`.
Vertex Mesher::next_along(Vertex at, Vertex to) const {
  const Vec2 towards = position(to) - position(at);
  Vertex best;
  double least = 0;
  auto edge = triangulation_.incident_edges(at);
  const auto first = edge;
  do {
    if (triangulation_.is_infinite(edge) || !triangulation_.is_constrained(*edge)) continue;
    const Vertex one = edge->first->vertex(Triangulation::ccw(edge->second));
    const Vertex other = one == at ? edge->first->vertex(Triangulation::cw(edge->second)) : one;
    const Vec2 step = position(other) - position(at);
    const double off = std::abs(cross(towards, step)) / step.norm();
    if (step.dot(towards) <= 0 || (best != Vertex() && off >= least)) continue;
    best = other;
    least = off;
  } while (++edge != first);
  if (best == Vertex()) throw std::logic_error("mesh: a constrained edge is lost");
  return best;
}

// A point the mesher put on an edge, moved from the frame's line onto the given one.
void Mesher::add_point_on_edge(Vertex v, const Network::Edge& edge) {
  const Vec2 along = local_[edge.q] - local_[edge.p], local = position(v);
  const double t = (local - local_[edge.p]).dot(along) / along.squaredNorm();
  v->index = static_cast<int>(world_.size());
  local_.push_back(local);
  world_.push_back(world_[edge.p] + t * (world_[edge.q] - world_[edge.p]));
}

void Mesher::label_edges() {
  traces_.clear();
  for (const Piece& piece : pieces_) {
    const Network::Edge& edge = network_.edges[piece.edge];
    for (Vertex at = vertices_[piece.p]; at != vertices_[piece.q];) {
      const Vertex next = next_along(at, vertices_[piece.q]);
      if (next->index < 0) add_point_on_edge(next, edge);
      traces_.emplace(key(at->index, next->index), edge.trace);
      at = next;
    }
  }
}

// From infinity inwards, over boundary edges only: traces are constraints but bound nothing.
void Mesher::mark_domain() {
  for (Face face : triangulation_.all_face_handles()) face->set_in_domain(false);
  std::vector<Face> front{triangulation_.infinite_face()};
  std::unordered_map<Face, bool, CGAL::Handle_hash_function> inside{{front.back(), false}};
  while (!front.empty()) {
    const Face face = front.back();
    front.pop_back();
    for (int i = 0; i < 3; ++i) {
      const Face next = face->neighbor(i);
      bool crosses = false;
      if (face->is_constrained(i)) {
        const auto trace = traces_.find(key(face->vertex(face->cw(i))->index, face->vertex(face->ccw(i))->index));
        crosses = trace != traces_.end() && trace->second < 0;
      }
      const auto [known, is_new] = inside.emplace(next, inside.at(face) != crosses);
      if (!is_new) continue;
      next->set_in_domain(known->second);
      front.push_back(next);
    }
  }
}

void Mesher::estimate_triangles() {
  double squares = 0;
  for (Face face : triangulation_.finite_face_handles())
    if (face->is_in_domain())
      squares += size_.squares_in(position(face->vertex(0)), position(face->vertex(1)), position(face->vertex(2)));
  expected_ = triangles_per_square * squares;
  if (expected_ > 1.2 * static_cast<double>(most_)) refuse_field();
}

long Mesher::count_triangles() const {
  long count = 0;
  for (Face face : triangulation_.finite_face_handles()) count += face->is_in_domain();
  return count;
}

void Mesher::refine() {
  CGAL::Delaunay_mesher_2<Triangulation, Criteria> mesher(triangulation_, Criteria(size_));
  mesher.init(true);
  constexpr int between_checks = 1024;
  for (int step = 1; mesher.step_by_step_refine_mesh(); ++step) {
    const bool may_be_too_many = 2 * static_cast<long>(triangulation_.number_of_vertices()) > most_;
    if (step % between_checks == 0 && may_be_too_many && count_triangles() > most_) refuse_mesh();
  }
  if (count_triangles() > most_) refuse_mesh();
}

void Mesher::refuse_angle(int point) const {
  std::ostringstream text;
  text.precision(8);
  text << "boundary or traces meet at (" << world_[point].x() << ", " << world_[point].y()
       << ") at an angle of less than 1e-6 rad: too narrow for a mesh";
  throw std::invalid_argument(text.str());
}

void Mesher::refuse_field() const {
  std::ostringstream text;
  text.precision(3);
  text << "about " << expected_ << " triangles";
  throw std::length_error(text.str());
}

void Mesher::refuse_mesh() const {
  // no estimate is that good
  if (expected_ > 0.5 * static_cast<double>(most_))
    throw std::length_error("more than " + std::to_string(most_) + " triangles");
  Vec2 where = Vec2::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (Face face : triangulation_.finite_face_handles()) {
    if (!face->is_in_domain()) continue;
    const Vec2 a = position(face->vertex(0)), b = position(face->vertex(1)), c = position(face->vertex(2));
    if (cross(b - a, c - a) >= least) continue;
    least = cross(b - a, c - a);
    where = frame_.world((a + b + c) / 3);
  }
  std::ostringstream text;
  text.precision(3);
  text << "more, though its size asks for about " << expected_ << " triangles: look at (";
  text.precision(8);
  text << where.x() << ", " << where.y() << "), where outline or traces come closest to each other";
  throw std::length_error(text.str());
}

Tessellation Mesher::result() {
  Tessellation t;
  for (Face face : triangulation_.finite_face_handles()) {
    if (!face->is_in_domain()) continue;
    std::vector<int> cell;
    for (int i = 0; i < 3; ++i) {
      const Vertex v = face->vertex(i);
      if (v->index < 0) {
        v->index = static_cast<int>(world_.size());
        world_.push_back(frame_.world(position(v)));
      }
      cell.push_back(v->index);
    }
    t.cells.push_back(std::move(cell));
  }
  t.points = world_;
  connect(t);
  for (Tessellation::Interface& i : t.interfaces)
    if (const auto trace = traces_.find(key(i.p, i.q)); trace != traces_.end()) i.trace = trace->second;
  drop_unused_points(t);
  return t;
}

// Below this the frame's resolution no longer tells the two sides of a slot apart.
void Mesher::check_clearance(const TessellationInput& input) const {
  const double least = 1e-9 * frame_.unit();
  if (boundary_clearance(input, least) < least)
    throw std::invalid_argument("the boundary comes closer to itself than 1e-9 of its extent: too close for a mesh");
}

Tessellation Mesher::run(const TessellationInput& input) {
  check_clearance(input);
  place_given_points();
  leave_whole();
  triangulate();
  label_edges();
  mark_domain();
  estimate_triangles();
  estimate_edges();

  divide();
  triangulate();
  label_edges();
  mark_domain();
  refine();
  label_edges();
  return result();
}

}  // namespace

Tessellation mesh(const TessellationInput& input, const std::function<double(Vec2)>& size_at, long most) {
  return Mesher(input, size_at, most).run(input);
}

}  // namespace talus
