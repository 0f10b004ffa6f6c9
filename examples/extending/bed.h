// A term of one's own: an elastic bed (Winkler 1867) under an edge. Where the edge moves by u it pulls back by k u, per
// length.
#pragma once
#include "equations/side.h"
#include "equations/term.h"
#include "model/gauss.h"

class Bed : public talus::Term {
 public:
  // Under the edges of blocks that lie between `from` and `to` (m) at the start; along x and along y (Pa/m).
  Bed(const talus::Model& model, talus::Vec2 from, talus::Vec2 to, talus::Vec2 stiffness) : stiffness_(stiffness) {
    for (int b = 0; b < int(model.shapes.size()); ++b) {
      const talus::BlockShape& shape = model.shapes[b];
      if (shape.dofs == 0) continue;  // held
      const talus::Vec2 centroid = shape.reference_centroid + model.origin;
      for (int k = 0; k < model.vertex_count(b); ++k) {
        const std::array edge = {model.reference_vertex[shape.vertex_begin + k],  // from the centroid
                                 model.reference_vertex[shape.vertex_begin + model.next_vertex(b, k)]};
        if (!between(centroid + edge[0], from, to) || !between(centroid + edge[1], from, to)) continue;
        for (const talus::GaussPoint& point : talus::gauss_points(shape))
          points_.push_back({b, talus::between(edge, point.at), (edge[1] - edge[0]).norm() * point.share});
      }
    }
  }

  void add(const talus::Model& model, const talus::Poses& poses, const talus::Scheme& scheme,
           talus::System& system) const override {
    for (const Point& point : points_) {
      if (model.sleeps(point.block)) continue;
      const talus::BlockShape& shape = model.shapes[point.block];
      const talus::Pose& pose = poses.blocks[point.block];
      // As of bonds: weighed from the two ends of the step (scheme.h).
      const talus::Vec2 start = ahead(talus::flown(model, point.block, 0), point, scheme.bond_ahead);
      const talus::Vec2 end = ahead(talus::flown(model, point.block, scheme.dt), point, scheme.bond_ahead);
      const talus::Vec2 u = (1 - scheme.bond_end) * start + scheme.bond_end * end;
      talus::with_size(shape.second_order(), [&](auto n) {
        const talus::RowsOf<n> t = pose.rows<n>(point.in_block, pose.place(point.in_block));  // u under unit unknowns
        const talus::RowsOf<n> pull = point.length * stiffness_.asDiagonal() * t;
        system.add_force(shape, point.block, talus::ColumnOf<n>(-pull.transpose() * u));
        system.matrix.add(system.matrix.slot(point.block, point.block), false,
                          talus::MatrixOf<n>(scheme.bond_d * t.transpose() * pull));
      });
    }
  }

  double energy(const talus::Model& model, double seconds) const override {
    double sum = 0;
    for (const Point& point : points_) {
      const talus::Vec2 u = ahead(talus::flown(model, point.block, 0), point, seconds);
      sum += point.length / 2 * u.dot(stiffness_.asDiagonal() * u);
    }
    return sum;
  }

 private:
  struct Point {  // of integration
    int block;
    talus::Vec2 in_block;  // m, from the centroid, undeformed
    double length;         // m that it stands for
  };

  static talus::Vec2 ahead(const talus::Pose& pose, const Point& point, double seconds) {
    return pose.displacement(point.in_block) + seconds * pose.velocity_at(point.in_block);
  }
  static bool between(const talus::Vec2& p, const talus::Vec2& from, const talus::Vec2& to) {
    return (p - from).norm() + (p - to).norm() < (1 + 1e-9) * (to - from).norm();
  }

  talus::Vec2 stiffness_;
  std::vector<Point> points_;
};
