#include "step/contact_problem.h"

namespace talus {

void ContactProblem::take(const Model& of, const System& whole, const ContactTerms& all,
                          std::span<const int> own_blocks, std::span<const int> rows, std::vector<int>& place) {
  model = &of;
  blocks.assign(own_blocks.begin(), own_blocks.end());
  for (auto* list : {&dofs, &dof_begin}) list->clear();
  system.force_scale.clear();
  system.force_rounding.clear();
  int unknowns = 0;
  for (const int b : blocks) {
    const BlockShape& shape = of.shapes[b];
    place[b] = int(dofs.size());
    dofs.push_back(shape.dofs);
    dof_begin.push_back(unknowns);
    unknowns += shape.dofs;
    // What meets in a held block elsewhere is no scale for what happens here.
    system.force_scale.push_back(shape.dofs ? whole.force_scale[b] : 0);
    system.force_rounding.push_back(whole.force_rounding[b]);
  }
  system.force.resize(unknowns);
  for (size_t l = 0; l < blocks.size(); ++l)
    system.force.segment(dof_begin[l], dofs[l]) = whole.force.segment(of.shapes[blocks[l]].dof_begin, dofs[l]);
  contacts.take_part(all, rows, place, dof_begin);
}

void ContactProblem::take_matrix(const System& whole, const std::vector<int>& place) {
  if (system.matrix.take_part(whole.matrix, blocks, place)) ordered_ = false;
  contacts.find_slots(system.matrix);
}

}  // namespace talus
