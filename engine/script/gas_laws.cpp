#include "script/gas_laws.h"

#include "gas/eos.h"
#include "script/laws.h"
#include "script/lua_error.h"

namespace talus {
namespace {

// A function of one number whose result lies in [0, most]; its faults end the run.
std::function<double(double)> number_law(const LuaFunction& law, const Place& place, const std::string& label,
                                         const char* argument, double most, const char* expected) {
  return [=](double x) {
    const char* const names[] = {argument};
    const double arguments[] = {x};
    LawResult result = call_law(law, names, arguments);
    if (result.problem.empty() && !(result.value >= 0 && result.value <= most))
      result.problem = std::string("at ") + argument + " = " + std::to_string(x) + ": expected " + expected + ", got " +
                       std::to_string(result.value);
    if (!result.problem.empty()) throw LawError(place.text() + ": " + label + ": " + result.problem);
    return result.value;
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
  for (const auto& [key, value] : {std::pair{"A", &c.a}, {"B", &c.b}, {"R1", &c.r1}, {"R2", &c.r2}, {"omega", &c.omega},
                                   {"E", &c.energy}, {"filled", &filled}})
    t.read(key, *value);
  return jwl(c, filled);
}

}  // namespace

Charge read_charge(const TableReader& t) {
  Charge c;
  t.read("place", c.place);
  t.read("name", c.name);
  t.read_index("region", c.region);
  t.read_index("hole", c.hole);
  t.read("delay", c.delay);
  lua_State* L = t.state();
  constexpr double no_bound = 1e300;
  const auto law = [&](const char* key, const char* label, const char* argument, double most, const char* expected) {
    std::function<double(double)> found;
    if (!t.push(key)) return found;
    found = number_law(LuaFunction(L, -1), c.place, label, argument, most, expected);
    lua_pop(L, 1);
    return found;
  };
  c.law.pressure = law("eos", "charge.eos", "v", no_bound, "a pressure >= 0 (Pa)");
  t.with("law", [&](const TableReader& l) { c.law = ready_made(l); });
  c.gas_speed = law("speed_law", "charge.gas_speed", "t", no_bound, "a speed >= 0 (m/s)");
  if (!c.gas_speed) {
    double speed = 0;
    t.read("speed", speed);
    c.gas_speed = [speed](double) { return speed; };
  }
  c.venting = law("venting", "charge.venting", "t", 1, "a part from 0 to 1");
  return c;
}

}  // namespace talus
