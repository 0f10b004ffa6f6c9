#pragma once
// Equilibrium: of load steps, and the start of a settled run.
#include <limits>
#include <string>
#include <vector>

#include "equations/bridge_terms.h"
#include "step/alternation.h"
#include "step/step_parts.h"

namespace talus {

struct EquilibriumSearch {
  StepReport report;
  OpenCloseResult last;
  Vector d;  // m, last displacements
  Alternation alternation;
  int most_solves = std::numeric_limits<int>::max();
  bool may_jump = true;  // through states that are not stable
  bool jumped = false;
  bool in_place = false;   // ends where a body topples or falls
  int left = -1;           // a block of that body
  bool whole_way = false;  // friction by all that slides in the load step, not by what each solve of the search slides
};

class Equilibrium {
 public:
  explicit Equilibrium(StepParts& parts);

  // The start of a settled run: equilibrium with friction where there is one, else that in which nothing slides.
  // What is to be said to the user where there is neither, and nothing has moved.
  std::string settle();
  // Whether there is one under the present loads; the model is at it then, and anywhere where there is none.
  bool balance(EquilibriumSearch& search);
  [[noreturn]] void give_up(const EquilibriumSearch& search) const;
  bool supported(int block) const;  // or its body
  std::string unheld(int block) const;
  int culprit(const EquilibriumSearch& search) const;  // the block that is named when there is no equilibrium

 private:
  bool find(bool stick, double hold, int iterations, EquilibriumSearch& search);
  void begin();
  void give_way(EquilibriumSearch& search);
  bool balances_in_place();
  void start_sliding();
  double hold_and_leave(bool stick, const std::vector<BlockState>& moved, double least, bool limited);
  bool goes_past(const std::vector<BlockState>& moved, const Vector& d, double displacement, int& times);
  void assemble(bool stick, bool whole_way);
  IslandResult solve(Vector& d);
  void keep_rest(std::vector<BlockState>& moved);
  void accept(std::vector<BlockState>& moved, const Vector& d);

  StepParts& parts_;
  Model& model_;
  const Plan& plan_;
  RunTotals& totals_;
  BridgeTerms bridges_;
  std::vector<double> hold_;  // per block
  Vector hold_lead_;          // m; empty: none
};

}  // namespace talus
