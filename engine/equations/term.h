#pragma once
// A term of a program's own: what holds blocks elastically beside what scenes know. docs/extending.md has one, whole.
#include "equations/system.h"

namespace talus {

class Term {
 public:
  virtual ~Term() = default;
  // Its forces at d = 0 (N/m) and how they change with the unknowns, weighed over the step as those of bonds
  // (Scheme::bond_…). Blocks that sleep (Model::sleeps) are left out: they have no place in the matrix. Called at every
  // attempt at a step: what it does hangs on its arguments alone.
  virtual void add(const Model& model, const Poses& poses, const Scheme& scheme, System& system) const = 0;
  // What it stores, J/m, at the places y = X + ahead·v (step/ledger.h).
  virtual double energy(const Model& model, double ahead) const = 0;
};

}  // namespace talus
