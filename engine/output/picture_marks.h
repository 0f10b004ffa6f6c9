#pragma once
// What is drawn on top of the blocks: failed joints, gas, fixities, loads.
#include <array>
#include <string>
#include <vector>

#include "model/model.h"
#include "output/axis.h"
#include "output/svg.h"

namespace talus {

// The model as drawn: displacements magnified, user coordinates (m).
class Placement {
 public:
  Placement(const Model& model, double magnification);
  Vec2 place(int block, const Vec2& in_block) const;
  const std::vector<Vec2>& vertices() const { return vertices_; }
  const Model& model() const { return model_; }

 private:
  const Model& model_;
  double magnification_;
  std::vector<Vec2> vertices_;
};

using Segment = std::array<Vec2, 2>;

struct Arrow {
  Vec2 at = Vec2::Zero();         // the loaded point, m
  Vec2 direction = Vec2::Zero();  // unit, of the force
  double length = 0;              // px
  bool tip_at_point = true;       // false: the arrow leaves the point (a pull on a face)
  std::string text;               // "5 kN/m"
};
// Loads that are not zero at model.time; of many side by side on a long face only some.
std::vector<Arrow> load_arrows(const Placement& placement, double px_per_metre);
Vec2 far_end(const Arrow& arrow);  // px from the loaded point, y down

constexpr const char *tension_crack_colour = "#000000", *shear_crack_colour = "#d6008a", *real_joint_colour = "#7a5c3a";
constexpr double real_joint_px = 1.2;
int failed_joints(const Model& model, FailureMode mode);
constexpr const char* gas_colour = "#ff7f0e";
std::vector<Segment> gas_lines(const Placement& placement);                     // faces under pressure in the last step
std::vector<Segment> open_lines(const Placement& placement, FailureMode mode);  // FailureMode::none: real joints
void draw_fixities(Svg& svg, const Frame& frame, const Placement& placement);
void draw_arrows(Svg& svg, const Frame& frame, const std::vector<Arrow>& arrows);

}  // namespace talus
