#include "step/energies.h"

#include <algorithm>
#include <span>

#include "equations/block_terms.h"
#include "equations/bridge_terms.h"
#include "model/rates.h"

namespace talus {

namespace {

Apart<BendArray> bend_ahead(const BlockState& state, double seconds) {
  Apart<BendArray> bend = state.bend;
  for (size_t k = 0; bend && k < bend->size(); ++k) (*bend)[k] += seconds * state.velocity[first_order_dofs + k];
  return bend;
}

// Of the blocks that sleep, or of those that do not.
double strain_of_blocks(const Model& model, bool asleep, double ahead) {
  std::vector<Mat3> elasticity_of;
  for (const Material& material : model.scene.materials) elasticity_of.push_back(elasticity(material));
  double sum = 0;
  for (size_t b = 0; b < model.blocks.size(); ++b) {
    if (model.sleeps(int(b)) != asleep) continue;
    const BlockShape& shape = model.shapes[b];
    if (shape.dofs <= rigid_dofs) continue;
    const auto& v = model.blocks[b].velocity;
    const Vec3 e = model.blocks[b].strain + ahead / shape.length * Vec3(v[3], v[4], v[5]);
    sum += shape.area * e.dot(shape.initial_stress + elasticity_of[shape.material] * e / 2);
    if (const auto bend = bend_ahead(model.blocks[b], ahead))
      sum += bend_energy(model, int(b), Eigen::Map<const Vec6>(bend->data()));
  }
  return sum;
}

}  // namespace

double initial_stress_energy(const Model& model) {
  double sum = 0;
  for (const BlockShape& shape : model.shapes)
    if (shape.dofs > rigid_dofs && !shape.initial_stress.isZero(0))
      sum += shape.area / 2 *
             shape.initial_stress.dot(elasticity(model.scene.materials[size_t(shape.material)]).inverse() *
                                      shape.initial_stress);
  return sum;
}

double kinetic_energy(const Model& model, double ahead) {
  double sum = 0;
  for (const int b : model.awake_blocks()) sum += kinetic_energy(model, b, ahead);
  return sum;
}

double kinetic_energy(const Model& model, int b, double ahead) {
  const BlockShape& shape = model.shapes[b];
  const BlockState& state = model.blocks[b];
  const auto& v = state.velocity;
  if (shape.dofs == 0 || stands_still(v)) return 0;
  const double at_reference = with_size(shape.second_order(), [&](auto n) {
    const ColumnOf<n> rates = v.column<n>();
    return rates.dot(mass_matrix_of<n>(model, b) * rates) / 2;
  });
  if (shape.dofs == rigid_dofs) return at_reference;
  const Vec3 at_y = state.strain + ahead / shape.length * Vec3(v[3], v[4], v[5]);
  const double x = moment_of_inertia(model, b, state.strain, state.bend),
               y = moment_of_inertia(model, b, at_y, bend_ahead(state, ahead));
  const double spin = mean_spin(model, b, state);
  return at_reference + (x * x / y - moment_of_inertia(model, b, Vec3::Zero())) * spin * spin / 2;
}

double strain_energy(const Model& model, const JointTerms& joints, const Supports& supports, double ahead) {
  double sum = strain_of_blocks(model, false, ahead) + model.added_strain_energy;
  for (const Joint& joint : model.joints)
    if (joint.bridged) sum += bridge_energy(joint);
  return sum + (model.joints.empty() ? 0 : joints.energy(model, ahead)) + supports.energy(model, ahead);
}

Vec2 contact_push(const Model& model, const Contact& c) {
  const int next = model.shapes[c.j].vertex_begin + model.next_vertex(c.j, c.edge);
  const Vec2 along = (model.vertex[next] - model.vertex[c.global_edge]).normalized();
  return -c.normal_force * perp(along) - (c.shear_force + c.slope * c.normal_force) * along;
}

double contact_energy(std::span<const Contact> contacts) {
  double sum = 0;
  for (const Contact& c : contacts) sum += c.stored();
  return sum;
}

int closed_contacts(std::span<const Contact> contacts) {
  return int(
      std::count_if(contacts.begin(), contacts.end(), [](const Contact& c) { return c.state != ContactState::open; }));
}

Asleep stored_asleep(const Model& model) {
  return {strain_of_blocks(model, true, 0), contact_energy(model.asleep_contacts()),
          closed_contacts(model.asleep_contacts())};
}

double gravity_energy_ahead(const Model& model, double ahead) {
  double sum = 0;
  for (const int b : model.awake_blocks())
    if (model.shapes[b].dofs > 0) {
      const auto& v = model.blocks[b].velocity;
      sum -= model.mass(b) * model.scene.gravity.dot(Vec2(v[0], v[1]));
    }
  return ahead * sum;
}

}  // namespace talus
