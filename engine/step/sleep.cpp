#include "step/sleep.h"

#include <algorithm>

#include "equations/boundary_terms.h"
#include "model/disjoint_sets.h"
#include "model/rates.h"

namespace talus {

namespace {

// What each load, each region's body force and each support asks for in a step, two numbers each.
std::vector<double> read_inputs(const Model& model, const Scheme& scheme) {
  const Scene& scene = model.scene;
  const double time = model.time + scheme.load_time;
  std::vector<double> values;
  const auto add = [&](const std::array<History, 2>& of) {
    values.insert(values.end(), {of[0].at(time), of[1].at(time)});
  };
  for (const PointLoad& load : scene.point_loads) add(load.force);
  for (const EdgeLoad& load : scene.edge_loads) add(load.traction);
  for (const Region& region : scene.regions) add(region.body_force);
  for (const Fixity& fixity : scene.fixities) {
    const Vec2 wanted = fixity.moved(model.time + scheme.dt);
    values.insert(values.end(), {wanted.x(), wanted.y()});
  }
  return values;
}

}  // namespace

void Sleep::wake(Model& model, const Scheme& scheme) {
  model.asleep.resize(model.shapes.size(), 0);
  take_stock(model);
  std::vector<char> woken(model.shapes.size() + 1, 0);  // by group
  wake_loaded(model, scheme, woken);
  if (!sleepers_.empty()) wake_near(model, scheme.dt, woken);
  for (const int group : struck_) woken[size_t(group)] = 1;
  struck_.clear();
  woken[0] = 0;
  if (std::find(woken.begin(), woken.end(), 1) == woken.end()) return;
  for (int& group : model.asleep)
    if (woken[group]) group = 0;
  model.order_contacts();
}

void Sleep::wake_loaded(const Model& model, const Scheme& scheme, std::vector<char>& woken) {
  std::vector<double> now = read_inputs(model, scheme);
  inputs_.resize(now.size());
  const Scene& scene = model.scene;
  const size_t edges = scene.point_loads.size(), regions = edges + scene.edge_loads.size(),
               supports = regions + scene.regions.size();
  const auto other = [&](size_t input) {
    return now[2 * input] != inputs_[2 * input] || now[2 * input + 1] != inputs_[2 * input + 1];
  };
  const auto touch = [&](size_t input, int block) {
    if (other(input)) woken[model.asleep[block]] = 1;
  };
  for (const PointForce& force : model.point_forces) touch(size_t(force.load), force.block);
  for (const EdgeForce& force : model.edge_forces) touch(edges + size_t(force.load), force.block);
  if (std::ranges::any_of(std::views::iota(regions, supports), other))
    for (const int b : sleepers_) touch(regions + size_t(model.shapes[b].region), b);
  for (const PointFixity& point : model.point_fixities) touch(supports + size_t(point.fixity), point.block);
  for (const EdgeFixity& edge : model.edge_fixities) touch(supports + size_t(edge.fixity), edge.block);
  // Another pressure each step, and another volume when the step is over.
  for (const GasFace& face : model.gas_faces) woken[model.asleep[face.block]] = 1;
  inputs_ = std::move(now);
}

template <typename Visit>
void Sleep::each_group_in(const Box& box, const Model& model, Visit visit) const {
  boxes_.each_meeting(box, std::numeric_limits<int>::min(),
                      [&](int k) { visit(model.asleep[size_t(sleepers_[size_t(k)])]); });
}

void Sleep::wake_near(const Model& model, double dt, std::vector<char>& woken) {
  for (const int b : model.awake_blocks()) {
    const bool held = model.shapes[b].dofs == 0;
    const auto own = held ? held_velocity(model, b, dt) : std::array<double, rigid_dofs>{};
    if (held && stands_still(own)) continue;
    each_group_in(swept_box(model, b, held ? std::span<const double>(own) : model.blocks[b].velocity, dt), model,
                  [&](int group) { woken[size_t(group)] = 1; });
  }
}

// By the boxes with which contacts that a step went past are looked for (step/overlooked.h, contact/detection.h):
// without sleep they would be found.
bool Sleep::struck(const Model& model, const std::vector<BlockState>& moved, const Scheme& scheme) {
  if (sleepers_.empty()) return false;
  const double dt = scheme.dt + scheme.bond_ahead;
  for (const int b : model.awake_blocks()) {
    if (stands_still(moved[size_t(b)].velocity)) continue;
    const Box to = swept_box(model, b, moved[size_t(b)].velocity, dt),
              on = swept_box(model, b, model.blocks[size_t(b)].velocity, scheme.dt);
    each_group_in({to.low.cwiseMin(on.low), to.high.cwiseMax(on.high)}, model,
                  [&](int group) { struck_.push_back(group); });
  }
  return !struck_.empty();
}

void Sleep::fall_asleep(Model& model, const IslandSolver& islands, const std::vector<std::pair<int, int>>& near) {
  const int count = int(model.shapes.size());
  DisjointSets sets(model.shapes.size());
  std::vector<char> moves(count, 0);
  for (int b = 0; b < count; ++b)
    if (islands.first(b) >= 0) {
      sets.join(b, islands.first(b));
      moves[b] = islands.rest(b) != Rest::rests;
    }
  for (const auto& [a, b] : near) {
    const bool free_a = model.shapes[a].dofs > 0, free_b = model.shapes[b].dofs > 0;
    if (free_a && free_b) sets.join(a, b);
    if (!free_a && !stands_still(model, a)) moves[b] = 1;
    if (!free_b && !stands_still(model, b)) moves[a] = 1;
  }
  for (const GasFace& face : model.gas_faces) moves[face.block] = 1;
  for (int b = 0; b < count; ++b)
    if (moves[b]) moves[sets.root(b)] = 1;
  bool any = false;
  for (int b = 0; b < count; ++b)
    if (islands.first(b) >= 0 && !moves[sets.root(b)]) {
      model.asleep[b] = sets.root(b) + 1;
      any = true;
    }
  if (any) model.order_contacts();
}

int Sleep::groups(const Model& model) {
  take_stock(model);
  return groups_;
}

const Asleep& Sleep::stored(const Model& model) {
  take_stock(model);
  return stored_;
}

void Sleep::take_stock(const Model& model) {
  if (seen_ == model.sleep_changes) return;
  seen_ = model.sleep_changes;
  sleepers_.clear();
  groups_ = 0;
  std::vector<Box> boxes;
  for (int b = 0; b < int(model.shapes.size()); ++b) {
    if (!model.sleeps(b)) continue;
    sleepers_.push_back(b);
    boxes.push_back(swept_box(model, b, std::array<double, rigid_dofs>{}, 0));
    groups_ += model.asleep[b] == b + 1;  // a group bears the number of its first block
  }
  boxes_.fill(std::move(boxes));
  stored_ = stored_asleep(model);
}

}  // namespace talus
