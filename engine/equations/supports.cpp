#include "equations/supports.h"

#include "equations/side.h"
#include "model/gauss.h"

namespace talus {

namespace {

// E, of the block that is held: far stiffer than it is, far from the limits of the arithmetic.
constexpr double point_stiffness = 1e4;

Mat2 held_directions(const Fixity& fixity) {
  return Vec2(fixity.held[0], fixity.held[1]).asDiagonal();
}

// A support at the configuration of linearisation, under the unknowns.
template <int n>
struct Held {
  RowsOf<n> displacement, flux;  // under unit unknowns, in the held directions
  Vec2 gap, traction;            // m, Pa, at d = 0
};

// m, in the held directions, of what lies as it does.
Vec2 gap_at_rest(const Model& model, const SupportPoint& point, double t) {
  const Fixity& fixity = model.scene.fixities[point.fixity];
  return held_directions(fixity) * (model.moved(fixity, t) - flown(model, point.block, 0).displacement(point.in_block));
}

// Where y is not X, as it was solved for.
Vec2 gap_now(const Model& model, const SupportPoint& point, double ahead) {
  return ahead == 0 || model.support_gaps.empty() ? gap_at_rest(model, point, model.time)
                                                  : model.support_gaps[size_t(point.number)];
}

// m, of where a fixity is at y as a step of dt ends: as it would go on. It may jump then, which no block that it holds
// can know.
Vec2 wanted_at_end(const Model& model, const Fixity& fixity, const Scheme& scheme) {
  const double end = model.time + scheme.dt;
  return model.moved(fixity, end) + scheme.bond_ahead * fixity.speed(end, scheme.dt);
}

template <int n>
Held<n> held_at(const Model& model, const SupportPoint& point, const Pose& pose, const Scheme& scheme) {
  const Fixity& fixity = model.scene.fixities[point.fixity];
  const Mat2 held = held_directions(fixity);
  const Side side = side_of(model, pose, point.block, point.normal, 1);
  const Pose end = flown(model, point.block, scheme.dt);
  const Vec2 ahead = end.displacement(point.in_block) + scheme.bond_ahead * end.velocity_at(point.in_block);
  Held<n> h;
  h.displacement = held * pose.rows<n>(point.in_block, pose.place(point.in_block));
  h.flux = RowsOf<n>::Zero();
  h.traction = Vec2::Zero();
  if (point.normal != Vec2::Zero()) {
    h.flux = held * side.flux<n>(point.in_block);
    h.traction = held * side.traction_at(point.in_block, scheme.bond_v);
  }
  h.gap = scheme.bond_end * held * (wanted_at_end(model, fixity, scheme) - ahead);
  if (scheme.bond_end < 1) h.gap += (1 - scheme.bond_end) * gap_now(model, point, scheme.bond_ahead);
  return h;
}

}  // namespace

void Supports::prepare(const Model& model, const std::vector<double>& edge_stiffness) {
  points_.clear();
  for (const PointFixity& p : model.point_fixities)
    if (model.shapes[p.block].dofs > 0)
      points_.push_back({int(points_.size()), p.fixity, p.block, p.in_block, Vec2::Zero(), 1,
                         point_stiffness * model.material(p.block).young});
  for (size_t e = 0; e < model.edge_fixities.size(); ++e) {
    const EdgeFixity& edge = model.edge_fixities[e];
    if (model.shapes[edge.block].dofs == 0) continue;
    for (const GaussPoint& point : gauss_points(model.shapes[edge.block]))
      points_.push_back({int(points_.size()), edge.fixity, edge.block, between(edge.in_block, point.at), edge.normal,
                         edge.length * point.share, edge_stiffness[e]});
  }
}

void Supports::add(const Model& model, const Poses& poses, const Scheme& scheme, System& system) const {
  for (const SupportPoint& point : points_) {
    if (model.sleeps(point.block)) continue;
    const BlockShape& shape = model.shapes[point.block];
    const Pose& pose = poses.blocks[point.block];
    with_size(shape.second_order(), [&](auto n) {
      const auto [t, s, gap, traction] = held_at<n>(model, point, pose, scheme);
      const double w = point.weight, k = point.stiffness;
      system.add_force(shape, point.block,
                       ColumnOf<n>(w * (t.transpose() * (traction + k * gap) - s.transpose() * gap)));
      system.add_rounding(point.block, k * w, pose.shift.norm());
      system.matrix.add(
          system.matrix.slot(point.block, point.block), false,
          MatrixOf<n>(w * scheme.bond_d * (k * t.transpose() * t - t.transpose() * s - s.transpose() * t)));
    });
  }
}

double Supports::energy(const Model& model, double ahead) const {
  double sum = 0;
  for (const SupportPoint& point : points_) {
    const Pose pose = flown(model, point.block, 0);
    const Side side = side_of(model, pose, point.block, point.normal, 1);
    const Vec2 gap = gap_now(model, point, ahead);
    sum += point.weight * (side.traction_at(point.in_block, ahead) + point.stiffness / 2 * gap).dot(gap);
  }
  return sum;
}

// The loss is B(Δg, ḡ - (g0 + g1)/2) with the gap ḡ the step was solved with, those at its ends as the blocks lie,
// and B the bilinear form of the energy. The matrix makes B(t ΔX, t w) of it, which for a block that swings on a
// pin is no change of a gap but (ω Δt)² of its size.
Supports::Work Supports::work(const Model& model, const Poses& poses, const Scheme& scheme, const Vector& d,
                              const std::vector<BlockState>& moved, double ahead0, double ahead1) const {
  Work sum;
  for (const SupportPoint& point : points_) {
    if (model.sleeps(point.block)) continue;
    with_size(model.shapes[point.block].second_order(), [&](auto n) {
      const Fixity& fixity = model.scene.fixities[point.fixity];
      const auto [t, s, gap, traction] = held_at<n>(model, point, poses.blocks[point.block], scheme);
      const Mat2 held = held_directions(fixity);
      const auto wanted = [&](double seconds) -> Vec2 { return held * fixity.moved(model.time + seconds); };
      const BlockShape& shape = model.shapes[point.block];
      const ColumnOf<n> own = of_block<n>(shape, d);
      const ColumnOf<n> v0 = model.blocks[point.block].velocity.column<n>();
      const ColumnOf<n> step = scheme.step_v * v0 + scheme.move_d * own;
      const ColumnOf<n> w = scheme.bond_v * v0 + (scheme.bond_d - scheme.move_d / 2) * own;
      const Vec2 before = wanted(0) - held * flown(model, point.block, 0).displacement(point.in_block);
      const Vec2 after = wanted(scheme.dt) - held * flown(shape, moved[point.block], 0).displacement(point.in_block);
      const Vec2 mean = gap - scheme.bond_d * (t * own);
      const Vec2 jump = after - before, jump_w = mean - (before + after) / 2;
      const auto form = [&](const Vec2& g, const Vec2& g_w) {
        return point.weight * ((s * step).dot(g_w) + (s * w).dot(g) + point.stiffness * g.dot(g_w));
      };
      sum.numerical += form(jump, jump_w) - form(-t * step, -t * w);
      const Vec2 force = point.weight * (traction + scheme.bond_d * (s * own) + point.stiffness * mean);
      const Pose& pose = poses.blocks[point.block];
      sum.lift +=
          lift_of_lever(model, scheme, moved, point.block) * force.dot(pose.place(point.in_block) - pose.centroid);
      if (fixity.motion == Fixity::none) return;
      // Before the first step as it begins, past what jumps then.
      const Vec2 from = model.support_speeds.empty() ? fixity.speed(model.time + scheme.dt / 32, scheme.dt)
                                                     : model.support_speeds[size_t(point.fixity)];
      const Vec2 moved_x = wanted(scheme.dt) - wanted(0),
                 moved_y = moved_x + held * (ahead1 * fixity.speed(model.time + scheme.dt, scheme.dt) - ahead0 * from);
      sum.boundary += force.dot(moved_y);
      sum.numerical += force.dot(moved_y - moved_x);
    });
  }
  return sum;
}

std::vector<Vec2> Supports::gaps(const Model& model) const {
  std::vector<Vec2> gaps;
  for (const SupportPoint& point : points_) gaps.push_back(gap_at_rest(model, point, model.time));
  return gaps;
}

void Supports::store(const Poses& poses, const Scheme& scheme, const Vector& d, Model& model) const {
  model.support_tractions.resize(points_.size(), Vec2::Zero());
  model.support_speeds.clear();
  for (const Fixity& fixity : model.scene.fixities)
    model.support_speeds.push_back(fixity.speed(model.time + scheme.dt, scheme.dt));
  for (const SupportPoint& point : points_) {
    if (model.sleeps(point.block)) continue;
    with_size(model.shapes[point.block].second_order(), [&](auto n) {
      const Held<n> held = held_at<n>(model, point, poses.blocks[point.block], scheme);
      const ColumnOf<n> own = of_block<n>(model.shapes[point.block], d);
      const Vec2 mean = held.gap - scheme.bond_d * (held.displacement * own);
      model.support_tractions[size_t(point.number)] =
          held.traction + scheme.bond_d * (held.flux * own) + point.stiffness * mean;
      if (scheme.bond_ahead == 0) return;
      Vec2& gap = model.support_gaps[size_t(point.number)];
      gap = (mean - (1 - scheme.bond_end) * gap) / scheme.bond_end;
    });
  }
}

std::vector<Vec2> Supports::reactions(const Model& model, double t) const {
  std::vector<Vec2> sum(model.scene.fixities.size(), Vec2::Zero());
  for (const SupportPoint& point : points_) {
    const auto at_rest = [&] {
      const Pose pose = flown(model, point.block, 0);
      const Vec2 traction = side_of(model, pose, point.block, point.normal, 1).traction_at(point.in_block, 0);
      return Vec2(held_directions(model.scene.fixities[point.fixity]) * traction +
                  point.stiffness * gap_at_rest(model, point, t));
    };
    sum[point.fixity] +=
        point.weight * (model.support_tractions.empty() ? at_rest() : model.support_tractions[size_t(point.number)]);
  }
  return sum;
}

}  // namespace talus
