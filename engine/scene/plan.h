#pragma once
// Which parts a scene needs. What is absent is not allocated, not called, not written.
#include <string>
#include <utility>
#include <vector>

namespace talus {

class Model;
struct Scene;

struct Plan {
  bool bonds = false, contacts = false, fixities = false, point_loads = false, edge_loads = false, body_forces = false,
       held_blocks = false, recovery = false, dynamic = false, fracture = false, viscous = false, gas = false,
       step_error = false, restitution = false;
  // What the energy ledger can have beside: gravity, work of loads, in static runs of an initial stress, of supports
  // that move, of damping laws.
  bool gravity = false, loads = false, initial_stress = false, moving_supports = false, damping = false;
  // "part: what it does here", in order of the step; printed by `talus plan`, stored in run.json.
  std::vector<std::pair<std::string, std::string>> lines;
};

Plan make_plan(const Model& model);
bool moves_supports(const Scene& scene);
// Whether loads, body forces or supports are others at some times than at others.
bool loads_change(const Scene& scene);
bool loaded_from_start(const Scene& scene);  // by gravity, loads or body forces

}  // namespace talus
