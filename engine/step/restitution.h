#pragma once
// Newton's law of impact as a bound: what has met at a speed v parts at no more than e v (JointProperty::restitution).
// A step that is long beside the period of a contact leaves (1-θ)/θ of v, a shorter one more (docs/theory.md, § 3);
// this takes what is above e v.
#include "equations/contact_terms.h"
#include "equations/scheme.h"

namespace talus {

// Before a step is accepted: the speeds at which blocks meet or part as it begins.
class Restitution {
 public:
  Restitution(const Model& model, const ContactTerms& contacts);
  struct Taken {
    double energy = 0;         // J/m, that the impacts have dissipated
    double boundary_work = 0;  // J/m, of held blocks that move, by the impulses on them
  };
  // After it: contacts that have opened part no faster than they may, by the impulses along their normals that take the
  // least energy, as far as that leaves them open where forces are judged. What parts them while they are open, be it a
  // load, a support or another contact, is no rebound of theirs.
  Taken limit(Model& model, const ContactTerms& contacts, const Scheme& scheme) const;

 private:
  std::vector<double> parted_;  // m/s, per row, as the step began
};

}  // namespace talus
