#pragma once
// The jump of place across a joint, b - a, as a step feels it.
#include "equations/side.h"

namespace talus {

// Whether a block beside is of second order: build() has given the joint a third point then.
inline bool touches_second_order(const Joint& joint) {
  return joint.points.size() == JointPoints::most;
}

// All blocks that are awake at both ends of the step, flown once for all their bonds.
struct Ends {
  std::vector<Pose> start, end;
  Ends(const Model& model, double dt) {
    start.resize(model.blocks.size());
    end.resize(model.blocks.size());
    for (int b = 0; b < int(model.blocks.size()); ++b) {
      if (model.sleeps(b)) continue;
      start[b] = flown(model, b, 0);
      end[b] = flown(model, b, dt);
    }
  }
};

inline double spin_of(const Model& model, const Joint& joint) {  // rad/s, of the pair
  const auto spin = [&model](int block) { return model.blocks[block].velocity[2] / model.shapes[block].length; };
  return (spin(joint.a) + spin(joint.b)) / 2;
}

// The jump `seconds` ahead, at its rate relative to axes that turn with the pair.
template <int n>
Vec2 jump_ahead(const Pose& a, const Vec2& in_a, const Pose& b, const Vec2& in_b, double spin, double seconds) {
  const Vec2 jump = b.displacement<n>(in_b) - a.displacement<n>(in_a);
  if (seconds == 0) return jump;
  return jump + seconds * (b.velocity_at<n>(in_b) - a.velocity_at<n>(in_a) - spin * perp(jump));
}

// The jump of a bond, weighed between both ends of the step. n: see Pose.
template <int n>
class Jump {
 public:
  Jump(const Model& model, const Ends& ends, const Joint& joint, const Scheme& scheme)
      : scheme_(scheme),
        spin_(spin_of(model, joint)),
        start_{&ends.start[joint.a], &ends.start[joint.b]},
        end_{&ends.end[joint.a], &ends.end[joint.b]},
        from_start_(Rotation::of(spin_ * scheme.mid)),
        from_end_(Rotation::of(spin_ * (scheme.mid - scheme.dt))),
        arc_(arc(ends.start[joint.b].centroid - ends.start[joint.a].centroid)) {}

  // At d = 0, between material points of both blocks, turned to the configuration of linearisation; see
  // Scheme::bond_end.
  Vec2 at(const Vec2& in_a, const Vec2& in_b) const {
    return (1 - scheme_.bond_end) * from_start_.turn(ahead(start_, in_a, in_b)) +
           scheme_.bond_end * from_end_.turn(ahead(end_, in_a, in_b)) + arc_;
  }
  // The same of a step that has led to these poses, by what the pair has turned in it.
  Vec2 led_to(const Pose& a, const Vec2& in_a, const Pose& b, const Vec2& in_b) const {
    const auto spin = [](const Pose& p) { return p.velocity[2] / p.length; };
    const double after = (spin(a) + spin(b)) / 2;
    const Vec2 start = ahead(start_, in_a, in_b), end = jump_ahead<n>(a, in_a, b, in_b, after, scheme_.bond_ahead);
    return (1 - scheme_.bond_end) * from_start_.turn(start) + scheme_.bond_end * from_end_.turn(end);
  }
  // As the step begins, and where it has led, turned likewise.
  Vec2 before(const Vec2& in_a, const Vec2& in_b) const {
    return from_start_.turn(jump_ahead<n>(*start_[0], in_a, *start_[1], in_b, spin_, 0));
  }
  Vec2 after(const Pose& a, const Vec2& in_a, const Pose& b, const Vec2& in_b) const {
    return from_end_.turn(jump_ahead<n>(a, in_a, b, in_b, spin_, 0));
  }

 private:
  Vec2 ahead(const std::array<const Pose*, 2>& poses, const Vec2& in_a, const Vec2& in_b) const {
    return jump_ahead<n>(*poses[0], in_a, *poses[1], in_b, spin_, scheme_.bond_ahead);
  }

  // The step is linear in d about straight flight. About the d with which one centroid goes round the other, by
  // Cayley's angle as BlockShape::turn, it is the same but for this: what the jump at the end is there, less what the
  // rows of the step's middle make of that d.
  Vec2 arc(const Vec2& apart) const {
    const double turn = spin_ * scheme_.dt;
    const Vec2 d = -turn * turn / (2 + turn * turn / 2) * (2 * apart + turn * perp(apart)), way = scheme_.move_d * d;
    const Vec2 at_end = way + scheme_.bond_ahead * (scheme_.velocity_d * d - spin_ * perp(way));
    return scheme_.bond_end * from_end_.turn(at_end) - scheme_.bond_d * d;
  }

  const Scheme& scheme_;
  double spin_;                             // rad/s, of the pair
  std::array<const Pose*, 2> start_, end_;  // of blocks a and b
  Rotation from_start_, from_end_;
  Vec2 arc_;
};

// Normal of a joint where its blocks are: the mean of the two.
inline Vec2 turned_normal(const Joint& joint, const Pose& a, const Pose& b) {
  return (a.rotation.turn(joint.normal) + b.rotation.turn(joint.normal)).normalized();
}

}  // namespace talus
