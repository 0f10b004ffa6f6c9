#include <gtest/gtest.h>

#include "equations/kinematics.h"
#include "small_scene.h"

namespace talus {
namespace {

// Rows are the derivative of place() by the unknowns, at a strain that is not small too.
TEST(Kinematics, RowsAreTheDerivativeOfThePlace) {
  Model model = build(test::scene_of({test::region("block", {{0, 0}, {3, 0.5}, {2, 2}})}));
  const BlockShape& shape = model.shapes[0];
  BlockState& state = model.blocks[0];
  state.angle = 0.7;
  state.strain = Vec3(0.03, -0.05, 0.04);
  const Vec2 in_block(0.6, -0.3), direction = Vec2(0.8, -0.6);
  const auto pose_at = [&](int k, double by) {
    BlockState& now = model.blocks[0];
    const BlockState before = now;
    if (k < 2) now.shift[k] += by;
    if (k == 2) now.angle += by / shape.length;
    if (k > 2) now.strain[k - 3] += by / shape.length;
    const Pose pose = flown(model, 0, 0);
    now = before;
    return pose;
  };
  const Pose pose = pose_at(0, 0);
  const FirstRow row = pose.row(pose.place(in_block), direction);
  const double h = 1e-6;
  for (int k = 0; k < 6; ++k) {
    const Vec2 change = pose_at(k, h).place(in_block) - pose_at(k, -h).place(in_block);
    EXPECT_NEAR(row[k], direction.dot(change) / (2 * h), 1e-8) << k;
  }
}

}  // namespace
}  // namespace talus
