#pragma once
// The contact solution of a step: which contacts are open, which stick, which slip, and the unknowns that go with
// it. Motion is solved by sweeps over contact forces with Newton's steps between them, and by a splitting where these
// do not get on; equilibrium by Newton's steps on the coupled Coulomb law where states have settled, else on the convex
// potential of springs and of friction at a frozen normal force, and by the splitting where a few of them do not do
// (docs/theory.md, § 6 and 7). A solution is accepted only when the residual of the coupled law, friction at the
// present normal force, is below its tolerance in every block: not when the states have stopped flipping.
#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <optional>
#include <span>

#include "step/contact_problem.h"
#include "step/contact_splitting.h"
#include "step/contact_sweeps.h"

namespace talus {

constexpr double sweep_effort = 0.006;     // of a factor and what is solved with it: a sweep over some contacts a block
constexpr double splitting_effort = 0.08;  // an iteration of the splitting

struct OpenCloseResult {
  bool converged = false;
  bool missed = false;  // a contact presses that was not solved for
  int iterations = 0;   // solves with a factor
  int sweeps = 0;
  int splittings = 0;  // iterations
  int pivots = 0;      // sets of states that pivots found, each as dear as a factor
  double in_vain = 0;  // of its effort, from states of the last step that did not do
  // factors
  double effort() const { return iterations + pivots + sweep_effort * sweeps + splitting_effort * splittings; }
  bool split = false;   // the splitting found it
  bool steady = false;  // in motion: Newton's steps from the states of the last step found it, or would, as few changed
  double sweep_change = 0;  // N, of the forces in the last pair
  double residual = 0;      // largest over blocks, of force scale
  int worst_block = -1;
  int singular_block = -1;  // where the matrix was not positive definite
};

struct OpenCloseSettings {
  double tolerance;  // of the residual, part of the forces that meet in a block (see force_floor in the source)
  int max_iterations;
  // Sweeps serve; in equilibrium, where nothing but its neighbours holds a loose block, they waste time.
  bool motion;
  ContactSolver solver = ContactSolver::automatic;
  // Factors, with sweeps at their part of one, after which motion gives up: a shorter step is cheaper.
  double most_effort = std::numeric_limits<double>::infinity();
  bool split = false;   // the splitting at once where the first sweeps do not do
  bool steady = false;  // Newton's steps from the states of the last step before all sweeps
};

class OpenClose {
 public:
  // Solves for d, from where it is, or where it is empty from the contacts' last states and forces. `reached`, per
  // contact: in motion, where a solution that missed contacts had come to (`forces`), or n < 0 where d tells it.
  OpenCloseResult solve(ContactProblem& problem, const OpenCloseSettings& settings, Vector& d,
                        std::span<const ContactForces> reached = {});
  ContactForces forces(size_t contact) const { return {normal_[contact], shear_[contact]}; }  // of the last sweeps
  // Residual at d = 0 without solving.
  OpenCloseResult judge(const ContactProblem& problem);
  // Residual at d, as solve() has it.
  OpenCloseResult judge(const ContactProblem& problem, const Vector& d);
  // State, forces and stretch of a contact at the solution d of the step.
  static void store(const ContactTerms& contacts, const ContactRows& row, const Vector& d, Contact& contact);

 private:
  void start(const ContactProblem& problem);
  void evaluate(const ContactProblem& problem, const Vector& d);
  void residual(const ContactProblem& problem, bool coupled, Vector& r) const;
  double sweep(const ContactProblem& problem, const ContactSweeps::End& end, ContactSweeps::Carry carry, Vector& d,
               OpenCloseResult& result);
  void take_states(const ContactProblem& problem);
  void forces_at_present(const ContactProblem& problem);
  void take_forces(const ContactProblem& problem);
  void solve_motion(ContactProblem& problem, const OpenCloseSettings& settings, Vector& d, OpenCloseResult& result);
  void split_from_present(ContactProblem& problem, const OpenCloseSettings& settings, Vector& d,
                          OpenCloseResult& result);
  void solve_by_splitting(ContactProblem& problem, const OpenCloseSettings& settings, Vector& d,
                          OpenCloseResult& result);
  void solve_by_sweeps(ContactProblem& problem, double tolerance, Vector& d, OpenCloseResult& result);
  void solve_equilibrium(ContactProblem& problem, const OpenCloseSettings& settings, Vector& d,
                         OpenCloseResult& result);
  void solve_by_newton(ContactProblem& problem, const OpenCloseSettings& settings, int most, Vector& d,
                       OpenCloseResult& result);
  int changed_states(const ContactProblem& problem) const;
  bool go_on_steadily(ContactProblem& problem, const OpenCloseSettings& settings, Vector& d, OpenCloseResult& result);
  bool few_changed(const ContactProblem& problem) const;
  void continue_states(const ContactProblem& problem);
  bool factor(ContactProblem& problem, OpenCloseResult& result);
  void predict(ContactProblem& problem, Vector& d, OpenCloseResult& result);
  void convex_step(ContactProblem& problem, Vector& d, OpenCloseResult& result);
  struct Chosen;
  bool contradicted(const ContactProblem& problem, size_t k) const;
  int contradictions(const ContactProblem& problem) const;
  void follow_pivots(ContactProblem& problem, double tolerance, Vector& d, OpenCloseResult& result);
  void correct(ContactProblem& problem, double tolerance, Vector& d, OpenCloseResult& result);
  bool find_states(ContactProblem& problem, int most, Chosen& chosen, Vector& d);
  void choose(const ContactProblem& problem, size_t k, Chosen& chosen) const;
  void choose_slipping_beside(const ContactProblem& problem, Chosen& chosen) const;
  bool pivot(ContactProblem& problem, Chosen& chosen, Vector& d);
  struct Change;
  std::vector<Change> coupled_changes(const ContactProblem& problem) const;
  class KnownPart;
  void solve_coupled(ContactProblem& problem, const std::vector<Change>& changes, const Vector& r, double leaves,
                     Vector& p) const;
  void follow_friction(ContactProblem& problem, Vector& d);
  void full_step(ContactProblem& problem, Vector& d, OpenCloseResult& result);
  bool coupled_step(ContactProblem& problem, Vector& d, OpenCloseResult& result);
  // Takes `step` of p_: places, friction limits and the residual follow.
  void advance(const ContactProblem& problem, double step, Vector& d, OpenCloseResult& result);
  // d was changed, kd_ with it: the same.
  void arrive(const ContactProblem& problem, const Vector& d, OpenCloseResult& result);
  void go_to(const ContactProblem& problem, const Vector& d, OpenCloseResult& result);  // d was changed alone
  void multiply(const ContactProblem& problem);                                         // kp_ = K p_
  double contact_slope(const ContactRows& row, size_t k, double step, double gap_rate, double slide_rate,
                       double factor) const;
  double normal_force(const ContactRows& row, size_t k) const { return row.kn * std::max(0.0, -gap_[k]); }
  // as_it_lies: the rounding of gaps times their stiffness is no force.
  void judge_residual(const ContactProblem& problem, bool as_it_lies, OpenCloseResult& result);
  double line_search(const ContactProblem& problem, const Vector& p, double slope0, double curvature) const;

  std::vector<double> gap_, slide_, limit_;  // per contact, at the present d; limit_: frozen friction limit, N
  std::vector<double> pace_, last_change_;   // of the limits: part of a change that is taken; last change, N
  std::vector<char> closed_, stuck_, factored_closed_, factored_stuck_;
  // which d is sought with: the factored ones, but for contacts whose states pivots have found since
  std::vector<char> aimed_closed_, aimed_stuck_;
  struct Pivoted {
    std::vector<int> place;  // of each contact among these, or -1
    Compliance compliance;   // m/N, as factored: of gap and slide of each under forces along them
  };
  std::optional<Pivoted> pivoted_;
  std::vector<double> normal_, shear_;  // N, forces of the sweeps
  ContactSweeps sweeps_;
  ContactSplitting splitting_;
  bool missed_ = false;
  Vector kd_, r_, p_, kp_;
};

}  // namespace talus
