#pragma once
// Nonlinear Gauss–Seidel over contacts, in forces (Moreau 1988, Jean 1999: non-smooth contact dynamics), for blocks that
// no bond joins: each contact in turn gets the normal and shear force that meet its whole law, Coulomb's cone included,
// with all other forces held. In forces a stiff contact is an easy one: only the bodies' own inertia and stiffness make
// neighbours depend on each other, so what waves cannot cross in a step converges in a few sweeps, without a factor.
// Between pairs of sweeps the forces are carried on: by Nesterov's momentum (1983) with restart (O'Donoghue & Candès 2015), or by
// Anderson's mixing, dearer and surer.
#include "step/contact_problem.h"
#include "step/mixing.h"

namespace talus {

class ContactSweeps {
 public:
  enum class Carry { momentum, mixing };
  struct Forces {  // of a contact, N
    double n, t;
  };

  // Takes the loose blocks of the problem and the contacts on them, or none: they are not to be swept. O(blocks + contacts).
  void start(const ContactProblem& problem, bool swept = true);
  bool empty() const { return contacts_.empty(); }
  // Whether every block with unknowns is loose, so that sweeps alone can solve the step.
  bool whole() const { return whole_; }

  // Sweeps, forwards and backwards, from the forces (N; per contact of the step), at most `most` of each, until the
  // forces change by no more than `enough` of their norm. d: unknowns, of which those of loose blocks are set. With `worth`
  // > 0 gives up early where they are not on the way to be done within so many pairs more.
  struct Progress {
    int pairs = 0;
    double change = 0;  // of the last pair, part of the norm of all forces
  };
  Progress run(int most, double enough, int worth, Carry carry, std::vector<double>& normal, std::vector<double>& shear, Vector& d);

 private:
  struct Link {
    DofColumn normal_i, normal_j, shear_i, shear_j;      // rows; zero for what is not loose
    DofColumn moved_ni, moved_nj, moved_si, moved_sj;    // K⁻¹ row: motion of the blocks under unit force
    double nn, ns, ss;      // m/N: gap and slide under unit forces, without the contact's own compliance
    double gap0, slide0;    // m, with the bonded blocks' motion
    double soft_n, soft_s;  // m/N, 1 / stiffness
    double friction, cohesion;
    int i, j;               // into blocks_; the last one stands for all that is not loose
    int contact;
    double n = 0, t = 0;    // N
  };
  void settle(Link& link);
  void rebuild();  // motions_ from the forces
  void sweep(bool backwards);
  void carry_on(Link& link, double n, double t);
  void mix(const std::vector<Forces>& from, Mixing& mixing);

  std::vector<Link> contacts_;
  std::vector<int> blocks_;               // of the problem, the loose ones
  std::vector<DofMatrix> inverse_;
  std::vector<DofColumn> force_, motion_;  // of loose blocks, and a zero at the end
  const ContactProblem* problem_ = nullptr;
  double factor_ = 1;
  bool whole_ = false;
};

}  // namespace talus
