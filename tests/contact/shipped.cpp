// What the engine does, and the list of all candidates.
#include "problem.h"

namespace talus::study {

void shipped(Desk& desk) {
  System system = desk.problem.system;
  LinearSolver solver;
  solver.analyse(system.matrix);
  OpenClose open_close;
  Vector d;
  const Numerics& numerics = desk.problem.model.scene.numerics;
  const OpenCloseResult result = open_close.solve(desk.problem.model, system, desk.problem.contacts, solver,
                                                  numerics.contact_tolerance, numerics.max_iterations, true, d);
  desk.judge(d);
  desk.outcome.residual = result.residual;
  desk.outcome.converged = result.converged;
  desk.outcome.factorisations = int(solver.factorisations);
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
      {"shipped: sweeps and Newton", shipped},
  };
  return list;
}

}  // namespace talus::study
