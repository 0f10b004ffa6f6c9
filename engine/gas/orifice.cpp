#include "gas/orifice.h"

#include <algorithm>
#include <cmath>

#include "equations/side.h"

namespace talus {

namespace {

constexpr double at_most = 0.02;  // of the gas leaves in one step of Runge and Kutta: off by less than 1e-8 of it
constexpr double ended = 1.001;   // times the atmosphere's pressure, which the flow reaches ever more slowly

}  // namespace

double mass_flux(double gamma, double pressure, double density, double outside) {
  const double ratio = outside / pressure;
  if (ratio >= 1) return 0;
  if (ratio <= std::pow(2 / (gamma + 1), gamma / (gamma - 1)))
    return std::sqrt(gamma * pressure * density) * std::pow(2 / (gamma + 1), (gamma + 1) / (2 * (gamma - 1)));
  return std::sqrt(2 * gamma / (gamma - 1) * pressure * density *
                   (std::pow(ratio, 2 / gamma) - std::pow(ratio, (gamma + 1) / gamma)));
}

double blow_down(const Orifice& orifice, double opening, double mass, double volume,
                 const std::function<double(double)>& pressure, double seconds) {
  const auto rate = [&](double x) {
    return orifice.coefficient * opening / mass *
           mass_flux(orifice.gamma, pressure(x), x * mass / volume, orifice.atmosphere);
  };
  double left = 1;
  while (seconds > 0) {
    const double first = rate(left), h = first > 0 ? std::min(seconds, at_most * left / first) : seconds;
    const double second = rate(left - h / 2 * first), third = rate(left - h / 2 * second),
                 fourth = rate(left - h * third);
    left -= h / 6 * (first + 2 * second + 2 * third + fourth);
    seconds -= h;
    if (pressure(left) <= ended * orifice.atmosphere) return 0;
  }
  return left;
}

double opening(const Orifice& orifice, const Model& model, const Reach& reach) {
  if (orifice.opening) return *orifice.opening;
  double sum = 0;
  for (const ReachedJoint& r : reach.joints) {
    const Joint& joint = model.joints[r.joint];
    const Vec2 along = model.place(joint.a, joint.in_a[1]) - model.place(joint.a, joint.in_a[0]);
    for (const int end : {0, 1}) {
      if (!model.nodes.free[joint.node[end]] || (end == 0 ? r.from > 0 : r.to < 1)) continue;
      const Vec2 gap = model.place(joint.b, joint.in_b[end]) - model.place(joint.a, joint.in_a[end]);
      // A block has its edges counter-clockwise: a lies on the left of its own face.
      sum += std::max(0.0, -perp(along).dot(gap) / along.norm());
    }
  }
  return sum;
}

}  // namespace talus
