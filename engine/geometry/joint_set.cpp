#include "geometry/joint_set.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>

#include "geometry/polygon.h"

namespace talus {
namespace {

constexpr double most_lines = 10000;  // cutting a region by n lines costs n² in time and memory: here 10 s, 0.5 GB
constexpr double most_gaps_to_box = 1e7;  // between `through` and the box

// splitmix64 (Steele, Lea & Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t state) : state_(state) {}
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }  // [0, 1)
  double symmetric() { return 2 * unit() - 1; }                          // [-1, 1)

 private:
  std::uint64_t state_;
};

// The direction at an angle, with multiples of 90° exact: horizontal joints shall be horizontal.
Vec2 direction(double angle) {
  Vec2 d(std::cos(angle), std::sin(angle));
  for (double& component : d)
    if (std::abs(component) < 1e-15) component = 0;
  return d.normalized();
}

// What chance gives line k, drawn from the seed and k alone: a larger box adds lines and changes none.
struct Draw {
  double gap;    // to line k + 1, as a multiple of the spacing
  double tilt;   // rad
  double phase;  // [0, 1), part of the period of joint and bridge
};

Draw draw(const JointSet& set, int k) {
  Random random(Random(set.seed).next() + static_cast<std::uint64_t>(static_cast<std::int64_t>(k)));
  Draw d;
  d.gap = 1 + set.spacing_scatter * random.symmetric();
  d.tilt = set.dip_scatter * random.symmetric();
  d.phase = random.unit();
  return d;
}

// Normal offsets from `anchor` of the lines that can meet the box, whichever way they are tilted.
std::pair<double, double> reach(const JointSet& set, const Bounds& box, const Vec2& anchor) {
  const Vec2 along = direction(set.dip), normal = perp(along);
  const double slope = std::tan(std::min(std::abs(set.dip_scatter), 1.4));
  double low = 0, high = 0;
  bool first = true;
  for (const Vec2& corner : {box.min, box.max, Vec2(box.min.x(), box.max.y()), Vec2(box.max.x(), box.min.y())}) {
    const double offset = normal.dot(corner - anchor), spread = slope * std::abs(along.dot(corner - anchor));
    low = first ? offset - spread : std::min(low, offset - spread);
    high = first ? offset + spread : std::max(high, offset + spread);
    first = false;
  }
  return {low, high};
}

[[noreturn]] void refuse(const JointSet& set, const char* field, const std::string& expected, double given) {
  std::ostringstream got;
  got << given;
  throw InputError(set.place, field, expected, got.str());
}

[[noreturn]] void refuse_short(const JointSet& set, const char* field, double least, double given) {
  std::ostringstream expected;
  expected << "at least " << least << " m here (no more than " << most_lines << " joints)";
  refuse(set, field, expected.str(), given);
}

// Jointed parts of the line a + t·d, first ≤ t ≤ last, with bridges between them.
void add_parts(const JointSet& set, const Vec2& a, const Vec2& d, double first, double last, double phase,
               std::vector<Polyline>& lines) {
  if (set.persistence >= 1) {
    lines.push_back({a + first * d, a + last * d});
    return;
  }
  const double jointed = set.trace_length > 0 ? set.trace_length : 5 * set.spacing;
  const double period = jointed / set.persistence;
  const double parts = static_cast<double>(lines.size()) + (last - first) / period;
  if (!(parts <= most_lines))
    refuse_short(set, set.trace_length > 0 ? "trace_length" : "spacing", jointed * parts / most_lines, jointed);
  const double stub = 1e-9 * (last - first);  // of a part that just reaches into the box
  const double m0 = std::floor((first - phase * period) / period);
  for (double m = m0; (m + phase) * period < last; ++m) {
    const double t0 = std::max(first, (m + phase) * period);
    const double t1 = std::min(last, (m + phase) * period + jointed);
    if (t1 - t0 > stub) lines.push_back({a + t0 * d, a + t1 * d});
  }
}

}  // namespace

std::vector<Polyline> joint_lines(const JointSet& set, const Vec2& box_min, const Vec2& box_max) {
  if (!(set.spacing > 0)) refuse(set, "spacing", "a positive length", set.spacing);
  if (!(set.persistence > 0)) refuse(set, "persistence", "a number above 0, at most 1", set.persistence);
  const Bounds box{box_min, box_max};
  const Vec2 anchor = set.through.value_or(box.centre());
  const auto [low, high] = reach(set, box, anchor);
  if (!((high - low) / set.spacing <= most_lines))
    refuse_short(set, "spacing", (high - low) / most_lines, set.spacing);
  const double distance = std::max(std::abs(low), std::abs(high));
  if (!(distance / set.spacing <= most_gaps_to_box))
    refuse(set, "through", "a point near the region", (anchor - box.centre()).norm());

  // Line 0 goes through the anchor; the gaps are walked from there to the near side of the box.
  int k = 0;
  double offset = 0;
  while (offset >= low) offset -= set.spacing * draw(set, --k).gap;
  while (offset < low) offset += set.spacing * draw(set, k++).gap;

  const Vec2 normal = perp(direction(set.dip));
  const double far = 2 * (2 * box.extent() + (anchor - box.centre()).norm() + distance);
  std::vector<Polyline> lines;
  while (offset <= high) {
    const Draw d = draw(set, k++);
    const Vec2 a = anchor + offset * normal, along = direction(set.dip + d.tilt);
    if (auto part = clip_to_box(a, along, -far, far, box))
      add_parts(set, a, along, part->first, part->second, d.phase, lines);
    offset += set.spacing * d.gap;
  }
  return lines;
}

}  // namespace talus
