#include "gas/eos.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace talus {

GasLaw polytropic(double pressure, double gamma) {
  return {[=](double v, const GasMoment&) { return pressure * std::pow(v, -gamma); },
          [=](double from, double to) {
            const double power = 1 - gamma, ratio = std::log(to / from);  // P0 (to^p - from^p)/p, also as p goes to 0
            return std::abs(power * ratio) < 1e-9
                       ? pressure * std::pow(from, power) * ratio
                       : pressure * std::pow(from, power) * std::expm1(power * ratio) / power;
          },
          {pressure, gamma}};
}

GasLaw jwl(const Jwl& c, double filled) {
  const double tail = c.omega * (c.energy - c.a / c.r1 * std::exp(-c.r1) - c.b / c.r2 * std::exp(-c.r2));
  const auto pressure = [=](double v, const GasMoment&) {
    const double w = v / filled;
    return c.a * std::exp(-c.r1 * w) + c.b * std::exp(-c.r2 * w) + tail * std::pow(w, -1 - c.omega);
  };
  const auto energy = [=](double v) {  // J per m3 of explosive
    const double w = v / filled;
    return c.a / c.r1 * std::exp(-c.r1 * w) + c.b / c.r2 * std::exp(-c.r2 * w) + tail / c.omega * std::pow(w, -c.omega);
  };
  return {pressure,
          [=](double from, double to) { return filled * (energy(from) - energy(to)); },
          {c.a, c.b, c.r1, c.r2, c.omega, c.energy, filled}};
}

double work(const GasLaw& law, double from, double to, const GasMoment& moment) {
  if (law.work) return law.work(from, to);
  constexpr std::array<std::pair<double, double>, 5> gauss = {{{-0.9061798459386640, 0.2369268850561891},
                                                               {-0.5384693101056831, 0.4786286704993665},
                                                               {0, 0.5688888888888889},
                                                               {0.5384693101056831, 0.4786286704993665},
                                                               {0.9061798459386640, 0.2369268850561891}}};
  const int parts = std::max(1, int(std::ceil(std::abs(std::log2(to / from)))));
  double sum = 0;
  for (int k = 0; k < parts; ++k) {
    const double low = from * std::pow(to / from, double(k) / parts),
                 high = from * std::pow(to / from, (k + 1.0) / parts);
    for (const auto& [x, weight] : gauss)
      sum += weight / 2 * (high - low) * law.pressure((low + high + x * (high - low)) / 2, moment);
  }
  return sum;
}

}  // namespace talus
