#pragma once
// What a step came to, and what all steps of a run did.
#include <string>
#include <vector>

#include "model/state_visitor.h"

namespace talus {

struct StepReport {
  long step = 0;  // accepted steps so far
  double time = 0, dt = 0;
  int iterations = 0;       // open–close iterations (= solves) of the accepted attempt
  int cuts = 0;             // attempts thrown away before it
  int factorisations = 0;   // of these too
  double residual = 0;      // contact residual / force scale, at acceptance
  double displacement = 0;  // m, largest of any vertex
  int closed_contacts = 0;
  int failures = 0;        // bonds that failed in this step
  double utilisation = 0;  // highest of the bonds, before any failed
  double error = 0;        // of the step, estimated, as part of the fastest motion; 0 where it is not looked at
  bool collapsed = false;  // static: no equilibrium at this load; nothing was moved
};

// What islands there were in accepted steps, and how they were solved.
struct IslandCounts {
  long at_rest = 0;    // nothing moved: not solved
  long single = 0;     // a block alone
  long by_sweeps = 0;  // without a factor
  long with_factor = 0;
  long asleep = 0;  // groups of islands, left out
};

struct RunTotals {
  long steps = 0, iterations = 0, cuts = 0, factorisations = 0;
  long sweeps = 0;           // over the contacts
  long splittings = 0;       // iterations, a solve each
  long pivots = 0;           // of the iterations: with states that pivots found
  long steps_at_rest = 0;    // in which nothing moved: not solved
  long steps_by_sweeps = 0;  // solved without a factor
  IslandCounts islands;      // summed over steps
  long failures = 0;         // of bonds
  long inaccurate = 0;       // steps whose error was beyond time.tolerance at the least step there is
  int largest_iterations = 0;
  double largest_utilisation = 0;  // of a bond, when it was judged: how far strengths were passed
  double largest_residual = 0;
  struct Part {
    std::string name;
    double seconds = 0;
  };  // CPU seconds
  std::vector<Part> parts;
  double& seconds(const std::string& part);

  // Of steps: measured by the wall clock, which is read in a twentieth of the time that the CPU's takes, as ten
  // readings of that one are two thirds of the step of a single block. It is shared out as CPU time where so much of it
  // has come together that one reading does not matter.
  struct StepPart {
    const char* name;
    double wall;
  };
  struct {
    std::vector<StepPart> parts;
    double cpu = 0, wall = 0;
  } of_steps;  // s, since those readings
  void add_of_step(const char* part, double wall);
  void end_step(bool book);  // books it in any case, or where enough has come together
};

void visit_state(StepReport& report, StateVisitor& visitor);  // the registry, model/registry.h
void visit_state(RunTotals& totals, StateVisitor& visitor);

}  // namespace talus
