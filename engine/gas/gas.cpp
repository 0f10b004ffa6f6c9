#include "gas/gas.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "gas/eos.h"
#include "gas/orifice.h"

namespace talus {

namespace {

// Part of the pressure by which that of a solve may differ from the law over the volume it leads to. The work of a step
// is off by no more; the volume, from which the next step goes on, is exact.
constexpr double close_enough = 1e-4;
constexpr int most_solves = 20, guesses = 20;  // a step; of a pressure that agrees with a linear answer of the rock
constexpr double little = 1e-9;                // part of the volume: less is swept at the present pressure

// Where a falling positive function comes to `value` between `low` and `high`, or the end beyond which it would.
template <typename Function>
double fallen_to(double value, double low, double high, const Function& function) {
  const auto above = [&](double x) {
    return std::log2(std::max(function(x), std::numeric_limits<double>::min())) - std::log2(value);
  };
  const double at_low = above(low), at_high = above(high);
  if (!(at_low > 0)) return low;
  if (!(at_high < 0)) return high;
  std::uintmax_t steps = 100;
  const auto ends = boost::math::tools::toms748_solve(above, low, high, at_low, at_high,
                                                      boost::math::tools::eps_tolerance<double>(), steps);
  return (ends.first + ends.second) / 2;
}

}  // namespace

void visit_state(Chamber& chamber, StateVisitor& v) {
  auto& [walls, charges, state, volume, pressure, began, vented_at, fronts, gain, yield, joined, work, opening] =
      chamber;
  v.growing("walls", walls);
  v.growing("fronts", fronts);
  v.growing("charges", charges);
  v("state", state);
  for (double* number : {&volume, &pressure, &began, &vented_at, &gain, &yield, &joined, &work, &opening})
    v("chamber", *number);
}

void visit_state(StemmingMotion& motion, StateVisitor& v) {
  auto& [way, speed] = motion;
  v("way", way);
  v("speed", speed);
}

Gas::Gas(Model& model)
    : model_(model),
      paths_(model),
      first_volume_(model.scene.charges.size(), 0.0),
      left_(model.scene.charges.size(), 1.0) {
  for (size_t w = 0; w < model.hole_walls.size(); ++w) {
    Chamber chamber;
    chamber.walls = {int(w)};
    chamber.fronts = {0};
    chambers_.push_back(chamber);
  }
  const auto& charges = model.scene.charges;
  if (std::any_of(charges.begin(), charges.end(), [](const Charge& charge) { return charge.stemming.has_value(); }))
    stemming_.resize(charges.size());
  reach_.resize(chambers_.size());
  guess_.resize(chambers_.size());
  model.gas_pressure.assign(chambers_.size(), 0.0);
}

double Gas::next_detonation() const {
  double next = std::numeric_limits<double>::infinity();
  for (size_t charge = 0; charge < first_volume_.size(); ++charge)
    if (first_volume_[charge] == 0) next = std::min(next, model_.scene.charges[charge].delay);
  return next;
}

int Gas::chamber_of(int wall) const {
  for (size_t c = 0; c < chambers_.size(); ++c) {
    const auto& walls = chambers_[c].walls;
    if (chambers_[c].state != Chamber::State::merged && std::find(walls.begin(), walls.end(), wall) != walls.end())
      return int(c);
  }
  return wall;
}

double Gas::front(int wall) const {
  const Chamber& chamber = chambers_[chamber_of(wall)];
  const auto at = std::find(chamber.walls.begin(), chamber.walls.end(), wall) - chamber.walls.begin();
  return std::max(model_.hole_walls[wall].radius, chamber.fronts[size_t(at)]);
}

void Gas::detonate(double soon) {
  if (events_told_) events_.clear();
  events_told_ = false;
  std::vector<int> due;  // walls
  for (size_t wall = 0; wall < model_.hole_walls.size(); ++wall) {
    const int charge = model_.hole_walls[wall].charge;
    if (first_volume_[charge] == 0 && model_.scene.charges[charge].delay <= model_.time + soon)
      due.push_back(int(wall));
  }
  if (!due.empty()) go_off(due);
  lay_faces();
}

// All of them, or none where a law of the script fails.
void Gas::go_off(const std::vector<int>& walls) {
  const auto before = std::tuple(first_volume_, chambers_, reach_);
  const size_t events = events_.size();
  try {
    for (const int wall : walls) go_off(wall);
  } catch (...) {
    std::tie(first_volume_, chambers_, reach_) = before;
    events_.resize(events);
    throw;
  }
}

void Gas::go_off(int wall) {
  const int charge = model_.hole_walls[wall].charge;
  Reach hole;
  hole.nodes = paths_.wall_nodes(wall);
  first_volume_[charge] = gas_volume(model_, model_.blocks, 0, paths_, {wall}, hole);
  if (Chamber& there = chambers_[chamber_of(wall)]; there.state == Chamber::State::vented) {
    if (!model_.scene.charges[there.charges[0]].orifice && vent_part(there, model_.time) == 0)
      set_apart(wall);
    else
      settle_venting(there);
  }
  const int c = chamber_of(wall);
  Chamber& chamber = chambers_[c];
  chamber.charges.push_back(charge);
  if (chamber.state == Chamber::State::waiting) {
    chamber.state = Chamber::State::pressing;
    chamber.began = model_.time;
    chamber.volume = first_volume_[charge];
    reach_[c] = hole;
  }
  if (chamber.state == Chamber::State::vented)  // its volume is not followed where its gas had ended
    spread(c);
  else
    chamber.pressure = law_pressure(chamber, chamber.volume, model_.time);
  events_.push_back({GasEventKind::detonation, wall, -1, model_.time, chamber.volume, chamber.pressure});
}

// A hole whose gas, that of another charge, has blown out: what goes off in it now begins anew, and blows out where it
// meets the others.
void Gas::set_apart(int wall) {
  Chamber& blown_out = chambers_[chamber_of(wall)];
  const auto at = std::find(blown_out.walls.begin(), blown_out.walls.end(), wall) - blown_out.walls.begin();
  blown_out.walls.erase(blown_out.walls.begin() + at);
  blown_out.fronts.erase(blown_out.fronts.begin() + at);
  Chamber& own = chambers_[wall] = {};
  own.walls = {wall};
  own.fronts = {0};
}

double Gas::wave_speed(int wall) const {
  double fastest = 0;
  for (const BlockEdge& edge : model_.hole_walls[wall].edges)
    if (model_.shapes[edge.block].dofs > rigid_dofs) {
      const Material& rock = model_.material(edge.block);
      fastest = std::max(fastest, std::sqrt(elasticity(rock)(0, 0) / rock.density));
    }
  return fastest;
}

// A hole rings with its circumference's wave: half of that time, of a disc of the chamber's size. Gas with less than a
// thousandth of its first pressure left pushes nothing any more.
double Gas::longest_step() const {
  constexpr double spent = 1e-3;
  double least = std::numeric_limits<double>::infinity();
  for (const Chamber& chamber : chambers_) {
    if (!presses(chamber)) continue;
    const int charge = chamber.charges[0];
    const GasMoment start{0, first_volume_[charge], first_volume_[charge], chamber.pressure, 0};
    if (chamber.pressure < spent * model_.scene.charges[charge].law.pressure(1, start)) continue;
    double speed = 0;
    for (const int wall : chamber.walls) speed = std::max(speed, wave_speed(wall));
    if (speed > 0) least = std::min(least, std::sqrt(std::numbers::pi * chamber.volume) / speed);
  }
  return least;
}

bool Gas::presses(const Chamber& chamber) const {
  return !chamber.charges.empty() && chamber.state != Chamber::State::merged && vent_part(chamber, model_.time) != 0;
}

void Gas::lay_faces() {
  model_.gas_faces.clear();
  for (size_t c = 0; c < chambers_.size(); ++c)
    if (presses(chambers_[c])) add_gas_faces(model_, int(c), chambers_[c].walls, reach_[c], model_.gas_faces);
}

GasMoment Gas::moment(const Chamber& chamber, double since) const {
  return {std::max(since, 0.0), chamber.volume, first_volume_[chamber.charges[0]], chamber.pressure, chamber.front()};
}

// An explosive's law goes by its mass, for its hole as it was drawn: blocks that lie in it and what has moved its walls
// until it goes off leave its gas another volume. Other laws go by V/V0, V0 the volume when it goes off.
double Gas::room(int charge) const {
  const double radius = model_.hole_walls[charge].radius;
  const double begins =
      model_.scene.charges[charge].mass > 0 ? std::numbers::pi * radius * radius : first_volume_[charge];
  return begins * left_[charge];
}

// What is left of a charge's gas has the pressure of all of it in as much more room: its isentrope goes by volume per
// mass.
double Gas::law_pressure(const Chamber& chamber, double volume, double time) const {
  if (chamber.charges.size() > 1) return mixture_pressure(chamber, volume, time);
  const int charge = chamber.charges[0];
  const Charge& own = model_.scene.charges[charge];
  return own.law.pressure(volume / room(charge), moment(chamber, time - own.delay));
}

// Gas of several charges has one pressure, at which their own volumes fill the chamber. Both are sought by logarithms,
// in which gases are near straight lines.
double Gas::mixture_pressure(const Chamber& chamber, double volume, double time) const {
  const auto filled = [&](double pressure) {
    double sum = 0;
    for (const int charge : chamber.charges) {
      const Charge& own = model_.scene.charges[charge];
      const GasMoment now = moment(chamber, time - own.delay);
      const double v = fallen_to(pressure, -7, 60, [&](double log) { return own.law.pressure(std::exp2(log), now); });
      sum += room(charge) * std::exp2(v);
    }
    return sum;
  };
  return std::exp2(fallen_to(volume, 0, 40, [&](double log) { return filled(std::exp2(log)); }));  // Pa
}

double Gas::law_work(const Chamber& chamber, double from, double to, double time) const {
  const int charge = chamber.charges[0];
  if (chamber.charges.size() > 1)
    return talus::work({[&](double volume, const GasMoment&) { return law_pressure(chamber, volume, time); }, {}, {}},
                       from, to);
  const double first = room(charge);
  const Charge& own = model_.scene.charges[charge];
  return first * talus::work(own.law, from / first, to / first, moment(chamber, time - own.delay));
}

// Part of its law's pressure that a chamber keeps; gas that has left through an orifice is missing in the law itself.
double Gas::vent_part(const Chamber& chamber, double time) const {
  if (chamber.state != Chamber::State::vented) return 1;
  const Charge& first = model_.scene.charges[chamber.charges[0]];
  if (first.orifice)
    return std::any_of(chamber.charges.begin(), chamber.charges.end(), [&](int charge) { return left_[charge] > 0; });
  return first.venting ? first.venting(moment(chamber, time - chamber.vented_at)) : 0;
}

// Gas that has vented by a law has left: what is left has by its own law the pressure that the chamber has.
void Gas::settle_venting(Chamber& chamber) {
  if (chamber.state != Chamber::State::vented || model_.scene.charges[chamber.charges[0]].orifice) return;
  const double part = vent_part(chamber, model_.time), pressure = law_pressure(chamber, chamber.volume, model_.time);
  const double wider = fallen_to(part * pressure, 0, 60, [&](double log) {
    return law_pressure(chamber, chamber.volume * std::exp2(log), model_.time);
  });
  for (const int charge : chamber.charges) left_[charge] *= std::exp2(-wider);
  chamber.vented_at = model_.time;
}

double Gas::mean_pressure(const Chamber& chamber, double volume) const {
  volume = std::max(volume, 0.5 * chamber.volume);  // a solve may try what no step comes to, and less than nothing
  const double middle = model_.time + dt_ / 2, swept = volume - chamber.volume, part = vent_part(chamber, middle);
  if (part == 0) return 0;
  if (std::abs(swept) < little * chamber.volume)
    return part * law_pressure(chamber, (volume + chamber.volume) / 2, middle);
  return part * law_work(chamber, chamber.volume, volume, middle) / swept;
}

void Gas::begin_step(double dt) {
  dt_ = dt;
  gives_up_ = false;
  for (size_t c = 0; c < chambers_.size(); ++c) {
    const Chamber& chamber = chambers_[c];
    Guess& guess = guess_[c];
    guess = {};
    model_.gas_pressure[c] = 0;
    if (!presses(chamber)) continue;
    guess.free = gas_volume(model_, model_.blocks, dt, paths_, chamber.walls, reach_[c]);
    guess.slope = chamber.gain * dt * dt;
    guess.offset = guess.free + chamber.yield * dt * dt;
    guess.pressure = chamber.pressure;
    for (int k = 0; k < guesses; ++k)
      guess.pressure = mean_pressure(chamber, guess.offset + guess.slope * guess.pressure);
    model_.gas_pressure[c] = guess.pressure;
  }
}

bool Gas::agrees(const std::vector<BlockState>& moved) {
  bool all = true;
  for (size_t c = 0; c < chambers_.size(); ++c) {
    const Chamber& chamber = chambers_[c];
    Guess& guess = guess_[c];
    if (guess.pressure == 0 || chamber.state == Chamber::State::merged) continue;
    const double volume = gas_volume(model_, moved, 0, paths_, chamber.walls, reach_[c]);
    if (guess.solves > 0 && guess.pressure != model_.gas_pressure[c]) {
      // Two solves give the slope.
      const double slope = (volume - guess.volume) / (model_.gas_pressure[c] - guess.pressure);
      if (slope > 0) guess.slope = slope;
    }
    guess.pressure = model_.gas_pressure[c];
    guess.volume = volume;
    guess.swept = swept_by_faces(model_, int(c), moved);
    guess.offset = volume - guess.slope * guess.pressure;
    ++guess.solves;
    const double wanted = mean_pressure(chamber, volume);
    if (std::abs(wanted - guess.pressure) <= close_enough * std::abs(wanted)) {
      guess.solves = 1;  // should bonds or contacts ask for the step again
      continue;
    }
    gives_up_ = gives_up_ || guess.solves >= most_solves;
    all = false;
    double better = wanted;
    for (int k = 0; k < guesses; ++k) better = mean_pressure(chamber, guess.offset + guess.slope * better);
    model_.gas_pressure[c] = better;
  }
  return all;
}

void Gas::end_step(double dt) {
  for (size_t c = 0; c < chambers_.size(); ++c) {
    Chamber& chamber = chambers_[c];
    const Guess& guess = guess_[c];
    if (chamber.state == Chamber::State::merged) continue;
    if (guess.pressure == 0) {
      chamber.pressure = 0;
      continue;
    }
    if (!stemming_.empty()) push_stemming(int(c), dt);
    const double before = chamber.volume;
    const GasMoment middle = moment(chamber, model_.time - dt / 2 - model_.scene.charges[chamber.charges[0]].delay);
    chamber.work += guess.pressure * guess.swept;
    chamber.joined += guess.volume - chamber.volume - guess.swept;
    chamber.volume = guess.volume;
    chamber.gain = guess.slope / (dt * dt);
    chamber.yield = (guess.offset - guess.free) / (dt * dt);
    advance_fronts(chamber, (before + chamber.volume) / 2, guess.pressure, dt);
    spread(int(c));
    check_fall(chamber, before, middle);
    leak(int(c), dt);
  }
  merge();
  vent();
  events_told_ = true;
}

// By the speed at the middle of the step.
void Gas::advance_fronts(Chamber& chamber, double volume, double pressure, double dt) {
  const auto& speed = model_.scene.charges[chamber.charges[0]].gas_speed;
  GasMoment middle{std::max(0.0, model_.time - dt / 2 - chamber.began), volume, first_volume_[chamber.charges[0]],
                   pressure, chamber.front()};
  middle.front += dt / 2 * speed(middle);
  const double way = dt * speed(middle);
  for (double& front : chamber.fronts) front += way;
}

// A law that grows on the way, between the volumes that were tried when it was declared, would make gas from nothing.
// That of a mixture is asked for any volume by its search, and only of charges that passed this before they met.
void Gas::check_fall(const Chamber& chamber, double before, const GasMoment& now) const {
  if (chamber.charges.size() > 1) return;
  const int charge = chamber.charges[0];
  const double first = room(charge);
  const auto& check = model_.scene.charges[charge].check_fall;
  if (check) check(before / first, chamber.volume / first, now);
}

// R = max(R0, ∫ VP dt), R0 the hole's radius (Ning et al. 2011, equation 3: the gas is at the wall from the start).
void Gas::find_reach(int c) {
  const Chamber& chamber = chambers_[c];
  reach_[c] = paths_.find(model_, chamber.walls, [&](const Vec2& p) {
    for (size_t k = 0; k < chamber.walls.size(); ++k) {
      const HoleWall& hole = model_.hole_walls[chamber.walls[k]];
      const double radius = std::max(hole.radius, chamber.fronts[k]);
      if ((p - hole.centre).squaredNorm() <= radius * radius) return true;
    }
    return false;
  });
}

void Gas::visit_state(StateVisitor& visitor) {
  visitor("chambers", chambers_);
  visitor("first_volume", first_volume_);
  visitor("left", left_);
  visitor("stemming", stemming_);
  std::vector<Reach> ended(reach_.size());
  for (size_t c = 0; c < chambers_.size(); ++c)
    if (chambers_[c].pressure == 0) ended[c] = reach_[c];
  visitor("ended", ended);
  for (size_t c = 0; c < chambers_.size(); ++c)
    if (chambers_[c].pressure == 0) reach_[c] = ended[c];
}

// What gas that presses has reached follows from the cracks; what has ended stays where it had got to.
void Gas::restored() {
  events_told_ = true;
  for (size_t c = 0; c < chambers_.size(); ++c)
    if (chambers_[c].pressure > 0) find_reach(int(c));
}

}  // namespace talus
