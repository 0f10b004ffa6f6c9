#include "output/picture_field.h"

#include <algorithm>
#include <cmath>

#include "scene/error.h"
#include "script/nearest.h"

namespace talus {

namespace {

const std::function<double(int)>* user_field(const Scene& scene, const std::string& name) {
  for (const auto& [known, function] : scene.output.fields)
    if (known == name) return &function;
  return nullptr;
}

bool drawable(const Field& field) {
  return field.components <= 2;
}

// A quantity of joints: a block shows the largest of its own.
const Field* field_of_joints(const std::string& name) {
  const Field* field = find_field(joint_fields(), name);
  return field && !field->whole && field->components == 1 && !find_field(block_fields(), name) ? field : nullptr;
}

// Per block the value of largest size. Of what has failed the utilisation says nothing any more.
std::vector<double> largest_of_joints(const FieldContext& context, const Field& field) {
  std::vector<double> largest(context.model.shapes.size(), 0.0);
  const auto& joints = context.model.joints;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (field.name == "utilisation" && joints[j].state == JointState::failed) continue;
    double value = 0;
    field.get(context, int(j), &value);
    for (const int block : {joints[j].a, joints[j].b})
      if (std::abs(value) > std::abs(largest[block])) largest[block] = value;
  }
  return largest;
}

// Fields that differ from block to block however it is held keep their colour.
bool says_something_of_held(const Field& field) {
  return field.whole || field.name == "area" || field.name == "density" || field.name == "mass";
}

// Rounding errors of a model at rest: strains of 1e-16, a thousandfold for safety.
double rounding_noise(const Model& model, const Field& field) {
  constexpr double strain = 1e-13;
  if (field.unit == "Pa") {
    double young = 0;
    for (const Material& material : model.scene.materials) young = std::max(young, material.young);
    return strain * young;
  }
  if (field.unit == "m" || field.unit == "m/s") return strain * model.extent;
  return field.unit.empty() || field.unit.starts_with("rad") ? strain : 0;
}

}  // namespace

void check_picture_field(const Scene& scene, const std::string& name) {
  const Field* field = find_field(block_fields(), name);
  if ((field && drawable(*field)) || user_field(scene, name) || field_of_joints(name)) return;
  std::vector<std::string> known;
  for (const Field& each : block_fields())
    if (drawable(each)) known.push_back(each.name);
  for (const Field& each : joint_fields())
    if (field_of_joints(each.name)) known.push_back(each.name);
  for (const auto& [each, function] : scene.output.fields) known.push_back(each);
  throw InputError(scene.output.place, "output.picture", "a field of the blocks that is one number or a vector",
                   "\"" + name + "\"" + suggestion(name, known));
}

PictureField picture_field(const FieldContext& context, const std::string& name) {
  const Model& model = context.model;
  check_picture_field(model.scene, name);
  const Field* field = find_field(block_fields(), name);
  const auto* user = field ? nullptr : user_field(model.scene, name);
  const Field* of_joints = field || user ? nullptr : field_of_joints(name);
  const std::vector<double> joint_values = of_joints ? largest_of_joints(context, *of_joints) : std::vector<double>{};
  PictureField out;
  out.symbol = field && !field->symbol.empty() ? field->symbol : name;
  out.subscripts = field && !field->symbol.empty();
  out.unit = field ? field->unit : of_joints ? of_joints->unit : "";
  out.meaning = field       ? field->meaning
                : of_joints ? "joints: " + of_joints->meaning + "; the largest of each block's"
                            : name;
  out.whole = field && field->whole;
  out.noise = field && !field->whole ? rounding_noise(model, *field) : 0;
  const bool held_too = !field || says_something_of_held(*field);
  for (int b = 0; b < static_cast<int>(model.shapes.size()); ++b) {
    double value[3] = {0, 0, 0};
    out.grey.push_back(model.shapes[b].dofs == 0 && !held_too);
    if (user) {
      value[0] = (*user)(b);
    } else if (of_joints) {
      value[0] = joint_values[b];
    } else if (!out.grey.back()) {
      field->get(context, b, value);
    }
    if (field && field->name == "id") ++value[0];  // from 1, as in Lua and VTK
    out.values.push_back(field && field->components == 2 ? std::hypot(value[0], value[1]) : value[0]);
    if (!out.grey.back()) out.coloured.push_back(out.values.back());
  }
  return out;
}

}  // namespace talus
