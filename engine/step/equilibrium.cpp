#include "step/equilibrium.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "equations/block_terms.h"
#include "equations/viscous_terms.h"
#include "fracture/cracks.h"
#include "step/load_path.h"
#include "step/overlooked.h"
#include "step/part_timer.h"
#include "step/restored.h"
#include "step/settlement.h"
#include "step/slid_so_far.h"
#include "step/update.h"

namespace talus {

namespace {

// Equilibrium with contacts is found by steps against a little inertia, which a loose block needs to stay
// put: this part of (wave speed / size)², far below the slowest mode of what is held.
constexpr double least_hold = 1e-4;
// Of what gives way: it then moves in a step no farther than waves take it through the whole scene, so that the crack
// that takes most energy gets ahead of the others. With less, they grow together, and several stay.
constexpr double giving_hold = 1;
constexpr double often_far = 0.7;   // of the way that a step may move: what goes by its hold is not let go farther
constexpr int static_patience = 4;  // steps that bring equilibrium no nearer, of bonds that soften
constexpr int steps_a_level = 3;    // with one share of the slopes, before a larger one is tried
constexpr int equilibrium_iterations = 200;
// What lies smooth between plates drifts on as they tilt by rounding and compliance: where the residual falls no more
// it will do up to ten times what is asked for.
constexpr int drifting = 30;              // solves without a fall by a hundredth
constexpr double drifting_residual = 10;  // of static_tolerance
// What is all but held creeps on to where more holds it, by what the hold lets it go in a solve: where the residual
// does not fall that becomes more.
constexpr int creeping = 10;          // solves
constexpr double least_creep = 1e-4;  // part of least_hold
constexpr int whole_way_among_cracks = 15;
// Solves in a row that are not taken because they went past contacts, each held four times harder than the one before.
constexpr int most_past = 6;
constexpr double deepest_past = 1e-3;  // of √area: as near as corners that a mesh was drawn with
constexpr double past_hold = 16;       // as it is let go four times farther each time

constexpr double release_hold = 0.1;
constexpr int release_iterations = 40;
// Solves with friction from the start, where sticking joints alternate: enough for arches of 100 voussoirs, and no more
// than those took.
constexpr int most_balance_solves = 60;
constexpr double sliding_hold = 1e-3;  // part of (wave speed / size of a block)²
// Of its acceleration that is a load. The rest moves it on, by about ten times what its strains change, so that
// friction has its direction everywhere.
constexpr double sliding_lead = 0.999;

// How the falling branches of bonds that soften are taken. With their whole slope, Newton's step, as long as the matrix
// is positive definite; else, near the load that they bear and where they give way under it, with a share of it.
// Without any, tractions stay in a step as they are at its start: what opens sheds in the next what it has lost in this
// one, so that each step lowers the energy, however far the blocks are from being able to follow.
struct Softening {
  static constexpr std::array shares = {1.0, 0.95, 0.8, 0.0};
  static constexpr int least_level = int(shares.size()) - 1;
  int level = 0, taken = 0;  // steps at this level
  int stalled = 0;
  double best = 1;     // residual
  bool wears = false;  // at once, so that nothing goes back and forth

  double share() const { return shares[size_t(level)]; }
  bool less() {
    if (level == least_level) return false;
    ++level;
    taken = 0;
    return true;
  }
  // After a step, which began at this residual.
  void watch(double residual) {
    stalled = residual > 0.9 * best ? stalled + 1 : 0;
    best = std::min(best, residual);
    if (level > 0) {
      if (++taken < steps_a_level) return;
      --level;
      taken = stalled = 0;
      best = residual;
    } else if (stalled > static_patience) {
      level = least_level;
      taken = -static_patience;
      wears = true;
    }
  }
};

// How the residual of a search falls.
struct Descent {
  double least = std::numeric_limits<double>::infinity();
  int since_fall = 0;  // solves

  void watch(double residual) {
    since_fall = residual < 0.99 * least ? 0 : since_fall + 1;
    least = std::min(least, residual);
  }
  bool creeps() const { return since_fall > 0 && since_fall % creeping == 0; }
  double slack() const { return since_fall < drifting ? 1 : drifting_residual; }  // of what is asked for
};

void end_sliding(Model& model) {
  for (Contact& contact : model.contacts) contact.end_sliding();
}

// What is long and low is slower than its height says, which holds are measured by.
double slower_by_width(const Model& model) {
  constexpr double wide = 3;  // times as wide as high: as slow as that
  Vec2 sum = Vec2::Zero();
  int moving = 0;
  const auto each_moving = [&model](auto visit) {
    for (const BlockShape& shape : model.shapes)
      if (shape.dofs > 0) visit(shape);
  };
  each_moving([&](const BlockShape& shape) { sum += shape.reference_centroid, ++moving; });
  double far = 0;
  each_moving([&](const BlockShape& shape) {
    far = std::max(far, (shape.reference_centroid - sum / moving).norm() + shape.radius);
  });
  return far > wide * model.extent ? std::pow(wide * model.extent / far, 2) : 1;
}

// Whether all blocks hang together by bonds and nothing has cracked: then nothing touches.
bool in_one_piece(const Model& model) {
  const auto failed = [](const Joint& joint) { return joint.state == JointState::failed; };
  return *std::max_element(model.fragment.begin(), model.fragment.end()) == 0 &&
         std::none_of(model.joints.begin(), model.joints.end(), failed);
}

}  // namespace

Equilibrium::Equilibrium(StepParts& parts)
    : parts_(parts), model_(parts.model), plan_(parts.plan), totals_(parts.totals) {}

std::string Equilibrium::settle() {
  EquilibriumSearch stuck, released;
  const auto settles = [&](bool stick, double hold, int iterations, EquilibriumSearch& search) {
    Restored attempt(model_);
    search.in_place = true;
    const bool found = find(stick, hold, iterations, search);
    if (found) attempt.keep();
    return found;
  };
  bool slid = false;
  if (!settles(true, 0, equilibrium_iterations, stuck)) {
    if (stuck.last.singular_block >= 0)
      return "no settled start: " + unheld(stuck.last.singular_block) + "; the run starts at rest as given";
    slid = plan_.contacts && stuck.left < 0 && balances_in_place();
    if (!slid)
      return "no settled start: even with joints that do not slide, " + block_name(model_, culprit(stuck)) +
             (stuck.left >= 0 ? " topples or falls" : " keeps moving") + "; the run starts at rest as given";
  }
  // Sticking contacts may carry more shear than friction allows. Where the scene stands with friction too, it
  // starts from there, or the first steps would shake it.
  if (plan_.contacts && !slid && !settles(false, release_hold, release_iterations, released)) start_sliding();
  end_sliding(model_);
  for (Contact& contact : model_.contacts) contact.slip = 0;
  keep_viscous_tractions(model_);
  if (parts_.fracture) parts_.fracture->weaken();
  return {};
}

// As a static run finds it, with friction from the start: an arch may have contacts that come and go as long as they
// all stick.
bool Equilibrium::balances_in_place() {
  Restored attempt(model_);
  EquilibriumSearch search;
  search.in_place = true;
  search.most_solves = most_balance_solves;
  const bool found = balance(search);
  if (found) attempt.keep();
  return found;
}

// What friction does not hold is strained, as it begins to slide, by what is left of it and by its own inertia: let go
// from the strains with which it stuck, it would shake for ever. The forces that a little inertia lets it follow give
// its acceleration, and one more solve from the same place, with that as a load, its strains.
void Equilibrium::start_sliding() {
  Vector lead;
  for (const bool last : {false, true}) {
    Restored attempt(model_);
    for (size_t b = 0; b < model_.shapes.size(); ++b)
      hold_[b] = sliding_hold * std::pow(model_.extent / model_.shapes[b].length, 2);
    hold_lead_ = lead;
    parts_.search.update(model_, 0);
    assemble(false, false);
    hold_lead_.resize(0);
    Vector d;
    if (!solve(d).converged) return;
    if (last) {
      std::vector<BlockState> moved = moved_blocks(model_, Scheme::equilibrium(), d);
      keep_rest(moved);
      accept(moved, d);
      attempt.keep();
    }
    lead = sliding_lead * d;
    for (const BlockShape& shape : model_.shapes)
      if (shape.dofs > 3) lead.segment(shape.dof_begin + 3, shape.dofs - 3).setZero();
  }
}

// With friction by the whole way; where that is not found, as among new cracks, by the way of each solve, whose
// friction gives in.
bool Equilibrium::balance(EquilibriumSearch& search) {
  if (plan_.contacts) {
    Restored attempt(model_);
    EquilibriumSearch whole;
    whole.most_solves = search.most_solves;
    whole.may_jump = search.may_jump;
    whole.in_place = search.in_place;
    whole.whole_way = true;
    const bool found = find(false, 0, parts_.fracture ? whole_way_among_cracks : equilibrium_iterations, whole);
    if (found) attempt.keep();
    const bool must_not_jump = whole.jumped && !whole.may_jump;
    if (found || whole.last.singular_block >= 0 || whole.left >= 0 || must_not_jump) {
      search = std::move(whole);
      return found;
    }
    search.jumped = whole.jumped;
    search.report.iterations = whole.report.iterations;
  }
  return find(false, 0, equilibrium_iterations, search);
}

bool Equilibrium::find(bool stick, double hold, int iterations, EquilibriumSearch& search) {
  StepReport& report = search.report;
  OpenCloseResult& result = search.last;
  Vector& d = search.d;
  bool limited = plan_.contacts && !in_one_piece(model_);
  double least = limited ? least_hold * slower_by_width(model_) : 0;
  const double enough = model_.scene.numerics.static_tolerance;
  const bool loaded = plan_.gravity || plan_.loads;  // else nothing leads what creeps to where more holds it
  // What nothing touches goes as far as Newton's method takes it, and where that makes it touch something begins again
  // by short ways.
  std::optional<Restored> freely;
  if (plan_.contacts && !limited) freely.emplace(model_);
  std::optional<Settlement> settlement;
  if (search.in_place && plan_.contacts) settlement.emplace(model_);
  const BridgeSearch bridged(bridges_);
  const std::vector<BlockState> start = search.whole_way ? model_.blocks : std::vector<BlockState>{};
  begin();
  hold_.assign(model_.shapes.size(), std::max(hold, least));
  Softening softening;
  Descent descent;
  int past = 0;
  std::vector<Contact> contacts;  // before the search, which keeps as an offset what it finds deep
  for (int i = 0; i < iterations && report.iterations < search.most_solves; ++i) {
    if (search.jumped && !search.may_jump) return false;
    if (plan_.contacts) {
      StepTimer timer(totals_, "contact search");
      if (limited) contacts = model_.contacts;
      parts_.search.update(model_, 0);
      if (freely && !model_.contacts.empty()) {
        freely.reset();
        limited = true;
        continue;
      }
      if (search.whole_way) slid_so_far(model_, start);
    }
    bridges_.take(softening.share());
    assemble(stick, search.whole_way);
    result = parts_.islands.judge(model_, parts_.system, parts_.contacts, i > 0 ? enough : -1);
    report.residual = result.residual;
    descent.watch(result.residual);
    if (loaded && descent.creeps()) least = std::min(least, std::max(least / 4, least_creep * least_hold));
    if (i > 0 && result.residual <= descent.slack() * enough) {
      if (freely) freely->keep();
      end_sliding(model_);
      return true;
    }
    d.resize(0);
    result = solve(d);
    report.iterations += result.iterations;
    if (result.singular_block >= 0 && bridges_.any() && softening.less()) {
      give_way(search);
      continue;
    }
    if (!result.converged && (!plan_.contacts || result.singular_block >= 0)) return false;
    std::vector<BlockState> moved = moved_blocks(model_, Scheme::equilibrium(), d);
    const double displacement = hold_and_leave(stick, moved, least, limited);
    if (displacement < 0) continue;
    if (bridges_.any()) softening.watch(report.residual);
    search.jumped |= softening.wears;
    report.displacement = std::max(report.displacement, displacement);
    keep_rest(moved);
    if (limited && goes_past(moved, d, displacement, past)) {
      model_.contacts = contacts;
      continue;
    }
    accept(moved, d);
    if (!search.whole_way) end_sliding(model_);
    if (settlement) search.left = settlement->left(model_);
    if (search.left >= 0) return false;
    search.alternation.note(model_);
    bridges_.watch(model_);
    if (softening.wears)
      for (Joint& joint : model_.joints) wear_bridges(model_, joint);
  }
  return false;
}

void Equilibrium::begin() {
  for (BlockState& state : model_.blocks) std::ranges::fill(state.velocity, 0);
  for (Contact& contact : model_.contacts) contact.coheres = false;
  if (plan_.held_blocks) place_held_blocks(model_);
}

// Bonds that soften no longer hold it: on through states that are not stable, held so that cracks go one by one.
void Equilibrium::give_way(EquilibriumSearch& search) {
  search.last.singular_block = -1;
  search.jumped = true;
  for (double& held : hold_) held = std::max(held, giving_hold);
}

// `whole_way`: faces that have been pressed in the search cohere until it ends. A cohesion that came and went with the
// force that depends on it would have it go to and fro; other searches do, and may lead far from where faces were
// pressed.
void Equilibrium::assemble(bool stick, bool whole_way) {
  const Scheme scheme = Scheme::equilibrium();
  parts_.assemble(scheme, {.stick = stick});
  if (whole_way)
    for (const ContactRows& row : parts_.contacts.rows())
      model_.contacts[size_t(row.contact)].coheres = row.cohesion > 0;
  add_hold(model_, hold_, hold_lead_, parts_.system);
  if (!parts_.fracture) return;
  bridges_.find_slots(model_, parts_.system.matrix);
  bridges_.add(model_, parts_.poses, scheme, parts_.system);
}

IslandResult Equilibrium::solve(Vector& d) {
  if (parts_.on_equilibrium_solve) parts_.on_equilibrium_solve();
  return parts_.solve(0, std::numeric_limits<double>::infinity(), d);
}

// What rests stays where it is.
void Equilibrium::keep_rest(std::vector<BlockState>& moved) {
  for (const int b : model_.awake_blocks())
    if (parts_.islands.rest(b) != Rest::moves) moved[b] = model_.blocks[b];
}

void Equilibrium::accept(std::vector<BlockState>& moved, const Vector& d) {
  StepTimer timer(totals_, "update");
  model_.blocks.swap(moved);
  model_.place_vertices();
  if (plan_.contacts) parts_.islands.store(model_, parts_.contacts, d, false);
  if (plan_.bonds) parts_.joints.store_tractions(model_);
  if (parts_.fracture) bridges_.store_tractions(model_);
}

// Islands that were not solved, or went too far, stay where they are and are held harder next time, the others less,
// down to `least`. Returns the largest displacement of those, or -1 where there are none.
double Equilibrium::hold_and_leave(bool stick, const std::vector<BlockState>& moved, double least, bool limited) {
  const double too_far = 2 * model_.scene.time.displacement_ratio * model_.extent;
  const Islands& islands = parts_.islands.islands();
  double largest = -1;
  for (int island = 0; island < islands.count(); ++island) {
    const int first = islands.first(island);
    if (first < 0 || parts_.islands.rest(first) != Rest::moves) continue;
    double own = 0;
    for (const int b : islands.blocks(island)) own = std::max(own, displacement(model_, b, moved[b]));
    double harder = 0;
    if (!parts_.islands.converged(island))
      harder = stick ? 100 : 30;
    else if (limited && own > too_far)
      harder = std::max(4.0, own / too_far);
    const double softer = own > 0 ? std::clamp(often_far * too_far / own, 1.0, 4.0) : 4;
    for (const int b : islands.blocks(island))
      hold_[b] = harder > 0 ? std::max(hold_[b], least_hold) * harder : std::max(least, hold_[b] / softer);
    if (harder > 0) {
      parts_.islands.leave(island);
      ++totals_.cuts;
    } else {
      largest = std::max(largest, own);
    }
  }
  return largest;
}

// Whether it went past contacts, for the `times`th solve in a row, and is not to be taken: the next is held harder.
bool Equilibrium::goes_past(const std::vector<BlockState>& moved, const Vector& d, double displacement, int& times) {
  if (times == most_past ||
      !overlooked(model_, parts_.search, parts_.contacts, d, moved, 0, displacement, deepest_past, deepest_past)) {
    times = 0;
    return false;
  }
  ++times;
  for (double& held : hold_) held = past_hold * std::max(held, least_hold);
  parts_.search.forget_last();
  ++totals_.cuts;
  return true;
}

bool Equilibrium::supported(int block) const {
  return fragments(model_)[size_t(model_.fragment[size_t(block)])].held;
}

std::string Equilibrium::unheld(int block) const {
  return supported(block) ? "its supports let " + block_name(model_, block) + " turn or slide freely"
                          : "nothing holds " + block_name(model_, block);
}

void Equilibrium::give_up(const EquilibriumSearch& search) const {
  if (search.last.singular_block >= 0)
    throw RunError(unheld(search.last.singular_block) + ": fix it, put it on something, or run the scene as dynamic");
  const bool loose = !plan_.held_blocks && !plan_.fixities && !plan_.viscous;
  const std::string held = loose ? ". Nothing in the scene is held: give its base held = true, or a talus.fix" : "";
  if (search.left >= 0)
    throw RunError("no equilibrium at " + load_text(model_) + ": on the way to one " + block_name(model_, search.left) +
                   " topples or falls: hold it, or run the scene as dynamic" + held);
  const std::string alternating = search.alternation.text(model_);
  const int block = culprit(search);
  throw RunError("no equilibrium at " + load_text(model_) + ": " + block_name(model_, block) + " keeps moving. " +
                 (!alternating.empty() ? "In " + std::to_string(search.report.iterations) + " solves " + alternating
                                       : std::string(supported(block) ? "Its supports let it turn or slide"
                                                                      : "Nothing holds it, or it slides") +
                                             ": fix it, raise the friction, or run the scene as dynamic") +
                 held);
}

int Equilibrium::culprit(const EquilibriumSearch& search) const {
  if (search.left >= 0) return search.left;
  if (!search.last.converged) return std::max(search.last.worst_block, 0);
  int fastest = 0;
  double most = -1;
  for (size_t b = 0; b < model_.shapes.size(); ++b) {
    const BlockShape& shape = model_.shapes[b];
    if (shape.dofs == 0) continue;
    const double moved = search.d.segment(shape.dof_begin, shape.dofs).norm();
    if (moved > most) {
      most = moved;
      fastest = int(b);
    }
  }
  return fastest;
}

}  // namespace talus
