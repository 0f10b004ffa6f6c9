#pragma once
// Douglas–Rachford splitting of a step's contacts (Lions & Mercier 1979; for friction: Tasora et al. 2021, as ADMM). A
// spring of its own binds each contact's gap and slide to copies of them. The copies meet Coulomb's law one by one, in
// closed form; the blocks follow all springs at once, by one factor that serves for the whole run. What reaches far,
// which sweeps carry from contact to contact, goes in one solve. Carried on by Anderson's mixing. docs/theory.md, § 6.
#include "step/contact_problem.h"
#include "step/mixing.h"

namespace talus {

class ContactSplitting {
 public:
  struct Progress {
    bool factored = true;  // false: the matrix was not positive definite
    bool settled = false;  // states stay as they are
    int iterations = 0;
    double change = 0;  // N, of what the copies ask for, in the last one
  };
  // Per contact of the problem, in and out.
  struct Contacts {
    std::vector<double>&normal, &shear;  // N
    std::vector<char>&closed, &stuck;
  };

  // From the forces, and d, whose places they belong to, until no state has changed in so many `quiet` iterations,
  // `most` at most. `rough`: the states are not yet known and all springs are alike; ends when few change. Otherwise
  // springs are chosen by the states: stiff where a contact presses or sticks, soft where it does not, which is what
  // the springs of the other kind make slow.
  Progress run(ContactProblem& problem, bool rough, int quiet, int most, Contacts contacts, Vector& d);

 private:
  struct Copy : ContactScalars {  // of a contact that takes part
    int row;                      // of the problem
    double spring, shear_spring;  // N/m
    size_t begin;                 // of its rows in packed_: of the gap, then of the slide, each of block i and j
    double along(const double* rows, const Vector& d) const;
    void add(const double* rows, double force, Vector& f) const;
  };
  bool factor(ContactProblem& problem, bool rough, const Contacts& contacts);
  void pack(const ContactRows& row, int number, double spring, double shear_spring);
  void ask(const ContactProblem& problem, const Contacts& contacts, const Vector& d, Vector& asked) const;
  int answer(const ContactProblem& problem, Contacts contacts, Vector& force) const;

  std::vector<Copy> copies_;
  std::vector<double> packed_;  // a third of what the problem's rows take, which every iteration reads twice
  // What a copy is asked with, N: its force, less (of slides: plus) what its spring gives for the contact's gap. Normal
  // parts, then shear.
  Vector asked_, next_, force_, solved_, change_;
};

}  // namespace talus
