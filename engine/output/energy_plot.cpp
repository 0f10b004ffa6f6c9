#include "output/energy_plot.h"

#include <algorithm>
#include <cmath>

#include "output/plot.h"
#include "step/energy_terms.h"

namespace talus {

namespace {

constexpr size_t most_samples = 256;  // one every 3 px of the picture

// A line that stays below this part of the largest, its own thickness, lies on the axis; what is unexplained is
// drawn even so.
constexpr double visible = 5e-3;

}  // namespace

void EnergyRecord::add(const Simulation& simulation) {
  times_.push_back(simulation.model.time);
  samples_.push_back(simulation.energies());
  step_ = simulation.totals.steps;
}

void EnergyRecord::after_step(const Simulation& simulation) {
  if (simulation.totals.steps % stride_ != 0 || step_ == simulation.totals.steps) return;
  add(simulation);
  if (samples_.size() < most_samples) return;
  for (size_t k = 0; 2 * k < samples_.size(); ++k) {
    times_[k] = times_[2 * k];
    samples_[k] = samples_[2 * k];
  }
  times_.resize((times_.size() + 1) / 2);
  samples_.resize(times_.size());
  stride_ *= 2;
}

void EnergyRecord::last(const Simulation& simulation) {
  if (step_ != simulation.totals.steps) add(simulation);
}

void EnergyRecord::visit_state(StateVisitor& visitor) {
  visitor.growing("times", times_);
  visitor.growing("samples", samples_);
  visitor("stride", stride_);
  visitor("step", step_);
}

std::string EnergyRecord::draw(const Plan& plan) const {
  Plot plot = {
      .title = "Energy (full: stored; dashed: put in, lost, unexplained)", .y_label = "E", .y_unit = "J/m"};
  std::vector<Series> all;
  double largest = 0;
  for (const EnergyTerm* term : energy_terms(plan)) {
    const bool stored = term->kind == EnergyTerm::stored || term->kind == EnergyTerm::sum;
    Series series = {.name = term->label, .x = times_, .dashed = !stored};
    for (const Energies& e : samples_) {
      series.y.push_back(e.*term->value);
      largest = std::max(largest, std::abs(series.y.back()));
    }
    all.push_back(series);
  }
  for (size_t k = 0; k < all.size(); ++k) {
    const double most = std::abs(*std::max_element(all[k].y.begin(), all[k].y.end(),
                                                   [](double a, double b) { return std::abs(a) < std::abs(b); }));
    if (most > visible * largest || energy_terms(plan)[k]->kind == EnergyTerm::rest) plot.series.push_back(all[k]);
  }
  return draw_plot(plot);
}

}  // namespace talus
