#include "step/time_control.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/fragments.h"

namespace talus {

namespace {

// Where contacts did not converge they will not at the same step a little later: for so many steps it grows slowly.
constexpr int caution = 40;
constexpr int caution_among_cracks = 5;  // where contacts come and go with every step
constexpr double careful_growth = 1.03, most_growth = 1.5, growth_among_cracks = 1.25;
// Where what touches changes and sweeps with Newton's steps do not get on, twice within so many steps and in more than
// a part of what moves, shorter ones cost as much for a second, and less is cut. Not so in a wall at rest, which the
// splitting solves once or time and again, nor in a blast.
constexpr int caution_where_split = 100;
constexpr double part_split = 0.1;
constexpr double fall = 0.6;  // there, and where a step takes more than twice what is worth it
// Effort of a step, in factors, from which on it grows no longer: of all; where what presses turns by so much in it
// that corners come and go, for then a step costs by its length (theory, § 10); and among cracks, where two short steps
// are cheaper than one that states have to be looked for in. All shrink from twice the first or the last on.
constexpr double most_effort = 12, most_effort_turning = 4.5, most_effort_among_cracks = 8;
constexpr double turning = 1e-3;  // rad
// Blocks that may move, up to which steps go by the motion alone. What a solution takes hangs on rounding: the same
// scene shifted or turned then took other steps, and was up to 17 % off itself. Up to 38 % less CPU is worth that where
// a step takes milliseconds.
constexpr int few = 250;

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

// Of the thinnest thing that another may pass through, twice area / perimeter: the inradius of a triangle, near half
// the thickness of a slab. A block that intact bonds hold along most of its perimeter is as thick as the body it is
// part of.
double thinnest_thing(const Model& model) {
  const std::vector<int> body = find_fragments(model);
  std::vector<double> bonded(model.shapes.size(), 0), area(model.shapes.size(), 0), outline(model.shapes.size(), 0);
  for (const Joint& joint : model.joints)
    if (joint.state == JointState::intact)
      for (const int b : {joint.a, joint.b}) bonded[b] += joint.length;
  double least = std::numeric_limits<double>::infinity();
  for (size_t b = 0; b < model.shapes.size(); ++b) {
    const BlockShape& shape = model.shapes[b];
    double perimeter = 0;
    for (int k = 0; k < model.vertex_count(int(b)); ++k)
      perimeter += (model.reference_vertex[shape.vertex_begin + model.next_vertex(int(b), k)] -
                    model.reference_vertex[shape.vertex_begin + k])
                       .norm();
    if (2 * bonded[b] <= perimeter) least = std::min(least, 2 * shape.area / perimeter);
    area[body[b]] += shape.area;
    outline[body[b]] += std::max(0.0, perimeter - bonded[b]);
  }
  for (size_t k = 0; k < area.size(); ++k)
    if (outline[k] > 0) least = std::min(least, 2 * area[k] / outline[k]);
  return least;
}

}  // namespace

double next_bend(const Scene& scene, double time) {
  double next = std::numeric_limits<double>::infinity();
  const auto heed = [&](const std::array<History, 2>& of) {
    for (const History& history : of) next = std::min(next, history.next_bend(time));
  };
  for (const PointLoad& load : scene.point_loads) heed(load.force);
  for (const EdgeLoad& load : scene.edge_loads) heed(load.traction);
  for (const Region& region : scene.regions) heed(region.body_force);
  for (const Fixity& fixity : scene.fixities) heed(fixity.value);
  return next;
}

StepSize::StepSize(const Model& model, bool contacts)
    : caution_(caution), worth_(most_effort), growth_(most_growth), since_split_(caution_where_split) {
  const TimeControl& time = model.scene.time;
  limit_ = time.displacement_ratio * model.extent;
  automatic_ = time.dt == 0;
  heeds_effort_ = std::ranges::count_if(model.shapes, [](const BlockShape& shape) { return shape.dofs > 0; }) > few;
  heeds_turns_ = automatic_ && contacts;
  straight_ = automatic_ ? 1e-4 : 1e-3;
  thinnest_ = contacts && !automatic_ ? thinnest_thing(model) : std::numeric_limits<double>::infinity();
  every_ = model.scene.output.every;
  end_ = time.t_end;
  most_ = !automatic_ ? time.dt : time.dt_max > 0 ? time.dt_max : end_ / 10;
  dt_ = std::min(most_, automatic_ ? first_step(model, limit_) : time.dt);
  least_ = time.dt_min > 0 ? time.dt_min : 1e-6 * dt_;
}

void StepSize::among_cracks() {
  caution_ = caution_among_cracks;
  worth_ = most_effort_among_cracks;
  growth_ = growth_among_cracks;
  heeds_splits_ = heeds_turns_ = false;  // a chip that spins is not worth it
  straight_ = 0.01;
}

void StepSize::broken(const Model& model) {
  since_broken_ = 0;
  restored(model);
}

void StepSize::restored(const Model& model) {
  if (!automatic_) thinnest_ = thinnest_thing(model);
}

double StepSize::next(double time) const {
  double target = end_;
  if (automatic_ && every_ > 0) target = std::min(end_, every_ * (std::floor(time / every_ + as_good_as) + 1));
  const double left = target - time;
  // A rest shorter than a part of a step is taken along; one longer than a step is shared between two.
  if (left <= dt_ * (1 + as_good_as)) return left;
  return automatic_ && left < 2 * dt_ ? left / 2 : dt_;
}

void StepSize::cut(double dt, double displacement) {
  const double bound = automatic_ ? limit_ : thinnest_;
  const double part = displacement > bound ? 0.9 * bound / displacement : 0.3;
  dt_ = std::max(dt * std::clamp(part, 0.1, 0.5), least_);
  if (displacement <= bound) cautious_ = caution_;
}

void StepSize::accepted(double dt, const Motion& motion, double effort, double split_anew) {
  since_broken_ = std::min(since_broken_ + 1, quiet_steps);
  if (dt < 0.5 * dt_) return;  // a short last step says nothing
  if (!heeds_effort_) effort = split_anew = 0;
  const bool split = heeds_splits_ && split_anew > part_split,
             split_again = split && since_split_ < caution_where_split;
  since_split_ = split ? 0 : std::min(since_split_ + 1, caution_where_split);
  if (split_again) cautious_ = std::max(cautious_, caution_where_split);
  const double enough = motion.turn > turning ? most_effort_turning : worth_;
  double growth = split_again || (effort > 2 * worth_ && dt > short_enough_) ? fall
                  : effort > enough                                          ? 1
                  : cautious_ > 0                                            ? careful_growth
                                                                             : growth_;
  if (cautious_ > 0) --cautious_;
  const double bound = automatic_ ? limit_ : thinnest_;
  if (motion.displacement > 0)
    growth = std::min(growth, std::max(automatic_ ? 0.5 : 1.0, 0.9 * bound / motion.displacement));
  if (automatic_ && motion.turning_gain > 0)
    growth = std::min(growth, std::max(0.5, 0.8 / std::sqrt(motion.turning_gain)));
  dt_ = std::min(automatic_ ? dt * growth : dt_ * std::max(1.0, growth), most_);
}

}  // namespace talus
