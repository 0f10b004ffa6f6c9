#include "step/half_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "equations/block_terms.h"
#include "model/registry.h"
#include "model/saved_state.h"

namespace talus {

namespace {

constexpr double safety = 0.8, least_change = 0.2, most_change = 1.5;  // of the next step
constexpr double most_again = 0.9;                                     // of a step that is taken again
constexpr double early_share = 0.2;
// of the run, the least step that error asks for: what jumps in no step is smooth in
constexpr double least_part = 1e-5;

// J/m, of the motion by which `other` differs from the model's: an energy, so that all unknowns count as their mass
// does.
double kinetic_difference(const Model& model, const std::vector<BlockState>& other) {
  double sum = 0;
  for (int b = 0; b < int(model.blocks.size()); ++b) {
    const BlockShape& shape = model.shapes[b];
    if (shape.dofs == 0) continue;
    with_size(shape.second_order(), [&](auto n) {
      const ColumnOf<n> rates = model.blocks[b].velocity.column<n>() - other[b].velocity.column<n>();
      sum += rates.dot(mass_matrix_of<n>(model, b) * rates) / 2;
    });
  }
  return sum;
}

// What a step was like in the totals, where one that is taken again in halves counts once.
struct Kinds {
  long at_rest, by_sweeps;
  IslandCounts islands;

  explicit Kinds(const RunTotals& totals)
      : at_rest(totals.steps_at_rest), by_sweeps(totals.steps_by_sweeps), islands(totals.islands) {}
  void put_into(RunTotals& totals) const {
    totals.steps_at_rest = at_rest;
    totals.steps_by_sweeps = by_sweeps;
    totals.islands = islands;
  }
};

double kinetic(const Model& model) {
  return kinetic_difference(model, std::vector<BlockState>(model.blocks.size()));
}

}  // namespace

HalfSteps::HalfSteps(StepParts& parts, Stepper& stepper)
    : parts_(parts),
      model_(parts.model),
      stepper_(stepper),
      totals_(parts.totals),
      ledger_(parts.ledger),
      dt_(std::numeric_limits<double>::infinity()) {
  const Scene& scene = model_.scene;
  tolerance_ = scene.time.tolerance;
  t_end_ = scene.time.t_end;
  least_ = scene.time.dt_min > 0 ? 2 * scene.time.dt_min : least_part * t_end_;
  // Contacts press at the end of a step: first order.
  const bool midpoint = scene.numerics.integrator == Integrator::theta && scene.numerics.theta == 0.5;
  order_ = midpoint && !parts.plan.contacts ? 2 : 1;
}

StepReport HalfSteps::step() {
  const std::string before = state();
  const double start = model_.time;
  const Kinds so_far(totals_);
  fastest_ = std::max(fastest_, kinetic(model_));
  for (int again = 0;; ++again) {
    double dt = 0, end = 0;
    std::vector<BlockState> whole;
    std::optional<StepSize> grown;
    StepReport report;
    try {
      dt = whole_step().dt;
      end = model_.time;
      whole = model_.blocks;
      grown = stepper_.step_size();
      const Kinds with_it(totals_);
      put_back(before);
      report = halves(dt, end);
      with_it.put_into(totals_);
    } catch (...) {
      put_back(before);
      throw;
    }
    report.error = error_of(whole);
    const double allowed = allowed_error(dt, end);
    const double change = report.error > 0 ? std::pow(safety * allowed / report.error, 1.0 / order_) : most_change;
    if (report.error <= allowed || dt <= least_) {
      if (report.error > allowed) ++totals_.inaccurate;
      if (report.cuts == 0) stepper_.step_size() = *grown;  // halves, of a length given to them, do not let it grow
      const double next = std::max(dt * std::clamp(change, least_change, most_change), least_);
      // a step cut short for another reason says less
      dt_ = dt < dt_ && change > 1 && std::isfinite(dt_) ? std::max(dt_, next) : next;
      report.cuts += again;
      report.dt = model_.time - start;
      return report;
    }
    dt_ = std::max(dt * std::clamp(change, least_change, most_again), least_);
    put_back(before);
    so_far.put_into(totals_);
    ++totals_.cuts;
  }
}

// Each second may add its share to the whole run's error. What has just begun to move is slow beside what is to come:
// so that its error may be larger beside it, by a share of the time since the start.
double HalfSteps::allowed_error(double dt, double end) const {
  return tolerance_ * dt * std::max(1 / t_end_, early_share / end);
}

StepReport HalfSteps::whole_step() {
  return stepper_.dynamic_step(dt_);
}

// From the start of a step of `dt` to its end, in two, or in more where one of them is cut.
StepReport HalfSteps::halves(double dt, double end) {
  StepReport sum;
  fractures_.clear();
  gas_events_.clear();
  take_half(dt / 2, sum);
  // What a half that was cut has left is shared between two, so that none is a sliver.
  for (double rest = end - model_.time; rest > 1e-9 * dt; rest = end - model_.time)
    take_half(rest > dt / 2 * (1 + 1e-9) ? std::min(dt / 2, rest / 2) : rest, sum);
  model_.time = end;  // to the last bit: output waits for it
  return sum;
}

void HalfSteps::take_half(double dt, StepReport& sum) {
  const StepReport half = stepper_.dynamic_step(dt);
  sum.iterations += half.iterations;
  sum.cuts += half.cuts;
  sum.residual = std::max(sum.residual, half.residual);
  sum.displacement += half.displacement;
  sum.failures += half.failures;
  sum.utilisation = std::max(sum.utilisation, half.utilisation);
  fractures_.insert(fractures_.end(), parts_.fractures().begin(), parts_.fractures().end());
  if (!parts_.gas) return;
  const auto& events = parts_.gas->events();
  gas_events_.insert(gas_events_.end(), events.begin(), events.end());
}

// Of the halves: the root of the kinetic energy of the difference over the most there has been. A step's error goes
// with Δt^(order + 1), so that two halves have 2^-order of a whole one's, and 1/(2^order - 1) of the difference.
double HalfSteps::error_of(const std::vector<BlockState>& whole) {
  fastest_ = std::max(fastest_, kinetic(model_));
  const double difference = kinetic_difference(model_, whole);
  return fastest_ > 0 ? std::sqrt(difference / fastest_) / (std::pow(2, order_) - 1) : 0;
}

std::string HalfSteps::state() {
  StateWriter writer;
  talus::visit_state(model_, writer);
  writer("stepper", stepper_);
  writer("ledger", ledger_);
  return std::move(writer.bytes);
}

void HalfSteps::put_back(const std::string& state) {
  StateReader reader(state);
  talus::visit_state(model_, reader);
  reader("stepper", stepper_);
  reader("ledger", ledger_);
  model_.place_vertices();
  stepper_.rewound();
}

void HalfSteps::visit_state(StateVisitor& visitor) {
  visitor("dt", dt_);
  visitor("fastest", fastest_);
}

}  // namespace talus
