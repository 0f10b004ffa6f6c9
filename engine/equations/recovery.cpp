#include "equations/recovery.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_set>

#include "equations/kinematics.h"
#include "model/groups.h"

namespace talus {

namespace {

// Edge of the equilateral triangle with a block's area, in units of √area.
constexpr double edge_per_length = 1.5197;
// Corners count by (1 - (r/R)²)², so that none matters more for being just inside the patch.
constexpr double patch_edges = 4, second_order_patch_edges = 1.5;
// Pivots below this part of the largest: corners that lie on a line or a conic.
constexpr double least_pivot = 1e-10;

// Displacements in a patch: a polynomial in x, y (of the patch's radius) with unknowns for u, then for v, then
// those of the cubic terms. The ten monomials of degree 3 in u and v need not be free: where body force and
// acceleration hardly vary over the patch, div σ is constant in it, which ties x³ and y³ to the mixed terms.
// The acceleration that does vary, -ω² x of a body that turns, is known: its part of the displacement is given.
struct Cubic {
  double x3_by_xy2, x3_by_other, y3_by_x2y, y3_by_other;
  explicit Cubic(const Mat3& stiffness) {
    const double direct = stiffness(0, 0), shear = stiffness(2, 2), cross = stiffness(0, 1) + shear;
    x3_by_xy2 = -shear / (3 * direct);
    x3_by_other = -cross / (3 * direct);
    y3_by_x2y = -direct / (3 * shear);
    y3_by_other = -cross / (3 * shear);
  }
  // The ten monomials of degree three from the unknowns of x²y and xy² in u, then in v; less what turning has put in.
  void spread(const double* c, double turning, Recovery::Fit& fit) const {
    const double u_x2y = c[0], u_xy2 = c[1], v_x2y = c[2], v_xy2 = c[3];
    fit.u[6] = x3_by_xy2 * u_xy2 + x3_by_other * v_x2y - turning;
    fit.u[7] = u_x2y;
    fit.u[8] = u_xy2;
    fit.u[9] = y3_by_x2y * u_x2y + y3_by_other * v_xy2;
    fit.v[6] = y3_by_x2y * v_xy2 + y3_by_other * u_x2y;
    fit.v[7] = v_x2y;
    fit.v[8] = v_xy2;
    fit.v[9] = x3_by_xy2 * v_x2y + x3_by_other * u_xy2 - turning;
  }
};

constexpr int most_unknowns = 20;
using Normal = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_unknowns, most_unknowns>;
using MonomialRow = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_unknowns, 1>;

// Rows for u and v at p; `terms` monomials of degree < 4 each, and 4 mixed unknowns when `cubic` is given.
void rows_at(const Vec2& p, int terms, const Cubic* cubic, MonomialRow& u, MonomialRow& v) {
  const double x = p.x(), y = p.y(), xx = x * x, yy = y * y;
  const double m[10] = {1, x, y, xx, x * y, yy, xx * x, xx * y, x * yy, yy * y};
  u.setZero();
  v.setZero();
  for (int k = 0; k < terms; ++k) u[k] = v[terms + k] = m[k];
  if (!cubic) return;
  const double x3 = x * x * x, y3 = y * y * y, x2y = x * x * y, xy2 = x * y * y;
  const int u_x2y = 2 * terms, u_xy2 = u_x2y + 1, v_x2y = u_x2y + 2, v_xy2 = u_x2y + 3;
  u[u_x2y] = x2y + cubic->y3_by_x2y * y3;
  u[v_xy2] = cubic->y3_by_other * y3;
  u[u_xy2] = xy2 + cubic->x3_by_xy2 * x3;
  u[v_x2y] = cubic->x3_by_other * x3;
  v[v_x2y] = x2y + cubic->x3_by_xy2 * y3;
  v[u_xy2] = cubic->x3_by_other * y3;
  v[v_xy2] = xy2 + cubic->y3_by_x2y * x3;
  v[u_x2y] = cubic->y3_by_other * x3;
}

}  // namespace

// Stress at a point of a block whose material is turned with it and then deformed by the gradient f = R U.
static Vec3 stress_of(const Model& model, int block, const Vec2& in_block, const Mat2& f) {
  const double base = model.blocks[block].angle;
  const double angle = std::atan2(f(1, 0) - f(0, 1), f(0, 0) + f(1, 1));  // polar rotation of a 2×2 matrix
  const Rotation r = Rotation::of(angle);
  const Vec2 x = r.back(f.col(0)), y = r.back(f.col(1));  // columns of U
  const Vec3 strain(x.x() - 1, y.y() - 1, x.y() + y.x());
  Vec3 initial = model.shapes[block].initial_stress;  // at the centroid
  if (const auto& given = model.scene.regions[model.shapes[block].region].stress)
    initial += given->gradient_x * in_block.x() + given->gradient_y * in_block.y();
  return turn_stress(Rotation::of(base + angle), initial + elasticity(model.material(block)) * strain);
}

Recovery::Recovery(const Model& model) {
  update(model);
}

void Recovery::connect(const Model& model) {
  const int blocks = int(model.shapes.size());
  neighbour_begin_.assign(blocks + 1, 0);
  for (const Joint& joint : model.joints)
    if (joint.state == JointState::intact) {
      ++neighbour_begin_[joint.a + 1];
      ++neighbour_begin_[joint.b + 1];
    }
  std::partial_sum(neighbour_begin_.begin(), neighbour_begin_.end(), neighbour_begin_.begin());
  neighbours_.resize(neighbour_begin_[blocks]);
  std::vector<int> fill = neighbour_begin_;
  for (const Joint& joint : model.joints)
    if (joint.state == JointState::intact) {
      neighbours_[fill[joint.a]++] = joint.b;
      neighbours_[fill[joint.b]++] = joint.a;
    }

  corner_of_vertex_.assign(model.reference_vertex.size(), -1);
  corner_position_.clear();
  const Nodes& nodes = model.nodes;
  std::vector<int> fan;
  for (size_t n = 0; n + 1 < nodes.begin.size(); ++n) {
    const int first = nodes.begin[n], count = nodes.begin[n + 1] - first;
    const auto bonded = [&](int k, int m) {
      const int block = nodes.blocks[first + k];
      return std::count(neighbours_.data() + neighbour_begin_[block], neighbours_.data() + neighbour_begin_[block + 1],
                        nodes.blocks[first + m]) > 0;
    };
    find_groups(count, bonded, fan);
    std::vector<int> corner(count, -1);
    for (int k = 0; k < count; ++k) {
      if (corner[fan[k]] < 0) {
        corner[fan[k]] = int(corner_position_.size());
        corner_position_.push_back(nodes.position[n]);
      }
      const int vertex = model.shapes[nodes.blocks[first + k]].vertex_begin + nodes.corners[first + k];
      corner_of_vertex_[vertex] = corner[fan[k]];
    }
  }
}

// The middle of an edge is shared across a bond of two second-order blocks; a first-order block has only a straight
// line to say there.
void Recovery::connect_middles(const Model& model) {
  middle_of_edge_.clear();
  if (model.quadratic_shapes.empty()) return;
  middle_of_edge_.assign(model.reference_vertex.size(), -1);
  for (int b = 0; b < int(model.shapes.size()); ++b) {
    const BlockShape& shape = model.shapes[b];
    const auto at_node = [&](int local) { return corner_of_vertex_[size_t(shape.vertex_begin + local)] >= 0; };
    for (int k = 0; shape.second_order() && k < model.vertex_count(b); ++k) {
      if (!at_node(k)) continue;
      int end = model.next_vertex(b, k);
      while (!at_node(end)) end = model.next_vertex(b, end);
      const int v = shape.vertex_begin + k;
      middle_of_edge_[size_t(v)] = int(corner_position_.size());
      corner_position_.push_back(
          shape.reference_centroid +
          (model.reference_vertex[size_t(v)] + model.reference_vertex[size_t(shape.vertex_begin + end)]) / 2);
    }
  }
  for (const Joint& joint : model.joints) {
    const BlockShape &a = model.shapes[joint.a], &b = model.shapes[joint.b];
    if (joint.state == JointState::intact && a.second_order() && b.second_order())
      middle_of_edge_[b.vertex_begin + joint.edge_b] = middle_of_edge_[a.vertex_begin + joint.edge_a];
  }
}

void Recovery::update(const Model& model) {
  const int intact = int(std::count_if(model.joints.begin(), model.joints.end(),
                                       [](const Joint& joint) { return joint.state == JointState::intact; }));
  if (intact != intact_joints_) {
    connect(model);
    connect_middles(model);
  }
  intact_joints_ = intact;
  corner_displacement_.assign(corner_position_.size(), Vec2::Zero());
  std::vector<int> count(corner_position_.size(), 0);
  for (int b = 0; b < int(model.shapes.size()); ++b)
    for (int v = model.shapes[b].vertex_begin; v < model.shapes[b].vertex_end; ++v) {
      const int corner = corner_of_vertex_[size_t(v)];
      if (corner < 0) continue;
      corner_displacement_[corner] += model.vertex[size_t(v)] - corner_position_[corner];
      ++count[corner];
    }
  for (int b = 0; !middle_of_edge_.empty() && b < int(model.shapes.size()); ++b) {
    const BlockShape& shape = model.shapes[b];
    if (!shape.second_order()) continue;
    const Pose pose = flown(model, b, 0);
    for (int v = shape.vertex_begin; v < shape.vertex_end; ++v) {
      if (middle_of_edge_[v] < 0) continue;
      const Vec2 middle = corner_position_[middle_of_edge_[v]] - shape.reference_centroid;
      corner_displacement_[middle_of_edge_[v]] += pose.displacement(middle);
      ++count[middle_of_edge_[v]];
    }
  }
  for (size_t c = 0; c < count.size(); ++c) corner_displacement_[c] /= std::max(count[c], 1);
}

bool Recovery::take_middles(const BlockShape& shape, const Vec2& at, Patch& patch) const {
  bool near = false;
  for (int v = shape.vertex_begin; v < shape.vertex_end; ++v) {
    const int middle = middle_of_edge_[v];
    if (middle < 0 || (corner_position_[middle] - at).norm() > patch.radius) continue;
    near = true;
    if (std::find(patch.corners.begin(), patch.corners.end(), middle) == patch.corners.end())
      patch.corners.push_back(middle);
  }
  return near;
}

Recovery::Patch Recovery::patch(const Model& model, int block, const Vec2& at) const {
  Patch patch;
  const BlockShape& own = model.shapes[block];
  patch.radius = (own.second_order() ? second_order_patch_edges : patch_edges) * edge_per_length * own.length;
  std::vector<int> queue{block};
  std::unordered_set<int> seen{block}, taken;
  for (size_t head = 0; head < queue.size(); ++head) {
    const BlockShape& shape = model.shapes[queue[head]];
    bool near = false;
    for (int v = shape.vertex_begin; v < shape.vertex_end; ++v) {
      const int corner = corner_of_vertex_[v];
      if (corner < 0 || (corner_position_[corner] - at).norm() > patch.radius) continue;
      near = true;
      if (taken.insert(corner).second) patch.corners.push_back(corner);
    }
    if (shape.second_order()) near = take_middles(shape, at, patch) || near;
    if (!near) continue;
    for (int k = neighbour_begin_[queue[head]]; k < neighbour_begin_[queue[head] + 1]; ++k)
      if (model.shapes[neighbours_[k]].material == shape.material && seen.insert(neighbours_[k]).second)
        queue.push_back(neighbours_[k]);
  }
  return patch;
}

Vec3 Recovery::stress_at(const Model& model, int block, const Vec2& in_block) const {
  return stress_of(model, block, fit(model, block, in_block), in_block);
}

Recovery::Fit Recovery::fit(const Model& model, int block, const Vec2& centre) const {
  Fit fit;
  if (model.shapes[block].dofs <= rigid_dofs) return fit;
  const Vec2 at = model.reference_place(block, centre);
  const Patch patch = this->patch(model, block, at);
  const size_t count = patch.corners.size();
  // Half as many corners again as the polynomial needs: else one of lower degree.
  // A second-order block's own stress is no worse than that of a polynomial of second degree.
  const bool second = model.shapes[block].second_order();
  const int terms = second ? (count >= 15 ? 10 : 0) : count >= 9 ? 6 : count >= 5 ? 3 : 0;
  if (terms == 0) return fit;
  const Cubic cubic(elasticity(model.material(block)));
  const Cubic* const with_cubic = count >= 15 && !second ? &cubic : nullptr;
  const double spin = model.blocks[block].velocity[2] / model.shapes[block].length;
  const double turning = with_cubic ? model.material(block).density * spin * spin * std::pow(patch.radius, 3) /
                                          (6 * elasticity(model.material(block))(0, 0))
                                    : 0;
  const int unknowns = 2 * terms + (with_cubic ? 4 : 0);
  // The fit is made in the block's turned axes, where the equations of elasticity hold.
  const Rotation turned = Rotation::of(model.blocks[block].angle);
  const double c1 = turned.c1();
  Normal normal = Normal::Zero(unknowns, unknowns);
  MonomialRow right = MonomialRow::Zero(unknowns), u(unknowns), v(unknowns);
  for (const int corner : patch.corners) {
    const Vec2 place = corner_position_[corner] - at;
    const Vec2 p = place / patch.radius;
    const Vec2 moved = turned.back(corner_displacement_[corner]) +
                       Vec2(c1 * place.x() + turned.s * place.y(), -turned.s * place.x() + c1 * place.y()) +
                       turning * Vec2(p.x() * p.x() * p.x(), p.y() * p.y() * p.y());
    rows_at(p, terms, with_cubic, u, v);
    const double part = 1 - p.squaredNorm(), weight = part * part;
    normal.noalias() += weight * (u * u.transpose() + v * v.transpose());
    right += weight * (moved.x() * u + moved.y() * v);
  }
  const Eigen::LDLT<Normal> factor(normal);
  if (factor.vectorD().minCoeff() < least_pivot * factor.vectorD().maxCoeff()) return fit;
  const MonomialRow c = factor.solve(right) / patch.radius;
  fit.found = true;
  fit.centre = centre;
  fit.radius = patch.radius;
  std::copy_n(c.data(), terms, fit.u.begin());
  std::copy_n(c.data() + terms, terms, fit.v.begin());
  if (with_cubic) cubic.spread(c.data() + 2 * terms, turning / patch.radius, fit);
  return fit;
}

Vec3 Recovery::stress_of(const Model& model, int block, const Fit& fit, const Vec2& in_block) const {
  if (!fit.found) return model.stress(block, in_block);
  const Vec2 p = (in_block - fit.centre) / fit.radius;
  const double x = p.x(), y = p.y();
  const double by_x[10] = {0, 1, 0, 2 * x, y, 0, 3 * x * x, 2 * x * y, y * y, 0};
  const double by_y[10] = {0, 0, 1, 0, x, 2 * y, 0, x * x, 2 * x * y, 3 * y * y};
  Mat2 f = Mat2::Identity();
  for (int k = 1; k < 10; ++k)
    f += (Mat2() << fit.u[k] * by_x[k], fit.u[k] * by_y[k], fit.v[k] * by_x[k], fit.v[k] * by_y[k]).finished();
  return talus::stress_of(model, block, in_block, f);
}

}  // namespace talus
