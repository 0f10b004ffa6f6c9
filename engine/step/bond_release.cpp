#include "step/bond_release.h"

#include <algorithm>
#include <cmath>

#include "equations/side.h"
#include "model/crack_path.h"

namespace talus {

namespace {

struct Neighbour {  // of the bond
  StrainMatrix stiffness;
  BlockStrain of_jump, felt;  // by the bond's own jump; of its stress: by all jumps and the initial stress too

  // J/m, of what it stores, as the strain of the bond's jump becomes its own
  double change() const { return of_jump.dot(stiffness * (felt - of_jump / 2)); }
  // J/m, what it stores less without this part of what it feels
  double gives(const BlockStrain& part) const { return part.dot(stiffness * felt) / 2; }
};

Neighbour neighbour(const Model& model, int block, const BlockStrain& of_jump, const BlockStrain& of_jumps,
                    double ahead) {
  if (model.shapes[block].dofs <= rigid_dofs) return {StrainMatrix::Zero(3, 3), of_jump, of_jump};
  const StrainMatrix k = strain_stiffness(model, block);
  const BlockStrain initial = k.ldlt().solve(initial_strain_force(model, block));
  return {k, of_jump, strain_of(model, block, ahead) + of_jumps + initial};
}

// The part z = λ R t of what it feels, with z·K z = z·K e, t the traction of the face; but what presses goes on to.
BlockStrain felt_along(const Model& model, const Joint& joint, int block, const Neighbour& of) {
  BlockStrain along = BlockStrain::Zero(of.felt.size());
  if (model.shapes[block].dofs <= rigid_dofs) return along;
  double pressed = 0;
  const auto each_point = [&](const auto& see) {
    for (const JointPoint& point : joint.points) {
      const auto rows =
          face_rows(model, block, joint.normal, between(block == joint.a ? joint.in_a : joint.in_b, point.at));
      see(rows, point.weight, Vec2(rows * of.felt));
    }
  };
  each_point([&](const auto&, double w, const Vec2& t) { pressed += w / joint.length * t.dot(joint.normal); });
  pressed = std::min(0.0, pressed);
  each_point([&](const auto& rows, double w, const Vec2& t) {
    along += rows.transpose() * (w * (t - pressed * joint.normal));
  });
  along = of.stiffness.ldlt().solve(along);
  const double stiff = along.dot(of.stiffness * along);
  return stiff > 0 ? BlockStrain(along.dot(of.stiffness * of.felt) / stiff * along) : along;
}

}  // namespace

BondRelease::BondRelease(const Model& model, const JointTerms& bonds, const std::vector<int>& due, double ahead)
    : model_(model), bonds_(bonds), ahead_(ahead) {
  for (const int j : due)
    for (const int block : {model.joints[j].a, model.joints[j].b})
      strain_of_jumps_[block].setZero(strain_size(model.shapes[block]));
  for (int j = 0; j < int(model.joints.size()); ++j) {
    const Joint& joint = model.joints[j];
    if (joint.state != JointState::intact) continue;
    const auto a = strain_of_jumps_.find(joint.a), b = strain_of_jumps_.find(joint.b), none = strain_of_jumps_.end();
    if (a == none && b == none) continue;
    const auto [of_a, of_b] = bonds.strain_of_jump(model, j, ahead);
    if (a != none) a->second += of_a;
    if (b != none) b->second += of_b;
  }
}

// With R g the strain of a jump, S that of all jumps of a block, and T = D (ε + S) + σ₀ what it feels, a bond that
// fails gives off ½ k L g² - A R g · D (S - R g / 2). That needs not be above nought where a block is strained more
// than its bonds would let it, all of which are then pressed. What is missing the blocks give up, a part s of what they
// feel along the traction that the face is to lose, or where that is not enough, of all.
std::optional<std::array<BlockStrain, 2>> BondRelease::fail(int j) {
  const Joint& joint = model_.joints[j];
  const auto [of_a, of_b] = bonds_.strain_of_jump(model_, j, ahead_);
  BlockStrain &jumps_a = strain_of_jumps_.at(joint.a), &jumps_b = strain_of_jumps_.at(joint.b);
  const Neighbour a = neighbour(model_, joint.a, of_a, jumps_a, ahead_),
                  b = neighbour(model_, joint.b, of_b, jumps_b, ahead_);
  const double missing = a.change() + b.change() - bonds_.energy_of(model_, j, ahead_);
  std::array<BlockStrain, 2> strains = {of_a, of_b};
  if (missing > 0) {
    BlockStrain from_a = felt_along(model_, joint, joint.a, a), from_b = felt_along(model_, joint, joint.b, b);
    if (missing > a.gives(from_a) + b.gives(from_b)) {
      from_a = a.felt;
      from_b = b.felt;
    }
    const double most = a.gives(from_a) + b.gives(from_b);
    if (missing > most && most > 0 && !is_tracked(model_, joint)) return {};
    const double part = most > 0 ? 1 - std::sqrt(std::max(0.0, 1 - missing / most)) : 0;  // gives 2s - s² of it
    strains[0] -= part * from_a;
    strains[1] -= part * from_b;
  }
  jumps_a -= of_a;
  jumps_b -= of_b;
  return strains;
}

}  // namespace talus
