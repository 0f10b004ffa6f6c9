// What is said where no step can be accepted.
#include <cmath>
#include <cstdio>
#include <string>

#include "step/step.h"

namespace talus {

namespace {

constexpr int most_contacts = 4;  // that a message lists

// Corners and sides from 1 on, as a block's `vertices` in Lua; forces are those that the last step ended with.
std::string contacts_of(const Model& model, int block, bool open) {
  std::string text;
  int count = 0;
  for (const Contact& c : model.contacts) {
    if ((c.i != block && c.j != block) || (c.state == ContactState::open) != open || ++count > most_contacts) continue;
    char forces[100];
    std::snprintf(forces, sizeof forces, " %s under %.3g N/m across and %.3g N/m along it",
                  c.state == ContactState::stick ? "sticks" : "slips", c.normal_force, c.shear_force);
    text += "; corner " + std::to_string(c.vertex + 1) + " of " + block_name(model, c.i) + " on side " +
            std::to_string(c.edge + 1) + " of " + block_name(model, c.j) + (open ? " is open" : forces);
  }
  if (count == 0) return open ? "; it has no contacts" : contacts_of(model, block, true);
  if (count > most_contacts) text += "; and " + std::to_string(count - most_contacts) + " more";
  return "; as the step began" + text.substr(1);
}

}  // namespace

void Stepper::give_up(const Course& course, double dt) const {
  const IslandResult& result = course.result;
  char text[600];
  if (const int crushed = course.crushed; crushed >= 0) {
    std::snprintf(
        text, sizeof text,
        "t = %.9g s: %s would be squeezed to less than a tenth of its area: a pressure, load or speed of the scene is beyond what "
        "material.young, %.3g Pa, holds linearly",
        model_.time, block_name(model_, crushed).c_str(), model_.material(crushed).young);
    throw RunError(text);
  }
  if (result.singular_block >= 0) {
    std::snprintf(
        text, sizeof text,
        "t = %.9g s: no step down to %.3g s has a solution: the inertia of %s is lost beside its stiffness; give a shorter time.dt",
        model_.time, dt, block_name(model_, result.singular_block).c_str());
    throw RunError(text);
  }
  if (result.converged && course.past) {
    std::snprintf(text, sizeof text,
                  "t = %.9g s: in a step of %.3g s %s and %s come to lie in each other, or press, where none of their "
                  "contacts expected it, and time.dt_min lets none be shorter: give a smaller one",
                  model_.time, dt, block_name(model_, course.past->first).c_str(),
                  block_name(model_, course.past->second).c_str());
    throw RunError(text);
  }
  if (result.converged) {
    std::snprintf(
        text, sizeof text,
        "t = %.9g s: in a step of %.3g s a block would move farther than time.displacement_ratio, or turn by more than 0.1 rad, or where time.dt is given the thinnest "
        "block, allows, and time.dt_min lets none be shorter: give a smaller one, or a larger ratio",
        model_.time, dt);
    throw RunError(text);
  }
  if (parts_.gas && parts_.gas->gives_up()) {
    std::snprintf(text, sizeof text,
                  "t = %.9g s: no step down to %.3g s has a gas pressure that agrees with the volume it leads to",
                  model_.time, dt);
    throw RunError(text);
  }
  if (again_ > most_again) {
    std::snprintf(
        text, sizeof text,
        "t = %.9g s: bonded blocks turn so much in a step of %.3g s that their bonds cannot follow, and time.dt_min lets none be shorter",
        model_.time, dt);
    throw RunError(text);
  }
  if (bridge_motion_.gives_up()) {
    std::snprintf(
        text, sizeof text,
        "t = %.9g s: no step down to %.3g s has softening bonds whose forces agree with how far it opens them",
        model_.time, dt);
    throw RunError(text);
  }
  if (!std::isfinite(result.residual)) {
    std::snprintf(
        text, sizeof text,
        "t = %.9g s: the forces on %s are beyond the largest number: gravity, a load, a stiffness or a speed of the scene "
        "is too large",
        model_.time, block_name(model_, std::max(result.worst_block, 0)).c_str());
    throw RunError(text);
  }
  std::snprintf(
      text, sizeof text,
      "t = %.9g s: no step down to %.3g s is accepted: after %d iterations the contact forces on %s are out of "
      "balance by %.3g of what meets there",
      model_.time, dt, result.iterations, block_name(model_, std::max(result.worst_block, 0)).c_str(), result.residual);
  throw RunError(text + contacts_of(model_, result.worst_block, false));
}

}  // namespace talus
