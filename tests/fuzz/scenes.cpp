// Scenes drawn at random.
#include <cmath>
#include <cstdio>

#include "targets.h"

namespace talus::fuzz {
namespace {

class Writer {
 public:
  explicit Writer(std::uint64_t seed) : random_(seed) {}

  std::string scene() {
    std::string text = "local talus = require \"talus\"\n";
    text += "local rock = talus.material { density = " + good(1000, 4000) + ", young = " + good(1e6, 1e11) +
            ", poisson = " + good(0, 0.49) + (chance(4) ? ", plane = \"stress\"" : "") + " }\n";
    text += "local bond = talus.joint { friction = " + good(0, 1.4) + ", cohesion = " + good(0, 1e7) +
            ", tension = " + good(0, 1e6) + " }\n";
    const std::size_t count = 1 + random_.below(3);
    for (std::size_t i = 0; i < count; ++i) text += region(i);
    text += "talus.simulation { regions = {";
    for (std::size_t i = 0; i < count; ++i) text += " r" + std::to_string(i) + ",";
    text += " },\n  contact = bond, gravity = {" + good(-1, 1) + ", " + good(-20, 0) + "}, max_blocks = 400,\n  " +
            time_ + ",\n  ";
    if (chance(3)) text += "fix = { talus.fix { region = r0, on = \"" + side() + "\" } },\n  ";
    if (chance(3))
      text += "loads = { talus.point_load { region = r0, at = {" + good(0, 1) + ", " + good(0, 1) + "}, force = {" +
              good(-1e6, 1e6) + ", 0} } },\n  ";
    if (chance(4)) text += "boundaries = { talus.viscous { region = r0, on = {\"" + side() + "\"} } },\n  ";
    if (chance(5))
      text += "numerics = { solver = \"" + one_of({"auto", "factor", "sweeps", "splitting"}) +
              "\", theta = " + good(0.5, 1) + " },\n  ";
    if (hole_ && chance(2))
      text += "charges = { talus.charge { hole = \"hole\", eos = talus.eos.polytropic { pressure = " + good(1e5, 1e8) +
              ", gamma = " + good(1.01, 2) + " }, gas_speed = " + good(0, 500) + " } },\n  ";
    return text + "probes = { p = {" + good(0, 1) + ", " + good(0, 1) + "} } }\n";
  }

 private:
  bool chance(std::size_t one_in) { return random_.below(one_in) == 0; }
  static std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
  }
  // A value of the range; one in thirty is odd.
  std::string good(double low, double high) {
    static const char* const odd[] = {
        "0", "-1", "1e300", "1e-300", "0/0", "1/0", "\"x\"", "{}", "nil", "true", "function() return 0/0 end"};
    if (chance(30)) return odd[random_.below(std::size(odd))];
    const double part = random_.unit();
    return number(low > 0 && high / low > 100 ? low * std::pow(high / low, part) : low + part * (high - low));
  }
  std::string one_of(std::initializer_list<const char*> words) { return words.begin()[random_.below(words.size())]; }
  std::string side() { return one_of({"left", "right", "top", "bottom"}); }
  std::string point(double x, double y) {
    return "{" + number(x + (chance(3) ? 0 : 0.2 * random_.unit())) + ", " +
           number(y + (chance(3) ? 0 : 0.2 * random_.unit())) + "}";
  }

  std::string region(std::size_t i) {
    const double x = double(i % 2) * (chance(4) ? 0.9 : 1.3), y = double(i) * (chance(4) ? 0.8 : 1.25);
    std::string text =
        "local r" + std::to_string(i) + " = talus.region { name = \"r" + std::to_string(i) + "\", material = rock";
    text += ", outline = { " + point(x, y) + ", " + point(x + 1, y) + ", " + point(x + 1, y + 1) + ", " +
            point(x, y + 1) + " }";
    if (i == 0 && chance(3)) {
      hole_ = true;
      text += ", holes = { talus.circle { at = {" + number(x + 0.5) + ", " + number(y + 0.5) +
              "}, radius = " + good(0.05, 0.2) + ", sides = 8, name = \"hole\" } }";
    }
    static const char* const kinds[] = {"", "kind = \"voronoi\", ", "kind = \"cross\", nx = 3, ny = 2"};
    const std::size_t kind = random_.below(3);
    if (chance(2))
      text += std::string(", joint = bond, mesh = { ") + kinds[kind] + (kind == 2 ? "" : "size = " + good(0.15, 0.6)) +
              " }";
    if (chance(3))
      text += ", cuts = { talus.joint_set { dip = " + good(-1.5, 1.5) + ", spacing = " + good(0.2, 1) + " } }";
    if (chance(4)) text += ", held = true";
    if (chance(4)) text += ", order = " + one_of({"1", "2", "\"rigid\""});
    if (chance(4)) text += ", velocity = {" + good(-5, 5) + ", " + good(-5, 5) + "}";
    return text + " }\n";
  }

  Random random_;
  bool hole_ = false;
  std::string time_ =
      chance(3) ? "time = { mode = \"static\", steps = 2 }" : "time = { t_end = 0.01, dt = " + good(1e-5, 1e-2) + " }";
};

}  // namespace

std::string random_scene(std::uint64_t seed) {
  return Writer(seed).scene();
}

}  // namespace talus::fuzz
