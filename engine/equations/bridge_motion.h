#pragma once
// Bridges over failed bonds (equations/bridge_terms.h) in a step of motion. In it the strength is one number, so that
// the law is a line up to it and constant beyond: convex, and judged like a contact at the step's end, y₁, it takes
// energy whatever the step. The number is the mean of the strengths at both ends of the step, with which the work is
// that of the falling branch to second order. Which branch each point is on is found by solving again, as for contacts.
#include <array>
#include <vector>

#include "equations/bridge_law.h"
#include "equations/system.h"

namespace talus {

class BridgeMotion {
 public:
  void begin(const Model& model);  // of an attempt at a step: all as it is at its start
  bool any() const { return !points_.empty(); }
  void add(const Model& model, const Poses& poses, const Scheme& scheme, System& system);
  // Whether the solution d keeps to the laws; else they go on from it with the next add().
  bool agrees(const Vector& d);
  bool gives_up() const { return rounds_ > most_rounds; }
  // J/m: what the bridges take along y less along X, which is the integrator's; without what the system's matrix makes
  // of their lines (ledger.cpp, book_linear). Before the model moves.
  double shift_loss(const Model& model, const Scheme& scheme, const Vector& d) const;
  // Asks the laws for where the solution leads. They may be the script's and fail: before the model moves. J/m that the
  // bridges store more there.
  double lead(const Model& model);
  // The step is accepted, after lead(): its jumps and tractions. J/m that the bridges have taken in it, along y.
  double keep(Model& model) const;

 private:
  static constexpr int most_rounds = 40, settling_rounds = 6;

  enum class Branch { loose, line, constant };
  struct Direction {
    double from = 0, worn = 0, reach = 0;  // m, of the jump since it failed, at the start of the step
    double slope = 0;                      // Pa/m, of the line
    double first = 0, limit = 0;           // Pa: strength at the start; in the step
    Branch branch = Branch::loose;
    double sign = 1;                        // of a constant traction
    double free = 0, to = 0, traction = 0;  // m at d = 0, m and Pa of the solution
    Row row_a, row_b;                       // change of the jump under unit unknowns
    double at(double x) const;              // Pa, on the branch
    void go_on(bool across);
  };
  struct Point {
    int joint, point;
    int dof_a, dof_b, size_a, size_b;
    std::array<Direction, 2> along;  // across the joint, along it
    JointPoint led_to;               // by lead()
  };
  void add_point(const Model& model, const Point& point, System& system) const;

  std::vector<Point> points_;
  std::vector<double> strength_;  // Pa, of each point: scale of its tractions
  std::vector<BridgeLaws> laws_;
  double factor_ = 1;  // of d
  int rounds_ = 0;
};

}  // namespace talus
