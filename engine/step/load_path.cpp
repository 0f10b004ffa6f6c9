#include "step/load_path.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

#include "scene/plan.h"

namespace talus {

namespace {

// A load jumps where this part of its change comes in this part of t_end; a ramp that steep may as well be taken for a
// jump.
constexpr double least_jump = 0.01;
constexpr double jump_time = 1e-9;

using Interval = LoadPath::Interval;

// Where `of` changes most between two times, if it jumps there.
template <class Of>
std::optional<Interval> jump_of(Of of, Interval in, double width) {
  double before = of(in.first), after = of(in.second);
  const double change = std::abs(after - before);
  if (change == 0) return {};
  while (in.second - in.first > width) {
    const double middle = (in.first + in.second) / 2, there = of(middle);
    const bool sooner = std::abs(there - before) >= std::abs(after - there);
    (sooner ? in.second : in.first) = middle;
    (sooner ? after : before) = there;
  }
  if (std::abs(after - before) < least_jump * change) return {};
  return in;
}

// The first jump of loads or supports between two times.
std::optional<Interval> first_jump(const Scene& scene, const Interval& in, double width) {
  std::optional<Interval> first;
  const auto look = [&](const auto& of) {
    const std::optional<Interval> jump = jump_of(of, in, width);
    if (jump && (!first || jump->first < first->first)) first = jump;
  };
  const auto look_at = [&](const std::array<History, 2>& load) {
    for (const History& history : load)
      if (!history.constant()) look([&](double t) { return history.at(t); });
  };
  for (const PointLoad& load : scene.point_loads) look_at(load.force);
  for (const EdgeLoad& load : scene.edge_loads) look_at(load.traction);
  for (const Region& region : scene.regions) look_at(region.body_force);
  for (const Fixity& fixity : scene.fixities)
    if (fixity.motion == Fixity::displacement) look_at(fixity.value);
  return first;
}

}  // namespace

LoadPath::LoadPath(Model& model, double to, bool unloaded)
    : model_(model),
      unloaded_(unloaded && loaded_from_start(model.scene)),
      jumps_(model.load_way.part < 1),
      from_(jumps_ ? model.load_way.from : model.time),
      until_(jumps_ ? model.time : to),
      come_(jumps_ ? model.load_way.part : 0) {}

void LoadPath::begin() const {
  model_.time = until_;
  model_.load_way = jumps_ ? LoadWay{from_, come_} : LoadWay{};
}

void LoadPath::end() const {
  model_.time = until_;
  model_.load_way = go_ < 1 ? LoadWay{from_, go_} : LoadWay{};
}

void LoadPath::stop_at(double length) {
  if (length >= this->length()) return;
  if (jumps_)
    go_ = come_ + length;
  else
    until_ = from_ + length;
}

std::optional<LoadPath::Interval> LoadPath::next_jump() const {
  const double width = jump_time * model_.scene.time.t_end;
  if (jumps_ || until_ <= width) return {};
  return first_jump(model_.scene, {std::max(from_, width), until_}, width);  // no load step asks what is at t = 0
}

bool LoadPath::meets_jump() const {
  return next_jump().has_value();
}

void LoadPath::cut(double part) {
  if (std::exchange(unloaded_, false)) {
    until_ = from_;
    from_ = LoadWay::nothing;
    jumps_ = true;
    return;
  }
  if (const std::optional<Interval> jump = next_jump()) {
    if (jump->first > from_ + jump_time * model_.scene.time.t_end) {
      until_ = jump->first;
      return;
    }
    jumps_ = true;
    until_ = jump->second;
  }
  stop_at(std::max(part * length(), least()));
}

std::string load_text(const Model& model) {
  const LoadWay& way = model.load_way;
  const std::string time = "t = " + std::to_string(model.time) + " s";
  if (way.part == 1) return time;
  char part[100];
  std::snprintf(part, sizeof part, " and %.3g %% of %s", 100 * way.part,
                way.from == LoadWay::nothing ? "gravity and what else is there from the start"
                                             : "the way that loads or supports jump there");
  return time + part;
}

}  // namespace talus
