#include "equations/kinematics.h"

namespace talus {

void Poses::predict(const Model& model, const Scheme& scheme) {
  blocks.resize(model.blocks.size());
  vertex.resize(model.reference_vertex.size());
  for (size_t b = 0; b < blocks.size(); ++b) {
    const BlockState& state = model.blocks[b];
    const BlockShape& shape = model.shapes[b];
    const double per_length = scheme.mid / shape.length;
    const auto& v = state.velocity;
    Pose& pose = blocks[b];
    pose.shift = state.shift + scheme.mid * Vec2(v[0], v[1]);
    pose.centroid = shape.reference_centroid + pose.shift;
    pose.rotation = Rotation::of(state.angle + per_length * v[2]);
    pose.strain = state.strain + per_length * Vec3(v[3], v[4], v[5]);
    pose.length = shape.length;
    pose.velocity = v;
    for (int i = shape.vertex_begin; i < shape.vertex_end; ++i) vertex[i] = pose.place(model.reference_vertex[i]);
  }
}

}  // namespace talus
