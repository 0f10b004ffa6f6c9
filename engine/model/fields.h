#pragma once
// Named fields of the tables: one registry for VTK arrays, pictures, history columns, Lua views and the
// generated reference page.
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "model/model.h"

namespace talus {

class Recovery;  // smoothed stress, may be null

struct FieldContext {
  const Model& model;
  const Recovery* recovery;
  const std::vector<Vec3>* smoothed = nullptr;  // smoothed_stresses(), where several fields need them
};

struct Field {
  std::string name;  // "sxx", "velocity"
  std::string unit;
  std::string meaning;
  int components;  // 1, 2 (vector) or 3
  void (*get)(const FieldContext&, int id, double* out);
  std::string symbol = {};  // as drawn: "σ_xx", what follows _ is a subscript; empty: the name
  bool whole = false;       // takes whole numbers only: ids, states, kinds
};

struct Principals {
  double first = 0, second = 0;  // first >= second; tension positive, so the first is the most tensile
  double direction = 0;          // rad, of the first, against +x, in (-pi/2, pi/2]
};
Principals principals(const Vec3& stress);  // of (sxx, syy, sxy)

// sxx, syy, sxy (Pa, global axes) at the block's centroid from the recovery; raw where there is none.
Vec3 smoothed_stress(const FieldContext& context, int block);
std::vector<Vec3> smoothed_stresses(const FieldContext& context);  // of all blocks; a fit each, so not for nothing

std::span<const Field> block_fields();
std::span<const Field> joint_fields();
std::span<const Field> contact_fields();
std::span<const Field> probe_fields();
const Field* find_field(std::span<const Field> fields, const std::string& name);  // null when unknown

}  // namespace talus
