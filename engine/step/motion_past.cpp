#include "step/motion_past.h"

#include <algorithm>
#include <array>
#include <limits>

#include "model/disjoint_sets.h"
#include "step/islands.h"
#include "step/update.h"

namespace talus {

namespace {

struct Group {
  double mass = 0;            // kg/m
  Vec2 moved = Vec2::Zero();  // kg, mass times displacement
  bool stays = false;
  Vec2 mean() const { return stays || mass == 0 ? Vec2(0, 0) : Vec2(moved / mass); }
};

}  // namespace

bool flies_exactly(const Scene& scene, double time) {
  const Numerics& numerics = scene.numerics;
  if (numerics.damping || (numerics.integrator == Integrator::newmark && numerics.dynamic_parameter < 1)) return false;
  const auto steady = [time](const std::array<History, 2>& of) {
    return std::ranges::none_of(of, [time](const History& history) {
      return history.is_function() || history.next_bend(time) < std::numeric_limits<double>::infinity();
    });
  };
  return std::ranges::all_of(scene.point_loads, steady, &PointLoad::force) &&
         std::ranges::all_of(scene.edge_loads, steady, &EdgeLoad::traction) &&
         std::ranges::all_of(scene.regions, steady, &Region::body_force);
}

double motion_past(const Model& model, const std::vector<std::pair<int, int>>& near,
                   const std::vector<BlockState>& moved) {
  DisjointSets sets(model.shapes.size());
  const auto free = [&](int block) { return model.shapes[size_t(block)].dofs > 0; };
  std::vector<char> stays(model.shapes.size(), 0);
  const auto hang_together = [&](int a, int b) {
    if (free(a) && free(b))
      sets.join(a, b);
    else
      stays[size_t(free(a) ? a : b)] = 1;
  };
  for (const auto& [a, b] : near) hang_together(a, b);
  for (const Joint& joint : model.joints)
    if (ties(joint)) hang_together(joint.a, joint.b);
  for (const PointFixity& fixity : model.point_fixities) stays[size_t(fixity.block)] = 1;
  for (const EdgeFixity& fixity : model.edge_fixities) stays[size_t(fixity.block)] = 1;
  for (const ViscousEdge& edge : model.viscous_edges) stays[size_t(edge.block)] = 1;

  std::vector<Group> groups(model.shapes.size());
  for (const int b : model.awake_blocks()) {
    Group& group = groups[size_t(sets.root(b))];
    group.mass += model.mass(b);
    group.moved += model.mass(b) * (moved[size_t(b)].shift - model.blocks[size_t(b)].shift);
    group.stays |= stays[size_t(b)] || !free(b);
  }
  double most = 0;
  for (const int b : model.awake_blocks())
    most = std::max(most, displacement(model, b, moved[size_t(b)], groups[size_t(sets.root(b))].mean()));
  return most;
}

}  // namespace talus
