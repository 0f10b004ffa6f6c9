#include "step/restitution.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "equations/block_terms.h"
#include "step/energies.h"

namespace talus {

namespace {

constexpr int most_sweeps = 200;     // two contacts of a face take some twenty
constexpr double settled = 1e-12;    // of the fastest parting

struct Opened {
  int i = 0, j = 0;
  Row of_i{}, of_j{};          // speed at which they part, by the blocks' rates
  Row change_i{}, change_j{};  // rates by a unit of impulse
  double most = 0;             // m/s, at which it may part
  double mobility = 0;         // m/s, by a unit of impulse
  double impulse = 0;          // N s/m, taken
};

// How blocks part as rigid ones: a block that strains stays on what it has hit until it has rung back, and flies off by that.
Row rigid(const Row& of) {
  Row own{};
  std::copy_n(of.begin(), rigid_dofs, own.begin());
  return own;
}

double parting(const Model& model, int i, const Row& of_i, int j, const Row& of_j) {
  const auto rate = [&](int block, const Row& of) {
    return std::inner_product(of.begin(), of.end(), model.blocks[size_t(block)].velocity.begin(), 0.0);
  };
  return rate(i, of_i) + rate(j, of_j);
}

double parting(const Model& model, const Opened& contact) { return parting(model, contact.i, contact.of_i, contact.j, contact.of_j); }

Row by_impulse(const Model& model, int block, const Row& row) {
  Row change{};
  if (model.shapes[size_t(block)].dofs == 0 || model.sleeps(block)) return change;
  with_size(model.shapes[size_t(block)].second_order(), [&](auto n) {
    const auto size = Eigen::Index(model.shapes[size_t(block)].dofs);
    const MatrixOf<n> mass = mass_matrix_of<n>(model, block);
    Eigen::Map<Vector>(change.data(), size) = mass.topLeftCorner(size, size).llt().solve(Eigen::Map<const Vector>(row.data(), size));
  });
  return change;
}

void push(Model& model, int block, const Row& change, double impulse) {
  auto& v = model.blocks[size_t(block)].velocity;
  for (size_t k = 0; k < v.size(); ++k) v[k] += impulse * change[k];
}

// Gauss–Seidel over impulses that only hold back.
void hold_back(Model& model, std::vector<Opened>& opened) {
  double fastest = 0, change = 0;
  for (int sweep = 0; sweep < most_sweeps && (sweep == 0 || change > settled * fastest); ++sweep) {
    change = 0;
    for (Opened& contact : opened) {
      const double over = parting(model, contact) - contact.most;
      const double more = std::max(over / contact.mobility, -contact.impulse);
      contact.impulse += more;
      push(model, contact.i, contact.change_i, -more);
      push(model, contact.j, contact.change_j, -more);
      fastest = std::max(fastest, std::abs(over));
      change = std::max(change, std::abs(more) * contact.mobility);
    }
  }
}

std::vector<int> blocks_of(const std::vector<Opened>& opened) {
  std::vector<int> blocks;
  for (const Opened& contact : opened) blocks.insert(blocks.end(), {contact.i, contact.j});
  std::sort(blocks.begin(), blocks.end());
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  return blocks;
}

}  // namespace

Restitution::Restitution(const Model& model, const ContactTerms& contacts) {
  for (const ContactRows& row : contacts.rows()) parted_.push_back(parting(model, row.i, rigid(row.normal_i), row.j, rigid(row.normal_j)));
}

double Restitution::limit(Model& model, const ContactTerms& contacts, const Scheme& scheme) const {
  std::vector<Opened> opened;
  for (size_t k = 0; k < contacts.rows().size(); ++k) {
    const ContactRows& row = contacts.rows()[k];
    Contact& contact = model.contacts[size_t(row.contact)];
    const double part = model.scene.properties[size_t(contact.property)].restitution;
    if (part == 1) continue;
    const double before = parted_[k];
    if (contact.parts && before < 0) contact.may_part = -1, contact.parts = false;  // it comes back
    if (contact.normal_force > 0) {
      contact.may_part = std::max(contact.may_part, before < 0 ? -part * before : contact.may_part < 0 ? before : 0);
      continue;
    }
    if (contact.may_part < 0) continue;
    Opened own{.i = row.i, .j = row.j, .of_i = rigid(row.normal_i), .of_j = rigid(row.normal_j), .most = contact.may_part};
    const double now = parting(model, own), gap = contact.gap + contact.offset;  // at y = X + ahead v
    contact.parts = contact.parts || now > 0;
    if (scheme.bond_ahead > 0) own.most = std::max(own.most, now - gap / scheme.bond_ahead);
    if (now <= own.most) continue;
    own.change_i = by_impulse(model, row.i, own.of_i);
    own.change_j = by_impulse(model, row.j, own.of_j);
    for (size_t l = 0; l < own.of_i.size(); ++l) own.mobility += own.of_i[l] * own.change_i[l] + own.of_j[l] * own.change_j[l];
    if (own.mobility > 0) opened.push_back(own);
  }
  const std::vector<int> blocks = blocks_of(opened);
  const auto energy = [&] {
    return std::accumulate(blocks.begin(), blocks.end(), 0.0, [&](double sum, int b) { return sum + kinetic_energy(model, b, 0); });
  };
  const double before = energy();
  hold_back(model, opened);
  return before - energy();
}

}  // namespace talus
