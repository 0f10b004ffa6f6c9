#include "equations/side.h"

namespace talus {

Vec2 Side::varying_traction(const Vec2& in_block, double seconds) const {
  const Bend& shape = pose.bend->shape;
  const Vec3 strain = shape.strain(in_block, pose.bend->now) + seconds * shape.strain(in_block, pose.bend->rate);
  const Vec3 initial = quadratic->stress_x * in_block.x() + quadratic->stress_y * in_block.y();
  return pose.rotation.turn(traction_of(normal) * (initial + elasticity * strain));
}

Vec2 mean_flux(const Side& a, const Vec2& in_a, const Side& b, const Vec2& in_b, double seconds) {
  return a.weight * a.traction_at(in_a, seconds) + b.weight * b.traction_at(in_b, seconds);
}

}  // namespace talus
