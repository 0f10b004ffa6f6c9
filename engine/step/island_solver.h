#pragma once
// Solves the islands of a step one after the other: what rests is left, a block alone is a system of its own size,
// the others are open–close's.
#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>

#include "step/islands.h"
#include "step/open_close.h"
#include "step/simulation.h"

namespace talus {

struct IslandResult : OpenCloseResult {  // iterations, residual: of the worst island; sweeps, splittings: of all
  long solves = 0;                       // iterations of all
  long factorisations = 0;
  double total_effort = 0;  // in factors of the whole scene
  // part of all blocks that move, in islands that only the splitting solved and that it did not before
  double split_anew = 0;
  IslandCounts islands;
};

enum class Rest : char {
  moves,
  settles,  // comes to rest in this step
  rests,    // stood still when it began: nothing of it changes
};

class IslandSolver {
 public:
  // After every assembly. together: the scene as one island.
  void find(const Model& model, const ContactTerms& contacts, bool together);
  // d of all islands, looked for from where it is unless it is empty. dt: where what moves by no more than rounding in
  // it and is in balance stays; 0: all is solved.
  IslandResult solve(const Model& model, const System& system, const ContactTerms& contacts,
                     const OpenCloseSettings& settings, double dt, Vector& d);
  // All rests as it did in the last solution.
  IslandResult rest_on(const System& system, Vector& d) const;
  // Largest residual at d = 0. Islands that have no more than `enough` are at rest.
  OpenCloseResult judge(const Model& model, const System& system, const ContactTerms& contacts, double enough);

  const Islands& islands() const { return islands_; }
  bool converged(int island) const { return converged_[island]; }  // in the last solve
  void leave(int island) { at_rest_[island] = Rest::rests; }       // its solution is not taken
  // The contacts after the step that d solves, but for those of what stood still and still does.
  void store(Model& model, const ContactTerms& contacts, const Vector& d, bool motion) const;

  int first(int block) const { return islands_.of(block) < 0 ? -1 : islands_.first(islands_.of(block)); }
  // Of the last solve: a block's island; blocks that press where they were not expected to.
  Rest rest(int block) const { return islands_.of(block) < 0 ? Rest::moves : at_rest_[islands_.of(block)]; }
  bool all_rest() const {
    return std::all_of(at_rest_.begin(), at_rest_.end(), [](Rest rest) { return rest == Rest::rests; });
  }
  const std::vector<int>& missed() const { return missed_; }
  template <class Visitor>
  void visit_state(Visitor& visitor) {
    visitor.growing("standing", standing_);
  }

 private:
  struct Step;  // what solve() was called with
  Rest judge_rest(const Step& step, int island);
  bool solve_single(const Step& step, int island, IslandResult& result, Vector& d);
  void solve_together(const Step& step, int island, IslandResult& result, Vector& d);
  struct Standing {  // of an island that only the splitting solved, or whose contacts keep their states
    int first = 0;
    std::int64_t touching = 0;  // a hash of which blocks do
    int splits = 0;             // times, one after the other, with the same blocks touching
    bool steady = false;        // see OpenCloseResult
    long solve = 0;             // the last it took part in; not state: what is left after a step was in it
    template <class Visitor>
    void visit_state(Visitor& visitor) {
      visitor("first", first);
      visitor("touching", touching);
      visitor("splits", splits);
      visitor("steady", steady);
    }
  };
  Standing standing_of(int first, const ContactProblem& problem) const;
  void watch(const Step& step, const Vector& d, IslandResult& result);

  Islands islands_;
  std::vector<Rest> at_rest_;    // per island
  std::vector<char> converged_;  // per island
  std::vector<int> place_, missed_;
  std::vector<ContactForces> reached_;  // per contact, by solutions that missed others; n < 0: none
  OpenClose open_close_;
  ContactProblem judged_;
  struct Kept {
    ContactProblem problem;
    long solve = 0;  // the last it took part in
  };
  std::map<int, std::unique_ptr<Kept>> kept_;  // by an island's first block: patterns and orders last for many steps
  std::vector<Standing> standing_;
  long solve_ = 0;
};

}  // namespace talus
