#include "equations/kinematics.h"

#include <algorithm>

namespace talus {

namespace {

void bend(const BlockShape& shape, const BlockState& state, double seconds, PoseBend& bend) {
  bend.shape = shape.bend();
  std::copy_n(&state.velocity[first_order_dofs], bend.rate.size(), bend.rate.begin());
  for (size_t k = 0; k < bend.now.size(); ++k) bend.now[k] = (*state.bend)[k] + seconds * bend.rate[k];
}

}  // namespace

Vec2 Pose::bent(const Vec2& in_block, const BendArray& b) const {
  return rotation.turn(bend->shape.displacement(in_block, b));
}

Pose flown(const Model& model, int block, double seconds) {
  return flown(model.shapes[block], model.blocks[block], seconds);
}

Pose flown(const BlockShape& shape, const BlockState& state, double seconds) {
  Pose pose;
  fly(shape, state, seconds, pose);
  return pose;
}

void fly(const BlockShape& shape, const BlockState& state, double seconds, Pose& pose) {
  const double per_length = seconds / shape.length;
  const auto& v = state.velocity;
  pose.shift = state.shift + seconds * Vec2(v[0], v[1]);
  pose.centroid = shape.reference_centroid + pose.shift;
  pose.rotation = Rotation::of(state.angle + shape.turn(per_length * v[2]));
  pose.strain = state.strain + per_length * Vec3(v[3], v[4], v[5]);
  pose.length = shape.length;
  std::copy_n(v.begin(), first_order_dofs, pose.velocity.begin());
  if (state.bend) bend(shape, state, seconds, pose.bend.make());
}

void Poses::predict(const Model& model, const Scheme& scheme) {
  blocks.resize(model.blocks.size());
  for (const int b : model.awake_blocks()) fly(model.shapes[b], model.blocks[b], scheme.mid, blocks[b]);
}

void Poses::place_vertices(const Model& model) {
  vertex.resize(model.reference_vertex.size());
  placed_.assign(model.blocks.size(), 0);
  for (const Contact& contact : model.awake_contacts())
    for (const int b : {contact.i, contact.j}) {
      if (placed_[b]) continue;
      placed_[b] = 1;
      const BlockShape& shape = model.shapes[b];
      for (int i = shape.vertex_begin; i < shape.vertex_end; ++i)
        vertex[i] = blocks[b].place(model.reference_vertex[i]);
    }
}

}  // namespace talus
