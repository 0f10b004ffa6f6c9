#include "script/explain.h"

#include <cmath>
#include <numbers>

#include "fracture/criterion.h"
#include "output/axis.h"
#include "output/text.h"

namespace talus {

namespace {

std::string pascal(double value) {
  return quantity(value, "Pa");
}
std::string degrees(double radians) {
  return significant(radians * 180 / std::numbers::pi, 3) + "°";
}
std::string metres(double value) {
  return quantity(value, "m");
}
std::string per_cent(double part) {
  return significant(100 * part, 3) + " %";
}

std::string who(const Model& model, int id) {
  const Joint& joint = model.joints[id];
  const Vec2 mid = model.place(joint.a, (joint.in_a[0] + joint.in_a[1]) / 2) + model.origin;
  return "Joint " + std::to_string(id + 1) + ", " + metres(joint.length) + " long at (" + significant(mid.x(), 4) +
         ", " + significant(mid.y(), 4) + ") m, between blocks " + std::to_string(joint.a + 1) + " and " +
         std::to_string(joint.b + 1) + " of \"" + model.scene.regions[model.shapes[joint.a].region].name +
         "\", of the joint \"" + model.scene.properties[joint.property].name + "\". ";
}

std::string carried(const BondTraction& t) {
  const std::string normal = t.normal >= 0 ? "a tension of " + pascal(t.normal) : "a pressure of " + pascal(-t.normal);
  return normal + " and a shear of " + pascal(std::abs(t.shear));
}

std::string left_of(const Strength& strength) {
  return "friction " + degrees(strength.friction) + ", cohesion " + pascal(strength.cohesion) + ", tension " +
         pascal(strength.tension);
}

// How far each strength was used by `t`, and which of them governs.
std::string judged(const Model& model, const Joint& joint, const BondTraction& t, double utilisation_then) {
  const JointProperty& property = model.scene.properties[joint.property];
  if (property.criterion)
    return "The script's own criterion says that " + per_cent(utilisation_then) + " of its strength is used. ";
  const Strength strength = model.strength(joint);
  const Utilisation by = utilisation(t, strength);
  if (by.most() == 0)
    return "Nothing pulls it apart, and friction alone holds the shear: none of its strength is used. ";
  std::string text;
  if (by.tension > 0)
    text +=
        "Tension: " + pascal(t.normal) + " of " + pascal(strength.tension) + ", " + per_cent(by.tension) + " used. ";
  if (by.shear > 0)
    text += "Shear: |τ| + σ tan " + degrees(strength.friction) + " = " +
            pascal(std::abs(t.shear) + t.normal * std::tan(strength.friction)) + " of the cohesion " +
            pascal(strength.cohesion) + ", " + per_cent(by.shear) + " used. ";
  return text + (by.tension >= by.shear ? "Tension governs. " : "Shear governs, by Mohr–Coulomb. ");
}

// How the faces of what is no bond stand to each other.
std::string faces(const Model& model, int id) {
  double pressed = 0;
  bool slips = false;
  for (const Contact& c : model.contacts) {
    if (c.joint != id || c.state == ContactState::open) continue;
    pressed += c.normal_force;
    slips = slips || c.state == ContactState::slip;
  }
  if (pressed > 0)
    return "Its faces press on each other with " + pascal(pressed / model.joints[id].length) + " and " +
           (slips ? "slide." : "stick.");
  const auto& points = model.joints[id].points;
  return "Its faces do not press on each other; they are " +
         metres(std::max(0.0, (points[0].opening + points[1].opening) / 2)) + " apart.";
}

std::string failed(const Model& model, int id) {
  const Joint& joint = model.joints[id];
  constexpr const char* kinds[] = {"", "It was a crack of its own. ", "It let a crack grow on. ",
                                   "It joined two cracks. "};
  std::string text = "It failed in " + std::string(joint.mode == FailureMode::shear ? "shear" : "tension") +
                     " at t = " + quantity(joint.failed_at, "s", 4) + ", under " + carried(joint.failed_with) + ". ";
  text += judged(model, joint, joint.failed_with, joint.utilisation);
  if (joint.path_turn != 0)
    text += "Of the bonds at the tip of its crack it lay nearest to the path, whose normal is " +
            degrees(std::abs(joint.path_turn)) +
            " off its own, when the tension across that path or in one of them reached the strength. ";
  text += kinds[int(joint.crack)];
  return text + "What it has left: " + left_of(joint.remaining) + ". " + faces(model, id);
}

std::string intact(const Model& model, const Joint& joint) {
  const BondTraction now = mean_traction(joint);
  const std::string load = "carries " + carried(now) + ". ";
  if (!model.scene.properties[joint.property].breaks)
    return "It is bonded and " + load + "Its joint gives no strength: it never fails.";
  std::string text = "It is intact and " + load + judged(model, joint, now, joint.utilisation);
  if (joint.utilisation > utilisation(model, joint))  // judged by the tip of a tracked crack
    text += "A crack that ends at it would go on along it: the tension across that path uses " +
            per_cent(joint.utilisation) + " of its strength.";
  else if (joint.utilisation > 0)
    text += "It would fail at " + significant(1 / joint.utilisation, 3) + " times this traction.";
  return text;
}

}  // namespace

std::string explain(const Model& model, int id) {
  const Joint& joint = model.joints[id];
  if (!joint.bonded)
    return who(model, id) + "It was never bonded, so it cannot fail: friction " +
           degrees(model.scene.properties[joint.property].friction) + ", cohesion " +
           pascal(model.scene.properties[joint.property].cohesion) + ". " + faces(model, id);
  return who(model, id) + (joint.state == JointState::failed ? failed(model, id) : intact(model, joint));
}

}  // namespace talus
