#include "step/trapezoid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace talus {

namespace {

constexpr double most_bend = 0.01;   // part of the work that is exchanged
constexpr double least_bend = 1e-6;  // part of the ledger's scale: what moves along free is not looked at so closely
// Where the ledger as a whole comes to be off by half of what it may: a tenth of that, and finer parts, unless what
// they give off goes by their length.
constexpr double most_off = 0.005;  // part of the ledger's scale
constexpr double strict_bend = most_bend / 10, strict_increment = finest_increment / 256, by_length = 2;

// J/m, by loads and supports, to and fro.
double exchanged(const Ledger& before, const Ledger& now) {
  return std::abs(now.boundary_work - before.boundary_work) + std::abs(now.external_work - before.external_work) +
         std::abs(now.gravity_work - before.gravity_work);
}

}  // namespace

Trapezoid trapezoid_of(LoadPath& path, const Off& off, const Ledger& before, const Ledger& after,
                       const TimeControl& time) {
  const bool strict = std::abs(off.rest) > most_off * after.scale() && off.rest * off.now < 0;
  const double work = exchanged(before, after), least = least_bend * after.scale();
  if (std::abs(off.now) <= std::max((strict ? strict_bend : most_bend) * work, least)) return Trapezoid::holds;

  const double rate = off.now / path.length(), change = rate / std::exchange(path.off_rate, rate);
  const bool goes_by_length = 1 / by_length < change && change < by_length;
  // finer parts would leave as much
  if (goes_by_length && std::abs(off.now) <= std::max(most_bend * work, least)) return Trapezoid::holds;
  if (path.is_shortest()) return Trapezoid::jumps;
  const double parts = path.length() / (path.jumps() ? 1 : time.t_end / time.steps);  // of a load step
  if (parts > finest_increment || path.meets_jump()) return Trapezoid::too_long;
  return strict && parts > strict_increment && !(goes_by_length && off.now > 0) ? Trapezoid::too_long
                                                                                : Trapezoid::jumps;
}

}  // namespace talus
