#include "step/time_control.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus {

namespace {

// First step: what gravity and the initial velocities move by the limit.
double first_step(const Model& model, double limit) {
  double speed = 0;
  for (size_t b = 0; b < model.blocks.size(); ++b) {
    const auto& v = model.blocks[b].velocity;
    speed = std::max(speed, std::hypot(v[0], v[1]) + std::abs(v[2]) * model.shapes[b].radius / model.shapes[b].length);
  }
  const double g = model.scene.gravity.norm(), infinity = std::numeric_limits<double>::infinity();
  return std::min(speed > 0 ? limit / speed : infinity, g > 0 ? std::sqrt(2 * limit / g) : infinity);
}

}  // namespace

StepSize::StepSize(const Model& model) {
  const TimeControl& time = model.scene.time;
  limit_ = time.displacement_ratio * model.extent;
  automatic_ = time.dt == 0;
  end_ = time.t_end;
  most_ = time.dt_max > 0 ? time.dt_max : automatic_ ? end_ / 10 : time.dt;
  dt_ = std::min(most_, automatic_ ? first_step(model, limit_) : time.dt);
  least_ = time.dt_min > 0 ? time.dt_min : 1e-6 * dt_;
}

double StepSize::next(double time) const {
  const double left = end_ - time;
  // A rest shorter than a part of a step is taken along; one longer than a step is shared between two.
  if (left <= dt_ * (1 + 1e-6)) return left;
  return automatic_ && left < 2 * dt_ ? left / 2 : dt_;
}

void StepSize::cut(double dt, double displacement) {
  const double part = automatic_ && displacement > limit_ ? 0.9 * limit_ / displacement : 0.3;
  dt_ = dt * std::clamp(part, 0.1, 0.5);
}

void StepSize::accepted(double dt, double displacement, int iterations) {
  if (dt < 0.5 * dt_) return;  // a short last step says nothing
  double growth = iterations > 25 ? 0.7 : iterations > 12 ? 1.0 : 1.5;
  if (automatic_ && displacement > 0) growth = std::min(growth, std::max(0.5, 0.9 * limit_ / displacement));
  dt_ = std::min(automatic_ ? dt * growth : dt_ * std::max(1.0, growth), most_);
}

}  // namespace talus
