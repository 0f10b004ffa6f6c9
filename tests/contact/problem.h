#pragma once
// A contact problem as a step of the engine has it, and the desk at which a candidate works on it: the law at any
// d, matrices with springs of any weight, the judge, and the count of what has been spent.
#include <limits>
#include <string>
#include <vector>

#include "equations/contact_terms.h"
#include "equations/linear_solver.h"
#include "step/island_solver.h"

namespace talus::study {

struct Problem {
  std::string name;
  Model model;  // at the start of the step; its contacts hold states and forces of the last one
  Scheme scheme;
  System system;
  ContactTerms contacts;
  double bare = 0;  // s, one factorisation and solve with all springs in the matrix

  // Kinetic, strain, contact and gravity energy (J per metre): at the start, and after the step by d. Those of the
  // places at which forces act (theory, § 9), contacts with the springs of the law at d.
  double energy() const;
  double energy(const Vector& d) const;
};

// Work that a candidate may spend; both take about as long.
constexpr int most_factorisations = 200;
constexpr int most_sweeps = 20000;

struct Outcome {
  bool converged = false;
  double residual = std::numeric_limits<double>::infinity();  // of the coupled law, the least that was judged
  int factorisations = 0, sweeps = 0;
  double seconds = 0;  // CPU
  Vector d;            // that of the residual
  // classical flips: the residual that their own rule accepts, or -1 where it takes a shorter step
  double accepted = -1;
  std::string note;
};

class Desk {
 public:
  explicit Desk(const Problem& problem);

  const Problem& problem;
  Outcome outcome;

  // Contacts that may press in this step.
  size_t count() const { return near_.size(); }
  const ContactRows& row(size_t k) const { return problem.contacts.rows()[near_[k]]; }
  const Contact& contact(size_t k) const { return problem.model.contacts[near_[k]]; }
  double factor() const { return problem.contacts.factor(); }
  static double limit(const ContactRows& row, double normal) {
    return normal > 0 ? row.friction * normal + row.cohesion : 0;
  }

  // Gap and stretch of every contact at d; with `rate`, their change along it.
  void places(const Vector& d, std::vector<double>& gap, std::vector<double>& slide, bool rate = false) const;
  // f - K d + Σ N n - T s
  Vector out_of_balance(const Vector& d, const std::vector<double>& normal, const std::vector<double>& shear) const;
  Vector product(const Vector& x) const;  // K x, without contacts
  // What is usual here, for interiors to start from: N, m.
  double usual_force() const;
  double usual_length() const;
  // Residual of the coupled law at d, by the engine's own judge. Sets the outcome.
  double judge(const Vector& d);
  bool done() const { return outcome.converged; }
  bool spent() const { return outcome.factorisations >= most_factorisations || outcome.sweeps >= most_sweeps; }

  // Factors K + θ Σ (normal n nᵀ + shear s sᵀ + cross (n sᵀ + s nᵀ)), weights in N/m. False where it is not
  // positive.
  bool factorise(const std::vector<double>& normal, const std::vector<double>& shear,
                 const std::vector<double>* cross = nullptr);
  void refactorise() { solver_.factor(matrix_); }  // the same once more, not counted
  void analyse_again() { solver_.analyse(matrix_); }
  void solve(const Vector& b, Vector& x) { solver_.solve(b, x); }

 private:
  struct Slots {
    BlockMatrix::Slot ii, jj, ij;
  };
  void add(size_t k, double weight, const Row& i, const Row& j);

  std::vector<size_t> near_;
  std::vector<Slots> slots_;
  BlockMatrix matrix_;
  LinearSolver solver_;
  ContactProblem whole_;  // for the judge: not by islands
  OpenClose judge_;
};

// s of CPU, the least of so many: one factorisation and solve with all springs of the problem in the matrix.
struct BareCost {
  double known = 0;  // of a pattern that has been analysed
  double fresh = 0;  // of one that has not: with its order and symbolic factor
};
BareCost bare_cost(const Problem& problem, int times);

// Runs a scene and prints what its steps cost beside a bare factorisation and solve of their system, every so many
// steps.
int report_steps(const std::string& script, const std::vector<std::pair<std::string, std::string>>& parameters);

// The candidates. Each starts from d = 0 and from the forces and states of the last step.
using Candidate = void (*)(Desk&);
struct Named {
  const char* name;
  Candidate solve;
};
const std::vector<Named>& candidates();

void flips(Desk& desk);  // Shi 1988
void convex_newton(Desk& desk);
void interior_point(Desk& desk);       // friction limits outside, each from a cold start
void interior_point_warm(Desk& desk);  // … from the last solution
void cone_interior_point(Desk& desk);  // De Saxcé & Feng 1998
void dual_newton(Desk& desk);          // projected, Bertsekas 1982
void plain_sweeps(Desk& desk);
void nesterov_sweeps(Desk& desk);
void anderson_sweeps(Desk& desk);
void shipped(Desk& desk);

}  // namespace talus::study
