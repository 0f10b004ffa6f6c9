#include "output/energy_plot.h"

#include <algorithm>
#include <cmath>

#include "output/plot.h"
#include "step/energy_terms.h"

namespace talus {

namespace {

// A line that stays below this part of the largest, its own thickness, lies on the axis; what is unexplained is
// drawn even so.
constexpr double visible = 5e-3;

double largest_size(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace

std::vector<double> energy_row(const Simulation& simulation) {
  const Energies energies = simulation.energies();
  std::vector<double> row;
  for (const EnergyTerm* term : energy_terms(simulation.plan)) row.push_back(energies.*term->value);
  return row;
}

std::string draw_energies(const Record& record, const Plan& plan) {
  Plot plot = {.title = "Energy (full: stored; dashed: put in, lost, unexplained)", .y_label = "E", .y_unit = "J/m"};
  const auto terms = energy_terms(plan);
  double largest = 0;
  for (size_t k = 0; k < terms.size(); ++k) largest = std::max(largest, largest_size(record.column(k)));
  for (size_t k = 0; k < terms.size(); ++k) {
    const bool stored = terms[k]->kind == EnergyTerm::stored || terms[k]->kind == EnergyTerm::sum;
    Series series = {.name = terms[k]->label, .x = record.times(), .y = record.column(k), .dashed = !stored};
    if (largest_size(series.y) > visible * largest || terms[k]->kind == EnergyTerm::rest) plot.series.push_back(series);
  }
  return draw_plot(plot);
}

}  // namespace talus
