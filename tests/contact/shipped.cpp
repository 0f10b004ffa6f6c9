// What the engine does, and the list of all candidates.
#include "problem.h"

namespace talus::study {

void shipped(Desk& desk) {
  const Problem& problem = desk.problem;
  IslandSolver islands;
  islands.find(problem.model, problem.contacts, false);
  const Numerics& numerics = problem.model.scene.numerics;
  const OpenCloseSettings settings{numerics.contact_tolerance, numerics.max_iterations, true};
  Vector d;
  const IslandResult result =
      islands.solve(problem.model, problem.system, problem.contacts, settings, problem.scheme.dt, d);
  desk.judge(d);
  desk.outcome.residual = result.residual;
  desk.outcome.converged = result.converged;
  desk.outcome.factorisations = int(result.factorisations);
  desk.outcome.sweeps = result.sweeps;
}

const std::vector<Named>& candidates() {
  static const std::vector<Named> list = {
      {"classical flips", flips},
      {"convex Newton", convex_newton},
      {"interior point, cold", interior_point},
      {"interior point, warm", interior_point_warm},
      {"interior point on the cone", cone_interior_point},
      {"dual projected Newton", dual_newton},
      {"sweeps, plain", plain_sweeps},
      {"sweeps, Nesterov", nesterov_sweeps},
      {"sweeps, Anderson", anderson_sweeps},
      {"shipped: sweeps, Newton, splitting", shipped},
  };
  return list;
}

}  // namespace talus::study
