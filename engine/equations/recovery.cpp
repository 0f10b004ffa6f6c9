#include "equations/recovery.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_set>

namespace talus {

namespace {

// Edge of the equilateral triangle with a block's area, in units of √area.
constexpr double edge_per_length = 1.5197;
constexpr double patch_edges = 3;

// Monomials 1, x, y, x², xy, y², x³, x²y, xy², y³.
Eigen::Matrix<double, 10, 1> monomials(const Vec2& p) {
  const double x = p.x(), y = p.y();
  Eigen::Matrix<double, 10, 1> m;
  m << 1, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y;
  return m;
}

// Terms a patch of `count` corners can carry with at least half as many points again.
int terms_for(size_t count) { return count >= 15 ? 10 : count >= 9 ? 6 : count >= 5 ? 3 : 0; }

// Stress of the deformation gradient F with the strain U - I of F = R U.
Vec3 stress_of(const Model& model, int block, const Mat2& f) {
  const double angle = std::atan2(f(1, 0) - f(0, 1), f(0, 0) + f(1, 1));  // polar rotation of a 2×2 matrix
  const Rotation rotation = Rotation::of(angle);
  Mat2 r;
  r << rotation.c, -rotation.s, rotation.s, rotation.c;
  const Mat2 u = r.transpose() * f;
  const Vec3 strain(u(0, 0) - 1, u(1, 1) - 1, u(0, 1) + u(1, 0));
  return turn_stress(rotation, model.shapes[block].initial_stress + elasticity(model.material(block)) * strain);
}

}  // namespace

Recovery::Recovery(const Model& model) { update(model); }

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
    fan.resize(count);
    std::iota(fan.begin(), fan.end(), 0);
    for (int k = 0; k < count; ++k) {
      const int block = nodes.blocks[first + k];
      for (int m = 0; m < k; ++m)
        if (std::count(&neighbours_[neighbour_begin_[block]], neighbours_.data() + neighbour_begin_[block + 1],
                       nodes.blocks[first + m]))
          std::replace(fan.begin(), fan.end(), std::max(fan[k], fan[m]), std::min(fan[k], fan[m]));
    }
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

void Recovery::update(const Model& model) {
  const int intact = int(std::count_if(model.joints.begin(), model.joints.end(),
                                       [](const Joint& joint) { return joint.state == JointState::intact; }));
  if (intact != intact_joints_) connect(model);
  intact_joints_ = intact;
  corner_displacement_.assign(corner_position_.size(), Vec2::Zero());
  std::vector<int> count(corner_position_.size(), 0);
  for (size_t v = 0; v < corner_of_vertex_.size(); ++v) {
    const int corner = corner_of_vertex_[v];
    if (corner < 0) continue;
    corner_displacement_[corner] += model.vertex[v] - corner_position_[corner];
    ++count[corner];
  }
  for (size_t c = 0; c < count.size(); ++c) corner_displacement_[c] /= std::max(count[c], 1);
}

Recovery::Patch Recovery::patch(const Model& model, int block, const Vec2& at) const {
  Patch patch;
  patch.radius = patch_edges * edge_per_length * model.shapes[block].length;
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
    if (!near) continue;
    for (int k = neighbour_begin_[queue[head]]; k < neighbour_begin_[queue[head] + 1]; ++k)
      if (model.shapes[neighbours_[k]].material == shape.material && seen.insert(neighbours_[k]).second)
        queue.push_back(neighbours_[k]);
  }
  return patch;
}

Vec3 Recovery::stress_at(const Model& model, int block, const Vec2& in_block) const {
  if (model.shapes[block].dofs <= 3) return model.stress(block);
  const Vec2 at = model.reference_place(block, in_block);
  const Patch patch = this->patch(model, block, at);
  const int terms = terms_for(patch.corners.size());
  if (terms == 0) return model.stress(block);
  const int count = int(patch.corners.size());
  Eigen::MatrixXd a(count, terms), u(count, 2);
  for (int k = 0; k < count; ++k) {
    const int corner = patch.corners[k];
    a.row(k) = monomials((corner_position_[corner] - at) / patch.radius).head(terms).transpose();
    u.row(k) = corner_displacement_[corner].transpose();
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(a);
  if (qr.rank() < terms) return model.stress(block);
  const Eigen::MatrixXd c = qr.solve(u);
  Mat2 f = Mat2::Identity();
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) f(i, j) += c(1 + j, i) / patch.radius;
  return stress_of(model, block, f);
}

}  // namespace talus
