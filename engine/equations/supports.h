#pragma once
// Fixed points and edges bonded to the ground. A point is held by a spring, an edge by Nitsche's terms at two
// Gauss points, three of a second-order block; with g = (where the fixity wants the point) - (displacement of the
// block) in the held directions
//   force on the block  t = {σ}n + k g  (a point without {σ}n),   energy  {σ}n · g + ½ k g · g.
// Like the jump of a bond, the displacement is weighed from both ends of the step (Scheme::bond_end): straight
// flight alone would take a block that swings on a pin (ω Δt)² of its size away from it, times a very stiff
// spring.
#include "equations/system.h"

namespace talus {

struct SupportPoint {
  int number = 0;  // place in Model::support_gaps
  int fixity = 0, block = 0;
  Vec2 in_block = Vec2::Zero();  // from the reference centroid
  Vec2 normal = Vec2::Zero();    // outward, reference; zero for a point, which feels no {σ}n
  double weight = 1;             // m of the edge; 1 for a point
  double stiffness = 0;          // N/m3 of an edge, N/m of a point
};

class Supports {
 public:
  void prepare(const Model& model, const std::vector<double>& edge_stiffness);  // N/m3, per Model::edge_fixities
  void add(const Model& model, const Poses& poses, const Scheme& scheme, System& system) const;

  // J/m: the potential `ahead` seconds along the present velocities; where that is y, of the gaps that were solved for.
  double energy(const Model& model, double ahead) const;

  // Of a step with the solution d that takes the blocks to `moved`. `ahead0`, `ahead1`: lead of y over X before
  // and after, s.
  struct Work {
    double boundary = 0;   // J/m, force × prescribed displacement between the two y
    double numerical = 0;  // J/m, the integrator's loss (step/ledger.cpp) less what the matrix makes of it
    double lift = 0;       // J/m, of y, by blocks that turn (step/turning.h)
  };
  Work work(const Model& model, const Poses& poses, const Scheme& scheme, const Vector& d,
            const std::vector<BlockState>& moved, double ahead0, double ahead1) const;

  // For Model::support_gaps before the first step: as the blocks lie. What moves against its support as a run begins,
  // or the other way round, has not strained it yet.
  std::vector<Vec2> gaps(const Model& model) const;
  // Gaps and tractions of the step with the solution d, before the blocks have moved.
  void store(const Poses& poses, const Scheme& scheme, const Vector& d, Model& model) const;

  // N/m per fixity, on the blocks: of the last step; where there was none, as the blocks lie, with the fixities of time
  // `t`.
  std::vector<Vec2> reactions(const Model& model, double t) const;

 private:
  std::vector<SupportPoint> points_;
};

}  // namespace talus
