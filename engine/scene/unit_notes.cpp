// Values that are allowed but that only a forgotten unit explains. Where nothing weighs what rock or soil does the
// scene is taken to have no units, and nothing is said.
#include <algorithm>
#include <cstdio>

#include "scene/build_parts.h"

namespace talus {

namespace {

constexpr double least_density = 500, most_density = 20000;  // kg/m3: pumice, tungsten
constexpr double least_young = 1e5;                          // Pa: gelatine
constexpr double least_pressure = 1e5;                       // Pa: the atmosphere's
constexpr double least_strength = 100;                       // Pa: the weight of a centimetre of soil
constexpr double least_stiffness = 1e6;                      // Pa/m: a decimetre of gelatine

bool has_units(const Material& material) {
  return material.density >= least_density && material.density <= most_density;
}

void doubt(const std::string& what, double value, const char* least, const char* unit,
           std::vector<std::string>& notes) {
  char text[160];
  std::snprintf(text, sizeof text, " = %g Pa is less than %s: is a unit missing (%g*talus.units.%s)?", value, least,
                value, unit);
  notes.push_back(what + text);
}

// The constants of an explosive are known: what is left is how it was loaded.
void doubt_density(const Charge& charge, double pressure, std::vector<std::string>& notes) {
  char text[120];
  std::snprintf(text, sizeof text, "its first pressure = %g Pa is less than the atmosphere's: is its density in kg/m3?",
                pressure);
  notes.push_back("charge \"" + charge.name + "\": " + text);
}

}  // namespace

void doubt_units(const Scene& scene, std::vector<std::string>& notes) {
  if (!std::any_of(scene.materials.begin(), scene.materials.end(), has_units)) return;
  for (const Material& material : scene.materials)
    if (has_units(material) && material.young > 0 && material.young < least_young)
      doubt("material \"" + material.name + "\": young", material.young, "that of gelatine", "GPa", notes);
  for (const JointProperty& joint : scene.properties) {
    if (joint.stiffness_kind == StiffnessKind::per_area && joint.stiffness < least_stiffness)
      doubt("joint \"" + joint.name + "\": stiffness per m", joint.stiffness, "that of a decimetre of gelatine", "GPa",
            notes);
    for (const auto& [name, value] : {std::pair{"tension", joint.tension}, {"cohesion", joint.cohesion}})
      if (value > 0 && value < least_strength)
        doubt("joint \"" + joint.name + "\": " + name, value, "what carries a centimetre of soil", "MPa", notes);
  }
  for (const Charge& charge : scene.charges) {
    if (!charge.law.work) continue;  // a law in Lua is called once more for nothing else
    const double pressure = charge.law.pressure(1, {.volume = 1, .first_volume = 1});
    if (pressure <= 0 || pressure >= least_pressure) continue;
    if (charge.mass > 0)
      doubt_density(charge, pressure, notes);
    else
      doubt("charge \"" + charge.name + "\": its first pressure", pressure, "the atmosphere's", "MPa", notes);
  }
}

}  // namespace talus
