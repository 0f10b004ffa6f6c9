#include "equations/error_estimate.h"

#include <Eigen/LU>
#include <cmath>

#include "equations/side.h"

namespace talus {

namespace {

// Six points in a triangle, exact to degree four (Dunavant 1985): the square of the error of a stress that is linear in
// a block.
struct TrianglePoint {
  double a, b, share;
};
constexpr double inner = 0.445948490915965, inner_share = 0.223381589678011;
constexpr double outer = 0.091576213509771, outer_share = 0.109951743655322;
constexpr TrianglePoint triangle_points[] = {{inner, inner, inner_share},         {inner, 1 - 2 * inner, inner_share},
                                             {1 - 2 * inner, inner, inner_share}, {outer, outer, outer_share},
                                             {outer, 1 - 2 * outer, outer_share}, {1 - 2 * outer, outer, outer_share}};

// f(material point, weight) over a block of any outline, in triangles about its centroid; over a triangle as it is.
template <class F>
void each_point(const Model& model, int block, F f) {
  const Vec2* corners = &model.reference_vertex[model.shapes[block].vertex_begin];
  const auto triangle = [&](const Vec2& o, const Vec2& p, const Vec2& q) {
    const double area = cross(p - o, q - o) / 2;
    for (const TrianglePoint& point : triangle_points)
      f(Vec2(o + point.a * (p - o) + point.b * (q - o)), point.share * area);
  };
  const int count = model.vertex_count(block);
  if (count == 3) return triangle(corners[0], corners[1], corners[2]);
  for (int k = 0; k < count; ++k) triangle(Vec2::Zero(), corners[k], corners[model.next_vertex(block, k)]);
}

Vec3 strain_at(const Model& model, int block, const Vec2& in_block) {
  const BlockShape& shape = model.shapes[block];
  const BlockState& state = model.blocks[block];
  return shape.second_order() ? Vec3(state.strain + shape.bend().strain(in_block, *state.bend)) : state.strain;
}

}  // namespace

double ErrorNorm::relative() const {
  const double whole = energy + error;
  return whole > 0 ? std::sqrt(error / whole) : 0;
}

ErrorNorm& ErrorNorm::operator+=(const ErrorNorm& other) {
  error += other.error;
  energy += other.energy;
  return *this;
}

ErrorNorm error_of_block(const Model& model, const Recovery& recovery, int block) {
  ErrorNorm sum;
  if (model.shapes[block].dofs <= rigid_dofs) return sum;
  const Mat3 stiffness = elasticity(model.material(block)), compliance = stiffness.inverse();
  const Recovery::Fit fit = recovery.fit(model, block, Vec2::Zero());
  each_point(model, block, [&](const Vec2& x, double weight) {
    const Vec3 strain = strain_at(model, block, x);
    sum.energy += weight * strain.dot(stiffness * strain);
    if (!fit.found) return;
    const Vec3 error = recovery.stress_of(model, block, fit, x) - model.stress(block, x);
    sum.error += weight * error.dot(compliance * error);  // of isotropic rock, in any axes
  });
  return sum;
}

double stress_error(const Model& model, const Recovery& recovery, int block) {
  return std::sqrt(model.material(block).young * error_of_block(model, recovery, block).error /
                   model.shapes[block].area);
}

std::vector<ErrorNorm> error_of_regions(const Model& model, const Recovery& recovery) {
  std::vector<ErrorNorm> sums(model.scene.regions.size());
  for (int b = 0; b < int(model.shapes.size()); ++b) sums[model.shapes[b].region] += error_of_block(model, recovery, b);
  return sums;
}

double traction_jump(const Model& model, const Joint& joint) {
  if (model.shapes[joint.a].dofs <= rigid_dofs || model.shapes[joint.b].dofs <= rigid_dofs) return 0;
  const auto turned = [&](int block) { return Rotation::of(model.blocks[block].angle).turn(joint.normal); };
  const Matrix23 n = traction_of((turned(joint.a) + turned(joint.b)).normalized());
  double sum = 0, length = 0;
  for (const JointPoint& point : joint.points) {
    const Vec2 jump = n * (model.stress(joint.b, between(joint.in_b, point.at)) -
                           model.stress(joint.a, between(joint.in_a, point.at)));
    sum += point.weight * jump.squaredNorm();
    length += point.weight;
  }
  return std::sqrt(sum / length);
}

}  // namespace talus
