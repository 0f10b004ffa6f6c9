#include "geometry/joint_set.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>

#include "geometry/polygon.h"
#include "geometry/random.h"

namespace talus {
namespace {

constexpr double most_lines = 10000;      // cutting a region by n lines costs n² in time and memory: here 10 s, 0.5 GB
constexpr double most_gaps_to_box = 1e7;  // between `through` and the box
constexpr double most_parts_to_box = 1e8;  // the same along all lines together, where lengths scatter: a second

// The direction at an angle, with multiples of 90° exact: horizontal joints shall be horizontal.
Vec2 direction(double angle) {
  Vec2 d(std::cos(angle), std::sin(angle));
  for (double& component : d)
    if (std::abs(component) < 1e-15) component = 0;
  return d.normalized();
}

// What chance gives line k, drawn from the seed and k alone: a larger box adds lines and changes none.
struct Draw {
  double gap;           // to line k + 1, as a multiple of the spacing
  double tilt;          // rad
  double phase;         // [0, 1), part of the period of joint and bridge
  std::uint64_t parts;  // seed of the lengths along the line
};

std::uint64_t mixed(std::uint64_t seed, long k) {
  return Random(seed).next() + static_cast<std::uint64_t>(static_cast<std::int64_t>(k));
}

Draw draw(const JointSet& set, int k) {
  Random random(mixed(set.seed, k));
  Draw d;
  d.gap = 1 + set.spacing_scatter * random.symmetric();
  d.tilt = set.dip_scatter * random.symmetric();
  d.phase = random.unit();
  d.parts = random.next();
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

struct Line {
  Vec2 a, along;  // t is measured from a
  double first, last;
};

// Joint and bridge along a line, of lengths that chance gives: part m and the bridge behind it are drawn from the
// line and m alone.
struct Lengths {
  double jointed, gap;
};
Lengths lengths(const JointSet& set, const Draw& line, long m, double jointed, double gap) {
  Random random(mixed(line.parts, m));
  const double scatter = set.trace_length_scatter * random.symmetric();
  return {jointed * (1 + scatter), gap * (1 + set.gap_scatter * random.symmetric())};
}

// Jointed parts of the line, first ≤ t ≤ last, with bridges between them. They are walked from t = 0, where the
// phase says how far part 0 has come, out to the box.
class PartsOfLine {
 public:
  PartsOfLine(const JointSet& set, const Line& line, const Draw& draw, double jointed, std::vector<Polyline>& lines)
      : set_(set),
        line_(line),
        draw_(draw),
        jointed_(jointed),
        gap_(jointed / set.persistence - jointed),
        lines_(lines) {}

  void add_even() const {
    const double period = jointed_ + gap_;
    for (double m = std::floor((line_.first - draw_.phase * period) / period); (m + draw_.phase) * period < line_.last;
         ++m)
      add((m + draw_.phase) * period, (m + draw_.phase) * period + jointed_);
  }

  void add_scattered() const {
    const double start = draw_.phase * (jointed_ + gap_);
    double t = start;
    for (long m = 0; t < line_.last; ++m) {
      const auto [joint, bridge] = lengths(set_, draw_, m, jointed_, gap_);
      add(t, t + joint);
      t += joint + bridge;
    }
    t = start;
    for (long m = -1; t > line_.first; --m) {
      const auto [joint, bridge] = lengths(set_, draw_, m, jointed_, gap_);
      t -= joint + bridge;
      add(t, t + joint);
    }
  }

 private:
  void add(double from, double to) const {
    const double stub = 1e-9 * (line_.last - line_.first);  // of a part that just reaches into the box
    from = std::max(from, line_.first);
    to = std::min(to, line_.last);
    if (to - from > stub) lines_.push_back({line_.a + from * line_.along, line_.a + to * line_.along});
  }

  const JointSet& set_;
  const Line& line_;
  const Draw& draw_;
  double jointed_, gap_;
  std::vector<Polyline>& lines_;
};

void add_parts(const JointSet& set, const Line& line, const Draw& draw, std::vector<Polyline>& lines) {
  if (set.persistence >= 1) {
    lines.push_back({line.a + line.first * line.along, line.a + line.last * line.along});
    return;
  }
  const double jointed = set.trace_length > 0 ? set.trace_length : 5 * set.spacing;
  const double parts = static_cast<double>(lines.size()) + (line.last - line.first) * set.persistence / jointed;
  if (!(parts <= most_lines))
    refuse_short(set, set.trace_length > 0 ? "trace_length" : "spacing", jointed * parts / most_lines, jointed);
  const PartsOfLine along(set, line, draw, jointed, lines);
  if (set.trace_length_scatter > 0 || set.gap_scatter > 0)
    along.add_scattered();
  else
    along.add_even();
}

}  // namespace

std::vector<Polyline> joint_lines(const JointSet& set, const Vec2& box_min, const Vec2& box_max) {
  if (!(set.spacing > 0)) refuse(set, "spacing", "a positive length", set.spacing);
  if (!(set.persistence > 0)) refuse(set, "persistence", "a number above 0, at most 1", set.persistence);
  const Bounds box{box_min, box_max};
  const Vec2 anchor = set.through.value_or(box.centre());
  const auto [low, high] = reach(set, box, anchor);
  if (!((high - low) / set.spacing <= most_lines)) refuse_short(set, "spacing", (high - low) / most_lines, set.spacing);
  const double distance = std::max(std::abs(low), std::abs(high));
  if (!(distance / set.spacing <= most_gaps_to_box))
    refuse(set, "through", "a point near the region", (anchor - box.centre()).norm());
  const bool walked = set.persistence < 1 && (set.trace_length_scatter > 0 || set.gap_scatter > 0);
  const double walk = 2 * (box.extent() + (anchor - box.centre()).norm()) * set.persistence / set.trace_length;
  if (walked && !(walk * (high - low) / set.spacing <= most_parts_to_box))
    refuse(set, "through", "a point near the region, as lengths scatter", (anchor - box.centre()).norm());

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
      add_parts(set, {a, along, part->first, part->second}, d, lines);
    offset += set.spacing * d.gap;
  }
  return lines;
}

}  // namespace talus
