#include "output/curves.h"

#include <algorithm>
#include <cmath>

#include "gas/gas.h"
#include "output/energy_plot.h"
#include "output/output.h"
#include "output/plot.h"
#include "step/step_parts.h"

namespace talus {

namespace {

constexpr size_t support_columns = 4;  // displacement and reaction, each x and y

// Pressure and volume of the chamber that holds each charge's gas.
std::vector<double> gas_row(const Simulation& simulation) {
  std::vector<double> row;
  for (size_t wall = 0; wall < simulation.model.hole_walls.size(); ++wall) {
    const Chamber& chamber = simulation.gas()->chambers()[simulation.gas()->chamber_of(int(wall))];
    row.push_back(chamber.pressure);
    row.push_back(chamber.state == Chamber::State::waiting ? NAN : chamber.volume);  // no line before it goes off
  }
  return row;
}

// Whether the gas has all gone and the picture has seen it: what comes after is flat, and a hundred times as long.
bool gas_is_over(const Simulation& simulation, const Record& record) {
  const auto& chambers = simulation.gas()->chambers();
  const auto is_over = [](const Chamber& chamber) {
    return chamber.state == Chamber::State::merged ||
           (chamber.state == Chamber::State::vented && chamber.pressure == 0);
  };
  if (record.size() == 0 || !std::all_of(chambers.begin(), chambers.end(), is_over)) return false;
  for (size_t wall = 0; wall < simulation.model.hole_walls.size(); ++wall)
    if (record.column(2 * wall).back() != 0) return false;
  return true;
}

std::string draw_gas(const Record& record, const Model& model, bool volume) {
  Plot plot = {.title = volume ? "Volume of the gas" : "Pressure of the gas",
               .y_label = volume ? "V" : "P",
               .y_unit = volume ? "m3/m" : "Pa"};
  for (size_t wall = 0; wall < model.hole_walls.size(); ++wall)
    plot.series.push_back({.name = model.scene.charges[model.hole_walls[wall].charge].name,
                           .x = record.times(),
                           .y = record.column(2 * wall + volume)});
  return draw_plot(plot);
}

std::vector<double> support_row(const std::vector<MovingSupport>& supports) {
  std::vector<double> row;
  for (const MovingSupport& support : supports)
    for (const Vec2& pair : {support.shift, support.reaction}) row.insert(row.end(), {pair.x(), pair.y()});
  return row;
}

// Mean displacement of what each entry of Scene::fixities holds.
std::vector<Vec2> fixity_shifts(const Model& model) {
  std::vector<Vec2> sum(model.scene.fixities.size(), Vec2::Zero());
  std::vector<int> count(sum.size(), 0);
  const auto add = [&](int fixity, const Vec2& shift) {
    sum[fixity] += shift;
    ++count[fixity];
  };
  const auto shift_of = [&](int block, const Vec2& in_block) -> Vec2 {
    return model.place(block, in_block) - model.reference_place(block, in_block);
  };
  for (size_t b = 0; b < model.held_by.size(); ++b)
    if (model.held_by[b] >= 0) add(model.held_by[b], model.blocks[b].shift);
  for (const PointFixity& point : model.point_fixities) add(point.fixity, shift_of(point.block, point.in_block));
  for (const EdgeFixity& edge : model.edge_fixities)
    add(edge.fixity, shift_of(edge.block, (edge.in_block[0] + edge.in_block[1]) / 2));
  for (size_t f = 0; f < sum.size(); ++f)
    if (count[f] > 0) sum[f] /= count[f];
  return sum;
}

double largest_of(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace

std::vector<std::string> moving_names(const Model& model, const Plan& plan) {
  std::vector<std::string> names;
  if (!plan.moving_supports) return names;
  for (const Fixity& fixity : model.scene.fixities)
    if (fixity.motion != Fixity::none && std::find(names.begin(), names.end(), fixity.name) == names.end())
      names.push_back(fixity.name);
  return names;
}

std::vector<MovingSupport> moving_supports(Simulation& simulation, const std::vector<std::string>& names) {
  std::vector<MovingSupport> supports;
  if (names.empty()) return supports;
  const Model& model = simulation.model;
  const std::vector<Vec2> reactions = simulation.step_parts().reactions(), shifts = fixity_shifts(model);
  for (const std::string& name : names) {
    supports.push_back({name});
    int entries = 0;
    for (size_t f = 0; f < reactions.size(); ++f) {
      if (model.scene.fixities[f].name != name) continue;
      supports.back().reaction += reactions[f];
      supports.back().shift += shifts[f];
      ++entries;
    }
    supports.back().shift /= entries;
  }
  return supports;
}

template <class Add>
void Curves::each(Simulation& simulation, Add add) {
  add(energies_, [&] { return energy_row(simulation); });
  if (simulation.plan.gas && !gas_is_over(simulation, gas_)) add(gas_, [&] { return gas_row(simulation); });
  if (!moving_.empty()) add(supports_, [&] { return support_row(moving_supports(simulation, moving_)); });
}

void Curves::begin(const Simulation& simulation) {
  moving_ = moving_names(simulation.model, simulation.plan);
}

void Curves::after_step(Simulation& simulation) {
  each(simulation, [&](Record& record, const Record::Row& row) {
    record.after_step(simulation.totals.steps, simulation.model.time, row);
  });
}

void Curves::write(Simulation& simulation, const std::string& dir) {
  each(simulation, [&](Record& record, const Record::Row& row) {
    record.last(simulation.totals.steps, simulation.model.time, row);
  });
  write_whole(dir + "/energy.svg", draw_energies(energies_, simulation.plan));
  if (simulation.plan.gas)
    for (const bool volume : {false, true})
      write_whole(dir + (volume ? "/gas_volume.svg" : "/gas_pressure.svg"), draw_gas(gas_, simulation.model, volume));
  if (!moving_.empty())
    write_whole(dir + "/load_displacement.svg",
                draw_load_displacement(supports_, moving_supports(simulation, moving_)));
}

void Curves::visit_state(StateVisitor& visitor) {
  visitor("energies", energies_);
  visitor("gas", gas_);
  visitor("supports", supports_);
}

std::string draw_load_displacement(const Record& supports, const std::vector<MovingSupport>& now) {
  Plot plot = {.title = "Load against displacement", .x_label = "u", .x_unit = "m", .y_label = "R", .y_unit = "N/m"};
  for (size_t s = 0; s < now.size(); ++s) {
    const double most = std::max(largest_of(supports.column(support_columns * s)),
                                 largest_of(supports.column(support_columns * s + 1)));
    for (const size_t axis : {0, 1}) {
      Series series = {.name = now[s].name + (axis == 0 ? ".x" : ".y"),
                       .x = supports.column(support_columns * s + axis),
                       .y = supports.column(support_columns * s + 2 + axis)};
      if (!(largest_of(series.x) > 1e-6 * most)) continue;  // along this axis it stays
      const double sense = now[s].shift[long(axis)] < 0 ? -1 : 1;
      for (auto* values : {&series.x, &series.y})
        for (double& value : *values) value *= sense;
      plot.series.push_back(series);
    }
  }
  return draw_plot(plot);
}

}  // namespace talus
