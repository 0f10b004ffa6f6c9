#pragma once
// Nonlinear Gauss–Seidel over contacts, in forces (Moreau 1988, Jean 1999: non-smooth contact dynamics): each contact in
// turn gets the normal and shear force that meet its whole law, Coulomb's cone included, with all other forces held. In
// forces a stiff contact is an easy one: only the bodies' own inertia and stiffness make neighbours depend on each other, so
// what waves cannot cross in a step converges in a few sweeps, without a factor. Blocks that hang together by bonds move as
// patches of a few, and what holds patches together is relaxed from patch to patch in the same sweep.
// Between pairs of sweeps the forces are carried on: by Nesterov's momentum (1983) with restart (O'Donoghue & Candès 2015), or by
// Anderson's mixing, dearer and surer.
#include <algorithm>
#include <cmath>

#include "step/contact_problem.h"
#include "step/mixing.h"

namespace talus {

class Sweeping {
 public:
  enum class Carry { momentum, mixing };
  struct Forces {  // of a contact, N
    double n, t;
  };
  // Of one contact whose two blocks give way to it alone.
  struct ContactLaw {
    double friction, cohesion;  // tan φ; N
    double nn, ns, ss;          // m/N: gap and slide under unit forces, the contact's own compliance with them
    double by_det, by_ss, by_steep[2];  // reciprocals; of sliding either way, nought where it would wedge itself without bound

    ContactLaw() = default;
    ContactLaw(double nn, double ns, double ss, double friction, double cohesion);
    // The forces at which gap = gap0 + nn n - ns t and slide = slide0 + ns n - ss t meet the law: pressed and sticking mean gap = 0
    // and slide = 0. Cohesion holds at n = 0 too (ContactTerms::linearise).
    Forces meet(double gap0, double slide0) const {
      const double n = (slide0 * ns - gap0 * ss) * by_det, t = (nn * slide0 - ns * gap0) * by_det;
      return n > 0 && std::abs(t) <= friction * n + cohesion ? Forces{n, t} : slide_or_open(gap0, slide0, {n, t});
    }
    // `forces` cut to what the contact can carry.
    Forces carried(Forces forces) const {
      const double n = std::max(0.0, forces.n), limit = (n > 0 ? friction * n : 0) + cohesion;
      return {n, std::clamp(forces.t, -limit, limit)};
    }

   private:
    Forces slide_or_open(double gap0, double slide0, Forces stuck) const;
  };
  struct Progress {
    int pairs = 0;
    double change = 0;  // of the last pair, part of the norm of all forces
    double moved = 0;   // the same, N: comparable where forces are wound up
  };
};

// Of blocks that have at most `size` unknowns.
template <int size>
class SweepsOf : public Sweeping {
 public:
  void start(const ContactProblem& problem);
  Progress run(int most, double enough, int worth, Carry carry, std::vector<double>& normal, std::vector<double>& shear, Vector& d);
  bool bonded() const;

 private:
  using Column = ColumnOf<size>;
  using Matrix = MatrixOf<size>;
  struct Link {  // what an open contact asks for comes first
    int i, j;               // into blocks_; the last one stands for all that is held
    double gap0, slide0;    // m
    Column normal_i, normal_j;  // rows; zero for what does not move
    ContactLaw law;
    double nn, ns, ss;      // m/N: gap and slide under unit forces, without the contact's own compliance
    Column shear_i, shear_j;
    Column moved_ni, moved_nj, moved_si, moved_sj;    // motion of the blocks under unit force
    int with_begin, with_end;  // into with_
    int contact;
  };
  struct With {  // a block that a contact moves because it hangs together with those it is on
    int block;
    Column n, s;
  };
  struct Tie {  // K of this block over the displacements of one of another patch
    int other;
    Matrix k;
  };
  struct Patch {  // of blocks that hang together by bonds, few enough for a matrix of their own
    std::vector<int> blocks;
    Eigen::MatrixXd inverse;  // `size` a block; zero for unknowns that are none
  };
  struct Tied {  // a block that hangs on other patches
    int block, patch;
    std::vector<Tie> ties;
  };
  struct State {
    std::vector<Forces> forces;
    std::vector<Column> bond, motion;
  };
  std::vector<std::vector<Tie>> find_ties(const std::vector<int>& place) const;
  void find_patches(std::vector<std::vector<Tie>> ties);
  void add_link(const ContactRows& row, int contact, const std::vector<int>& place);
  void settle(const Link& link, Forces& forces);
  void move(const Link& link, double dn, double dt);  // of what the contact moves, under so much more force
  void relax(size_t tied);
  void rebuild();  // motion_ from the forces
  void sweep(bool backwards);
  struct Change;
  Change change(const State& from, const State& last) const;
  void carry_on(const State& last, double momentum, bool anew);
  void mix(const State& from, Mixing& mixing);

  std::vector<Link> contacts_;
  std::vector<Forces> forces_;  // of contacts_
  std::vector<With> with_;
  std::vector<int> blocks_;  // of the problem, those that move
  std::vector<Patch> patches_;
  std::vector<int> patch_of_, rank_;  // of each block, and its place there
  std::vector<Tied> tied_;  // patch by patch
  std::vector<Column> force_, motion_;  // of blocks_, and a zero at the end
  std::vector<Column> bond_;  // of tied_: force on the block by its ties, as it was last relaxed
  const ContactProblem* problem_ = nullptr;
  double factor_ = 1;
};

class ContactSweeps : public Sweeping {
 public:
  // Takes the blocks of the problem and the contacts on them. O(blocks + contacts).
  void start(const ContactProblem& problem);

  // Sweeps, forwards and backwards, from the forces (N; per contact of the step), at most `most` of each, until the
  // forces change by no more than `enough` of their norm. d: unknowns, from which the forces between patches start. With `worth`
  // > 0 gives up early where they are not on the way to be done within so many pairs more.
  Progress run(int most, double enough, int worth, Carry carry, std::vector<double>& normal, std::vector<double>& shear, Vector& d) {
    return second_order_ ? second_.run(most, enough, worth, carry, normal, shear, d)
                         : first_.run(most, enough, worth, carry, normal, shear, d);
  }

  // Whether most patches hang together with others: then sweeps are slow, and dear.
  bool bonded() const { return second_order_ ? second_.bonded() : first_.bonded(); }

 private:
  bool second_order_ = false;  // some block is
  SweepsOf<first_order_dofs> first_;
  SweepsOf<second_order_dofs> second_;
};

}  // namespace talus
