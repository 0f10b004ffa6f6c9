#include "fracture/crack_tracking.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <unordered_set>

#include "fracture/criterion.h"
#include "model/crack_path.h"

namespace talus {

namespace {

// Stresses around a tip are weighted by exp(-r²/2l²) and cos⁴ of the angle to the direction that is tried: the first
// takes in enough blocks for a mean (some hundred), the second tells directions apart.
constexpr double reach = 2;     // l, in mean lengths of the bonds at the tip
constexpr double farthest = 3;  // in l
constexpr double degree = std::numbers::pi / 180, step = 2 * degree;
// to either side of the last bond: 30 degrees that it may be off the crack, and the 70.5 of mode II
constexpr int most_steps = 50;
// of the highest utilisation at a tip, by tractions, that a bond must have to be chosen
constexpr double least_part = 0.5;
constexpr double same_distance = 1e-6;  // of a bond's length: symmetric bonds beside a path both fail

constexpr int none = -1, several = -2;

int end_at(const Joint& joint, int node) {
  return joint.node[0] == node ? 0 : 1;
}

Vec3 stress_in_place(const Model& model, int block) {  // Pa, in reference axes
  return turn_stress(Rotation::of(-model.blocks[block].angle), model.stress(block));
}

struct Nearby {
  Vec2 towards;  // from the tip, of length 1
  double weight;
  Vec3 stress;  // Pa, in reference axes
};

double across(const Vec3& stress, const Vec2& ahead) {
  return stress[0] * ahead.y() * ahead.y() + stress[1] * ahead.x() * ahead.x() - 2 * stress[2] * ahead.x() * ahead.y();
}

double hoop_stress(const std::vector<Nearby>& nearby, const Vec2& ahead) {
  double sum = 0, weights = 0;
  for (const Nearby& block : nearby) {
    const double cosine = std::max(0.0, block.towards.dot(ahead));
    const double weight = block.weight * cosine * cosine * cosine * cosine;
    weights += weight;
    sum += weight * across(block.stress, ahead);
  }
  return weights > 0 ? sum / weights : 0;
}

// The direction of the highest hoop stress ahead of `along`; none where nothing is pulled.
std::optional<Vec2> highest_hoop_stress(const std::vector<Nearby>& nearby, const Vec2& along) {
  const Vec2 axis = along.normalized();
  const auto turned = [&](double angle) { return Rotation::of(angle).turn(axis); };
  std::vector<double> tried;
  for (int k = -most_steps; k <= most_steps; ++k) tried.push_back(hoop_stress(nearby, turned(k * step)));
  const auto most = std::max_element(tried.begin(), tried.end());
  if (*most <= 0) return {};
  double at = double(most - tried.begin()) - most_steps;
  if (most != tried.begin() && most + 1 != tried.end()) {  // the top of the parabola through three
    const double before = most[-1], after = most[1], bend = 2 * *most - before - after;
    if (bend > 0) at += (after - before) / (2 * bend);
  }
  return turned(at * step);
}

}  // namespace

CrackTracking::CrackTracking(Model& model, const std::vector<std::vector<int>>& bonds_at_node)
    : model_(model), bonds_at_node_(bonds_at_node), bonds_of_block_(model.shapes.size()) {
  for (std::size_t j = 0; j < model.joints.size(); ++j)
    for (const int block : {model.joints[j].a, model.joints[j].b}) bonds_of_block_[block].push_back(int(j));
}

void CrackTracking::judge() {
  const std::vector<int> last = last_bonds();
  for (int node = 0; node < int(last.size()); ++node) {
    if (last[node] < 0) continue;
    const Tip at = tip(node, last[node]);
    for (const Way& way : at.ways) {
      Joint& joint = model_.joints[way.joint];
      const Vec3 beside = (stress_in_place(model_, joint.a) + stress_in_place(model_, joint.b)) / 2;
      const double pull = std::max(at.hoop_stress, across(beside, at.ahead));
      joint.utilisation = std::max(joint.utilisation, utilisation(model_, joint, {pull, 0}));
    }
  }
}

std::vector<int> CrackTracking::lead(const std::vector<int>& due) {
  const std::vector<int> last = last_bonds();
  std::vector<int> chosen;
  for (const int j : due) lead(j, last, chosen);
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

// Per node, the one failed bond, or joint that never was one, that ends there.
std::vector<int> CrackTracking::last_bonds() const {
  std::vector<int> last(model_.nodes.position.size(), none);
  for (std::size_t j = 0; j < model_.joints.size(); ++j)
    if (model_.joints[j].state == JointState::failed)
      for (const int node : model_.joints[j].node) last[node] = last[node] == none ? int(j) : several;
  return last;
}

// A bond that is due joins two cracks, or fails in shear, as it would without a path.
void CrackTracking::lead(int due, const std::vector<int>& last, std::vector<int>& chosen) {
  const Joint& first = model_.joints[due];
  const bool at_tip[] = {last[first.node[0]] >= 0, last[first.node[1]] >= 0};
  const bool in_shear = failure_mode(model_, first, mean_traction(first)) == FailureMode::shear &&
                        utilisation(model_, first) >= first.utilisation;
  chosen.push_back(due);
  if (at_tip[0] == at_tip[1] || in_shear) return;
  const int node = first.node[at_tip[0] ? 0 : 1];
  const Tip tip = this->tip(node, last[node]);
  const auto serves = [&](const Way& way) {
    const Joint& joint = model_.joints[way.joint];
    return joint.property == first.property && joint.trace == first.trace;
  };
  if (tip.ways.empty() || !std::all_of(tip.ways.begin(), tip.ways.end(), serves)) return;
  chosen.pop_back();
  for (const Way& way : tip.ways) {
    Joint& joint = model_.joints[way.joint];
    chosen.push_back(way.joint);
    joint.off_path = way.off;
    const Vec2 normal = perp(tip.ahead);  // either way: a turn of less than 90 degrees
    joint.path_turn = std::atan(cross(joint.normal, normal) / joint.normal.dot(normal));
  }
}

CrackTracking::Tip CrackTracking::tip(int node, int last) const {
  const Joint& joint = model_.joints[last];
  const Vec2 at = model_.nodes.position[node];
  double length = 0;  // m, l
  for (const int j : bonds_at_node_[node])
    length += reach * model_.joints[j].length / double(bonds_at_node_[node].size());

  // Blocks that intact bonds join, without a way around what is farther.
  std::vector<int> found;
  std::unordered_set<int> seen;
  std::vector<Nearby> nearby;
  const auto visit = [&](int block) {
    const Vec2 way = model_.shapes[block].reference_centroid - at;
    const double distance = way.norm();
    if (distance > farthest * length || !seen.insert(block).second) return;
    found.push_back(block);
    nearby.push_back({way / distance,
                      model_.shapes[block].area * std::exp(-distance * distance / (2 * length * length)),
                      stress_in_place(model_, block)});
  };
  for (const int j : bonds_at_node_[node])
    for (const int block : {model_.joints[j].a, model_.joints[j].b}) visit(block);
  for (std::size_t k = 0; k < found.size(); ++k)
    for (const int j : bonds_of_block_[found[k]])
      if (model_.joints[j].state == JointState::intact)
        for (const int block : {model_.joints[j].a, model_.joints[j].b}) visit(block);

  const std::optional<Vec2> ahead =
      highest_hoop_stress(nearby, at - model_.nodes.position[joint.node[1 - end_at(joint, node)]]);
  if (!ahead) return {};
  return {*ahead, hoop_stress(nearby, *ahead), ways(node, at + joint.off_path, *ahead)};
}

std::vector<CrackTracking::Way> CrackTracking::ways(int node, const Vec2& path, const Vec2& ahead) const {
  struct End {
    Way way;
    double across;
  };
  double most = 0;
  for (const int j : bonds_at_node_[node])
    if (model_.joints[j].state == JointState::intact) most = std::max(most, utilisation(model_, model_.joints[j]));
  std::vector<End> ends;
  double nearest = 0;
  for (const int j : bonds_at_node_[node]) {
    const Joint& joint = model_.joints[j];
    if (joint.state != JointState::intact || !is_tracked(model_, joint)) continue;
    const Vec2 way = model_.nodes.position[joint.node[1 - end_at(joint, node)]] - path;
    const double gone = way.dot(ahead), across = std::abs(cross(ahead, way));
    if (gone <= 0 || utilisation(model_, joint) < least_part * most) continue;
    if (ends.empty() || across < nearest) nearest = across;
    ends.push_back({{j, gone * ahead - way}, across});
  }
  std::vector<Way> found;
  for (const End& end : ends)
    if (end.across <= nearest + same_distance * model_.joints[end.way.joint].length) found.push_back(end.way);
  return found;
}

}  // namespace talus
