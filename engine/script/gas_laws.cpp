#include "script/gas_laws.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <numbers>
#include <vector>

#include "gas/eos.h"
#include "geometry/random.h"
#include "script/laws.h"
#include "script/lua_error.h"

namespace talus {
namespace {

// A function whose result lies in [0, most]; its faults end the run. It gets the first numbers, which messages
// show, and those of the chamber, of which lib/talus/gas.lua makes the table that the script sees.
using NumberLaw = std::function<double(std::initializer_list<double>, const GasMoment&)>;
NumberLaw number_law(const LuaFunction& law, const Place& place, const std::string& label, const char* argument,
                     double most, const char* expected) {
  return [=](std::initializer_list<double> numbers, const GasMoment& m) {
    const char* const names[] = {argument};
    std::vector<double> arguments(numbers);
    arguments.insert(arguments.end(), {m.volume, m.first_volume, m.pressure, m.front});
    LawResult result = call_law(law, names, arguments);
    if (result.problem.empty() && !(result.value >= 0 && result.value <= most))
      result.problem = std::string("at ") + argument + " = " + std::to_string(arguments[0]) + ": expected " + expected +
                       ", got " + std::to_string(result.value);
    if (!result.problem.empty()) throw LawError(place.text() + ": " + label + ": " + result.problem);
    return result.value;
  };
}

// A function is declared for v >= 1. Where rock has closed in on the gas, and where a solver tries volumes that no step
// comes to, it has the pressure that it has at 1.
void read_eos(const NumberLaw& eos, Charge& c) {
  const auto pressure = [eos](double v, const GasMoment& m) { return eos({v > 1 ? v : 1, m.t}, m); };
  c.law.pressure = pressure;
  c.check_fall = [pressure, place = c.place](double v, double other, const GasMoment& m) {
    const auto [less, more] = std::minmax(v, other);
    const double most = pressure(less, m), found = pressure(more, m);
    if (found <= most * (1 + 1e-9)) return;
    char text[200];
    std::snprintf(text, sizeof text, "at v = %g, t = %g at most that at v = %g, %.6g (Pa), got %.6g", more, m.t, less,
                  most, found);
    throw LawError(place.text() + ": charge.eos: expected a pressure that falls as the gas expands: " + text);
  };
}

GasLaw ready_made(const TableReader& t) {
  std::string kind;
  t.read("kind", kind);
  if (kind == "polytropic") {
    double pressure = 0, gamma = 0;
    t.read("pressure", pressure);
    t.read("gamma", gamma);
    return polytropic(pressure, gamma);
  }
  Jwl c{};
  double filled = 1;
  for (const auto& [key, value] : {std::pair{"A", &c.a},
                                   {"B", &c.b},
                                   {"R1", &c.r1},
                                   {"R2", &c.r2},
                                   {"omega", &c.omega},
                                   {"E", &c.energy},
                                   {"filled", &filled}})
    t.read(key, *value);
  return jwl(c, filled);
}

// Normal with the deviation `scatter` about `delay`, by Box and Muller; what would come before the start comes at
// it.
double scattered(double delay, double scatter, std::uint64_t seed, std::uint64_t charge) {
  Random random(Random(seed).next() + charge);
  const double radius = std::sqrt(-2 * std::log(1 - random.unit()));
  return std::max(0.0, delay + scatter * radius * std::cos(2 * std::numbers::pi * random.unit()));
}

Orifice read_orifice(const TableReader& t) {
  Orifice o;
  t.read("coefficient", o.coefficient);
  t.read("gamma", o.gamma);
  t.read("density", o.density);
  t.read("atmosphere", o.atmosphere);
  t.read("opening", o.opening);
  return o;
}

}  // namespace

Charge read_charge(const TableReader& t) {
  Charge c;
  t.read("place", c.place);
  t.read("name", c.name);
  t.read_index("region", c.region);
  t.read_index("hole", c.hole);
  t.read("mass", c.mass);
  t.read("delay", c.delay);
  t.with("scatter", [&](const TableReader& s) {
    double deviation = 0;
    long seed = 0, charge = 0;
    s.read("deviation", deviation);
    s.read("seed", seed);
    s.read("charge", charge);
    c.delay = scattered(c.delay, deviation, std::uint64_t(seed), std::uint64_t(charge));
  });
  lua_State* L = t.state();
  constexpr double no_bound = 1e300;
  const auto law = [&](const char* key, const char* label, const char* argument, double most, const char* expected) {
    NumberLaw found;
    if (!t.push(key)) return found;
    found = number_law(LuaFunction(L, -1), c.place, label, argument, most, expected);
    lua_pop(L, 1);
    return found;
  };
  if (const auto eos = law("eos", "charge.eos", "v", no_bound, "a pressure >= 0 (Pa)")) read_eos(eos, c);
  t.with("law", [&](const TableReader& l) { c.law = ready_made(l); });
  t.read("speed", c.constant_speed);
  c.gas_speed = [constant = c.constant_speed.value_or(0)](const GasMoment&) { return constant; };
  if (const auto speed = law("speed_law", "charge.gas_speed", "t", no_bound, "a speed >= 0 (m/s)"))
    c.gas_speed = [speed](const GasMoment& m) { return speed({m.t}, m); };
  if (const auto part = law("venting", "charge.venting", "t", 1, "a part from 0 to 1"))
    c.venting = [part](const GasMoment& m) { return part({m.t}, m); };
  t.with("orifice", [&](const TableReader& o) { c.orifice = read_orifice(o); });
  t.with("stemming", [&](const TableReader& s) {
    c.stemming.emplace();
    s.read("length", c.stemming->length);
    s.read("density", c.stemming->density);
    s.read("charge_length", c.stemming->charge_length);
  });
  return c;
}

}  // namespace talus
