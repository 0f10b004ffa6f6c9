#pragma once
// Nonlinear Gauss–Seidel over contacts, in forces (Moreau 1988, Jean 1999: non-smooth contact dynamics): each contact
// in turn gets the normal and shear force that meet its whole law, Coulomb's cone included, with all other forces held.
// In forces a stiff contact is an easy one: only the bodies' own inertia and stiffness make neighbours depend on each
// other, so what waves cannot cross in a step converges in a few sweeps, without a factor. Blocks that hang together by
// bonds move as patches of a few, and what holds patches together is relaxed from patch to patch in the same sweep.
// Between pairs of sweeps the forces are carried on: by Nesterov's momentum (1983) with restart (O'Donoghue & Candès
// 2015), or by Anderson's mixing, dearer and surer.
#include <algorithm>
#include <cmath>

#include "step/contact_problem.h"
#include "step/contact_settling.h"
#include "step/mixing.h"

namespace talus {

class Sweeping {
 public:
  enum class Carry { momentum, mixing };
  struct End {
    int most;       // pairs: a sweep forwards and one backwards
    double enough;  // change of the forces, part of their norm
    // > 0: earlier where they are not on the way to be done within so many pairs more, as soon as no more than
    // `changing` contacts have come to another state in ten pairs.
    int worth = 0;
    int changing = 0;
  };
  struct Progress {
    int pairs = 0;
    double change = 0;  // of the last pair, part of the norm of all forces
    double moved = 0;   // the same, N: comparable where forces are wound up
  };
};

// Of blocks that have at most `size` unknowns. Each block's unknowns are taken in the axes and units in which its own
// matrix is 1, z = Lᵀd with L Lᵀ = K of the block: a block that hangs on no other is then moved along the very rows
// that its contacts feel, and half as much is read for a contact.
template <int size>
class SweepsOf : public Sweeping {
 public:
  void start(const ContactProblem& problem);
  Progress run(const End& end, Carry carry, std::vector<double>& normal, std::vector<double>& shear, Vector& d);
  bool bonded() const;

 private:
  using Column = ColumnOf<size>;
  using Matrix = MatrixOf<size>;
  using Link = SweptContact<size>;
  struct Tie {  // K of this block over the unknowns z of one of another patch
    int other;
    Matrix k;
  };
  // The larger the patches the fewer the sweeps; a patch costs the cube of its unknowns.
  static constexpr size_t most_in_patch = 6;
  struct Patch {  // of blocks that hang together by bonds, few enough for a matrix of their own
    std::vector<int> blocks;
    bool unit = false;        // its matrix is 1
    Eigen::MatrixXd inverse;  // `size` a block; zero for unknowns that are none
  };
  struct Tied {  // a block that hangs on other patches
    int block, patch;
    std::vector<Tie> ties;
  };
  struct State {
    std::vector<ContactForces> forces;
    std::vector<Column> bond;
    std::vector<Lanes<size>> motion;
  };
  std::vector<std::vector<Tie>> find_ties(const std::vector<int>& place) const;
  void find_patches(std::vector<std::vector<Tie>> ties);
  void add_link(const ContactRows& row, int contact, const std::vector<int>& place);
  SweptRows<size> add_moved(const Link& link);
  void put_in_order();
  void pack();
  std::vector<SweptGroup<size>> grouped(const std::vector<int>& contacts) const;
  std::vector<int> moved_by(const std::vector<int>& contacts) const;
  void take(const std::vector<double>& normal, const std::vector<double>& shear, const Vector& d);
  void relax(size_t tied);
  bool keeps_swept() const { return kept_whole_ >= 2; }
  void keep_forces(State& to) const;
  void keep(State& to) const;
  void rebuild();  // motion_ from the forces
  void watch();    // sets active_
  void look_at_changing(const State& from, double change);
  bool none_closes() const;
  int changed_states();  // since it was last asked
  void sweep(bool backwards);
  struct Change;
  Change change(const State& from, const State& last) const;
  void carry_on(const State& last, double momentum, bool anew);
  void mix(const State& from, Mixing& mixing);
  SweepView<size> view() {
    return {contacts_.data(),    int(contacts_.size()), rows_.data(),   moved_.data(),
            moved_block_.data(), forces_.data(),        motion_.data(), factor_};
  }

  std::vector<Link> contacts_;
  std::vector<SweptRows<size>> rows_;
  std::vector<ContactForces> forces_;  // of contacts_, and none at the end
  std::vector<char> state_;            // of contacts_, as changed_states() left them
  std::vector<double> gap_;            // m, of contacts_ when they were last looked at all
  struct Swept {
    std::vector<int> contacts;  // of contacts_
    std::vector<SweptGroup<size>> groups;
    std::vector<int> blocks;  // of blocks_, that they move; of changing_ alone
  };
  Swept active_;     // all that press or may soon
  Swept changing_;   // those of them that still change, and what is beside them
  bool all_ = true;  // of active_ are swept
  // states since others are swept: after two both that a pair is compared with have what does not change
  int kept_whole_ = 0;
  const Swept& swept() const { return all_ ? active_ : changing_; }
  std::vector<SweptMotion<size>> moved_;
  std::vector<int> moved_block_;        // whose that is
  std::vector<int> blocks_;             // of the problem, those that move
  std::vector<Matrix> lower_, to_own_;  // L and L⁻¹ of each block
  std::vector<Patch> patches_;
  std::vector<int> patch_of_, rank_;         // of each block, and its place there
  std::vector<Tied> tied_;                   // patch by patch
  std::vector<Lanes<size>> force_, motion_;  // of blocks_, L⁻¹f and z; and a zero at the end
  std::vector<Column> bond_;                 // N, of tied_: force on the block by its ties, as it was last relaxed
  const ContactProblem* problem_ = nullptr;
  double factor_ = 1;
};

class ContactSweeps : public Sweeping {
 public:
  // Takes the blocks of the problem and the contacts on them. O(blocks + contacts).
  void start(const ContactProblem& problem);

  // From the forces (N; per contact of the step). d: unknowns, from which the forces between patches start.
  Progress run(const End& end, Carry carry, std::vector<double>& normal, std::vector<double>& shear, Vector& d) {
    return second_order_ ? second_.run(end, carry, normal, shear, d) : first_.run(end, carry, normal, shear, d);
  }

  // Whether most patches hang together with others: then sweeps are slow, and dear.
  bool bonded() const { return second_order_ ? second_.bonded() : first_.bonded(); }

 private:
  bool second_order_ = false;  // some block is
  SweepsOf<first_order_dofs> first_;
  SweepsOf<second_order_dofs> second_;
};

}  // namespace talus
