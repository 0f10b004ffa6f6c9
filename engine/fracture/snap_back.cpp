#include "fracture/snap_back.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace talus {

namespace {

std::string metres(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g m", value);
  return text.data();
}

struct Blocks {
  int bonds = 0, too_large = 0;
  double smallest = 0, largest_allowed = 0;  // m, √area; modulus · compliance of the stiffest rock and strongest bond

  void add(double size, double allowed) {
    smallest = bonds == 0 ? size : std::min(smallest, size);
    largest_allowed = bonds == 0 ? allowed : std::min(largest_allowed, allowed);
    too_large += size > allowed;
    ++bonds;
  }
  std::string told(const std::string& name) const {
    return std::to_string(too_large) + " of the " + std::to_string(bonds) + " bonds of " + name +
           " are between blocks above " + metres(largest_allowed) + " (root of the area): where they soften ";
  }
};

// In one direction: its strength, the compliance of laws there, and the rock's modulus.
std::vector<Blocks> blocks_of(const Model& model, double Strength::*strength, double JointProperty::*compliance,
                              double (*modulus)(const Material&)) {
  std::vector<Blocks> blocks(model.scene.properties.size());
  for (const Joint& joint : model.joints) {
    const JointProperty& property = model.scene.properties[joint.property];
    const double residual = property.residual.*strength, lost = model.strength(joint).*strength - residual;
    if (!joint.bonded || property.*compliance == 0 || lost <= 0) continue;
    const double size = (model.shapes[joint.a].length + model.shapes[joint.b].length) / 2;
    const double allowed = property.*compliance * std::pow((property.strength().*strength - residual) / lost, 2) *
                           std::max(modulus(model.material(joint.a)), modulus(model.material(joint.b)));
    blocks[joint.property].add(size, allowed);
  }
  return blocks;
}

// Of shear no size is refused: most bonds that fail in it are pressed, and friction follows.
std::string in_shear(const Model& model) {
  const auto modulus = [](const Material& rock) { return rock.young / (2 * (1 + rock.poisson)); };
  const std::vector<Blocks> blocks = blocks_of(model, &Strength::cohesion, &JointProperty::shear_compliance, modulus);
  std::string note;
  for (std::size_t p = 0; p < blocks.size(); ++p)
    if (blocks[p].too_large > 0)
      note += (note.empty() ? "" : "; ") + blocks[p].told(model.scene.properties[p].name) +
              "in shear they snap back in one step";
  return note;
}

}  // namespace

std::string check_snap_back(const Model& model) {
  const auto modulus = [](const Material& rock) { return rock.young; };
  const std::vector<Blocks> blocks =
      blocks_of(model, &Strength::tension, &JointProperty::softening_compliance, modulus);
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
    note += (note.empty() ? "" : "; ") + of.told(property.name) + "they snap back in one step";
  }
  const std::string sheared = in_shear(model);
  return note + (note.empty() || sheared.empty() ? "" : "; ") + sheared;
}

}  // namespace talus
