#include "contact/meeting_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/outline.h"

namespace talus {

namespace {

// rad, that a way leads into a body and not along its face: a node of a mesh that has been shaken
constexpr double aslant = 1e-3;

class MeetingPoints {
 public:
  MeetingPoints(const Model& model, const Surface& surface, const std::vector<MeetingCorners>& meeting)
      : model_(model),
        surface_(surface),
        outline_(model, surface),
        meeting_(meeting),
        other_(model.vertex.size(), none) {
    for (const MeetingCorners& m : meeting) {
      meets(m.corner_a, m.b);
      meets(m.corner_b, m.a);
    }
  }

  bool drops(const Contact& c) {
    if (c.kind != ContactKind::angle_angle) return false;
    const double near = meeting_distance(model_, c.i, c.j);
    for (const int end : {c.global_edge, model_.shapes[size_t(c.j)].vertex_begin + model_.next_vertex(c.j, c.edge)})
      if ((other_[size_t(c.global_vertex)] == several || other_[size_t(end)] == several) &&
          (model_.vertex[size_t(c.global_vertex)] - model_.vertex[size_t(end)]).norm() <= near)
        return !stands_between(c.global_vertex, end) && !stands_between(end, c.global_vertex);
    return false;
  }

 private:
  static constexpr int none = -1, several = -2;

  void meets(int corner, int block) {
    int& met = other_[size_t(corner)];
    if (met == none)
      met = block;
    else if (met != block && met != several && !surface_.together(met, block))
      met = several;
  }

  // rad, from one direction to another, anticlockwise; what is clockwise by less than `aslant` counts as along.
  static double turn(const Vec2& from, const Vec2& to) {
    const double angle = std::atan2(cross(from, to), from.dot(to));
    return angle < -aslant ? angle + 2 * std::numbers::pi : angle;
  }

  // Whether nothing lies from the first corner's body anticlockwise to the second's, less than half a turn away, and
  // the one would come into the other along its side there.
  bool stands_between(int first, int second) {
    const double open = turn(outline_.behind(first), outline_.ahead(second));
    if (open < aslant || open > std::numbers::pi - aslant) return false;
    const auto leads_into = [&](const Vec2& side, int corner) {
      const double into = turn(outline_.ahead(corner), -side);
      return into > aslant && into < turn(outline_.ahead(corner), outline_.behind(corner)) - aslant;
    };
    if (!leads_into(outline_.ahead(first), second) && !leads_into(outline_.behind(second), first)) return false;
    const auto lies_there = [&](int corner) {
      return turn(outline_.behind(first), outline_.ahead(corner)) < open - aslant;
    };
    return !any_beside(first, second, lies_there) && !any_beside(second, first, lies_there);
  }

  template <typename Is>
  bool any_beside(int corner, int but, Is is) {
    if (beside_.size() != 2 * meeting_.size()) {
      for (const MeetingCorners& m : meeting_)
        beside_.insert(beside_.end(), {{m.corner_a, m.corner_b}, {m.corner_b, m.corner_a}});
      std::sort(beside_.begin(), beside_.end());
    }
    auto at = std::lower_bound(beside_.begin(), beside_.end(), std::pair(corner, -1));
    for (; at != beside_.end() && at->first == corner; ++at)
      if (at->second != but && is(at->second)) return true;
    return false;
  }

  const Model& model_;
  const Surface& surface_;
  const Outline outline_;
  const std::vector<MeetingCorners>& meeting_;
  std::vector<int> other_;                   // block of the other body that has a corner in the same place
  std::vector<std::pair<int, int>> beside_;  // corners that meet, sorted, both ways; where it has been asked for
};

}  // namespace

void drop_points(const Model& model, const Surface& surface, const std::vector<MeetingCorners>& meeting,
                 std::vector<Contact>& found) {
  MeetingPoints points(model, surface, meeting);
  std::erase_if(found, [&](const Contact& c) { return points.drops(c); });
}

}  // namespace talus
