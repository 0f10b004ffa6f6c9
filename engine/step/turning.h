#pragma once
// What blocks that turn within a step are pressed by: each contact of a step is a straight line for the whole of it.
#include <vector>

#include "equations/contact_terms.h"
#include "equations/scheme.h"

namespace talus {

// rad, by blocks that something presses on as the step begins.
double largest_turn_of_pressed(const Model& model, const std::vector<BlockState>& moved);

// J/m, by which the work of the normal forces that solve the step along the gaps as they come to be differs from that
// along the straight lines it was solved with: energy that appears or is lost as blocks turn, Σ N |Δg - n·Δu|, of
// second order in the angle.
struct TurningWork {
  double all = 0;       // of contacts one of whose blocks turns by more than `least` (rad)
  double of_turns = 0;  // by more than `straight`, which is no less
};
// `d` solves the step and leads to `moved`.
TurningWork work_of_turning(const Model& model, const ContactTerms& contacts, const Scheme& scheme, const Vector& d,
                            const std::vector<BlockState>& moved, double least, double straight);

// J/m, by which the step lifts y beyond what the forces that solve it give: y = X + ahead·v lies on the tangent of a
// path that bends as what presses turns (theory, § 9).
struct Lift {
  // ahead Σ N Δn·v of this step's turns, of contacts as above, n with its levers
  double by_bend = 0;
  // the same, but of those without friction that pressed as the step began N times what their gaps at y are less than
  // the last step left them with: the turns of both steps
  double by_law = 0;
};
Lift lift_of_turning(const Model& model, const ContactTerms& contacts, const Scheme& scheme, const Vector& d,
                     const std::vector<BlockState>& moved, double least);

}  // namespace talus
