#pragma once
// The contact solution of a step: which contacts are open, which stick, which slip, and the unknowns that go with it.
// Loose assemblies in motion are solved by sweeps over contact forces with Newton's steps between them; bonded blocks, and
// equilibrium, by Newton's steps on the coupled Coulomb law where states have settled, else on the convex potential of
// springs and of friction at a frozen normal force (docs/theory.md, § 6). A solution is accepted only when the residual of
// the coupled law, friction at the present normal force, is below its tolerance in every block: not when the states have
// stopped flipping.
#include <algorithm>

#include "equations/contact_terms.h"
#include "equations/linear_solver.h"
#include "step/contact_sweeps.h"

namespace talus {

struct OpenCloseResult {
  bool converged = false;
  bool missed = false;   // a contact presses that was not solved for
  int iterations = 0;    // solves with a factor
  int sweeps = 0;
  double sweep_change = 0;  // of the forces in the last pair, part of their norm
  double residual = 0;    // largest over blocks, of force scale
  int worst_block = -1;
  int singular_block = -1;  // where the matrix was not positive definite
};

class OpenClose {
 public:
  // Solves for d, from the contacts' last states and forces. Tolerance and residual are relative to the forces that meet
  // in a block (see force_floor in the source). `motion`: sweeps serve; in equilibrium, where nothing but its neighbours
  // holds a loose block, they waste time.
  OpenCloseResult solve(const Model& model, System& system, const ContactTerms& contacts, LinearSolver& solver,
                        double tolerance, int max_iterations, bool motion, Vector& d);
  // Residual at d = 0 without solving.
  OpenCloseResult judge(const Model& model, const System& system, const ContactTerms& contacts);
  // Residual at d, as solve() has it.
  OpenCloseResult judge(const Model& model, const System& system, const ContactTerms& contacts, const Vector& d);
  // States, forces and stretches of the last solution into the model's contacts.
  void store(Model& model, const ContactTerms& contacts) const;

 private:
  void start(const Model& model, const System& system, const ContactTerms& contacts);
  void evaluate(const ContactTerms& contacts, const Vector& d);
  void residual(const System& system, const ContactTerms& contacts, bool coupled, Vector& r) const;
  double sweep(const Model& model, const System& system, const ContactTerms& contacts, int most, int worth,
               ContactSweeps::Carry carry, Vector& d, OpenCloseResult& result);
  void take_states(const ContactTerms& contacts);
  void take_forces(const ContactTerms& contacts);
  void solve_motion(const Model& model, System& system, const ContactTerms& contacts, LinearSolver& solver,
                    double tolerance, int max_iterations, Vector& d,
                    OpenCloseResult& result);
  void solve_bonded(const Model& model, System& system, const ContactTerms& contacts, LinearSolver& solver,
                    double tolerance, int max_iterations, bool motion, Vector& d,
                    OpenCloseResult& result);
  int changed_states(const ContactTerms& contacts) const;
  void continue_states(const Model& model);
  bool factor(System& system, const ContactTerms& contacts, LinearSolver& solver, OpenCloseResult& result);
  void predict(const Model& model, const System& system, const ContactTerms& contacts, LinearSolver& solver, Vector& d,
               OpenCloseResult& result);
  void convex_step(const Model& model, const System& system, const ContactTerms& contacts, LinearSolver& solver,
                   Vector& d, OpenCloseResult& result);
  bool coupled_step(const Model& model, const System& system, const ContactTerms& contacts, LinearSolver& solver,
                    double tolerance, Vector& d, OpenCloseResult& result);
  // Takes `step` of p_: places, friction limits and the residual follow.
  void advance(const Model& model, const System& system, const ContactTerms& contacts, double step, Vector& d,
               OpenCloseResult& result);
  // d was changed: the same.
  void arrive(const Model& model, const System& system, const ContactTerms& contacts, const Vector& d,
              OpenCloseResult& result);
  void multiply(const System& system);  // kp_ = K p_
  double contact_slope(const ContactRows& row, size_t k, double step, double gap_rate, double slide_rate,
                       double factor) const;
  double normal_force(const ContactRows& row, size_t k) const { return row.kn * std::max(0.0, -gap_[k]); }
  double friction_limit(const ContactRows& row, double normal) const;
  void judge_residual(const Model& model, const System& system, const ContactTerms& contacts, double place_rounding,
                      OpenCloseResult& result);
  double line_search(const ContactTerms& contacts, const Vector& p, double slope0, double curvature) const;

  std::vector<double> gap_, slide_, limit_;  // per contact, at the present d; limit_: frozen friction limit, N
  std::vector<double> pace_, last_change_;    // of the limits: part of a change that is taken; last change, N
  std::vector<char> closed_, stuck_, factored_closed_, factored_stuck_;
  std::vector<double> normal_, shear_;  // N, forces of the sweeps
  ContactSweeps sweeps_;
  bool missed_ = false;
  Vector kd_, r_, p_, kp_;
};

}  // namespace talus
