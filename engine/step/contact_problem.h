#pragma once
// What open–close solves: blocks that touch or hang together, cut out of a step's system, and what presses on
// them. Blocks, unknowns and rows have numbers of their own here, in the order they have in the scene, so that an
// island is solved as it would be if it were alone.
#include "equations/contact_terms.h"
#include "equations/linear_solver.h"

namespace talus {

struct ContactProblem {
  const Model* model = nullptr;  // for the contacts' last forces, and the size of the scene
  std::vector<int> blocks;       // ids, rising; held ones that are touched are among them
  std::vector<int> dofs, dof_begin;
  System system;
  ContactTerms contacts;
  LinearSolver solver;

  // Everything but the matrix: enough to judge forces at rest. `place`: where numbers are kept meanwhile, one a
  // block of the model.
  void take(const Model& of, const System& whole, const ContactTerms& all, std::span<const int> own_blocks,
            std::span<const int> rows, std::vector<int>& place);
  // The matrix. The solver's order is kept where its pattern is.
  void take_matrix(const System& whole, const std::vector<int>& place);
  // As LinearSolver::factor; the order is found only when one is asked for: sweeps need none.
  int factor() {
    if (!ordered_) solver.analyse(system.matrix);
    ordered_ = true;
    return solver.factor(system.matrix);
  }

  // The matrix with so much of the contacts' stiffness, see ContactTerms::add_stiffness.
  template <typename Number>
  int factor_with(const std::vector<Number>& closed, const std::vector<Number>& stuck) {
    std::vector<double> linear = system.matrix.values;
    contacts.add_stiffness(system.matrix, closed, stuck);
    const int singular = factor();
    system.matrix.values.swap(linear);
    return singular;
  }

  const Contact& before(size_t row) const { return model->contacts[contacts.rows()[row].contact]; }

 private:
  bool ordered_ = false;
};

}  // namespace talus
