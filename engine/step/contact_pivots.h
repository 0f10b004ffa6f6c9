#pragma once
// A few contacts that are stiffly tied to each other, solved as a whole. With Coulomb's friction in the plane the
// coupled law is a linear complementarity problem (Klarbring 1986): where Newton's steps on the states do not settle,
// Lemke's pivots (1965) end in a finite number, at the cost of the cube of the contacts.
#include <Eigen/Core>
#include <vector>

namespace talus {

struct PivotContact {
  double gap0, slide0;        // m, without forces at any of them
  double kn, ks;              // N/m
  double friction, cohesion;  // tan φ; N. Finite
  bool closed, stuck;         // taken for so; in the end, found so
  double normal, shear;       // N; before, the sign of `shear` is the way of what slips. Found
};

// W: m/N, gap and slide of each contact, in turn, under unit forces along them: x = x0 + W (N, -T). Whether the forces
// are found at which gap and slide meet the law of ContactTerms: N = kn max(0, -gap), T = ks slide within ± (N tan φ +
// c).
bool pivot_contacts(std::vector<PivotContact>& contacts, const Eigen::MatrixXd& w);

}  // namespace talus
