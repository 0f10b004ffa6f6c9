#include "fracture/snap_back.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace talus {

namespace {

struct Blocks {
  int bonds = 0, too_large = 0;
  double smallest = 0, largest_allowed = 0;  // m, √area; E · softening_compliance of the stiffest rock and strongest bond
};

std::string metres(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g m", value);
  return text.data();
}

}  // namespace

std::string check_snap_back(const Model& model) {
  std::vector<Blocks> blocks(model.scene.properties.size());
  for (const Joint& joint : model.joints) {
    const JointProperty& property = model.scene.properties[joint.property];
    const double lost = model.strength(joint).tension - property.residual.tension;
    if (!joint.bonded || property.softening_compliance == 0 || lost <= 0) continue;
    const double compliance = property.softening_compliance * std::pow((property.tension - property.residual.tension) / lost, 2);
    const double size = (model.shapes[joint.a].length + model.shapes[joint.b].length) / 2;
    const double allowed = compliance * std::max(model.material(joint.a).young, model.material(joint.b).young);
    Blocks& of = blocks[joint.property];
    of.smallest = of.bonds == 0 ? size : std::min(of.smallest, size);
    of.largest_allowed = of.bonds == 0 ? allowed : std::min(of.largest_allowed, allowed);
    of.too_large += size > allowed;
    ++of.bonds;
  }
  std::string note;
  for (std::size_t p = 0; p < blocks.size(); ++p) {
    const Blocks& of = blocks[p];
    if (of.too_large == 0) continue;
    const JointProperty& property = model.scene.properties[p];
    const std::string allowed = metres(of.largest_allowed);
    if (of.too_large == of.bonds)
      throw InputError(property.place, "joint.reduction",
                       "blocks of at most " + allowed + " (root of the area; triangles of " +
                           metres(1.5 * of.largest_allowed) +
                           "), as larger ones give back more energy than G_I takes and snap back in one step",
                       "blocks of " + metres(of.smallest) + " and more");
    note += (note.empty() ? "" : "; ") + std::to_string(of.too_large) + " of the " + std::to_string(of.bonds) +
            " bonds of " + property.name + " are between blocks above " + allowed +
            " (root of the area): where they soften they snap back in one step";
  }
  return note;
}

}  // namespace talus
