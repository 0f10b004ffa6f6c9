#include "step/restitution.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include "contact/hand_over.h"
#include "step/bodies.h"
#include "step/energies.h"

namespace talus {

namespace {

constexpr int most_sweeps = 200;   // two contacts of a face take some twenty
constexpr double settled = 1e-12;  // of the fastest parting

struct Opened {
  int i = 0, j = 0;
  Row of_i{}, of_j{};   // speed at which they part, by the blocks' rates
  double most = 0;      // m/s, at which it may part
  double mobility = 0;  // m/s, by a unit of impulse
  double impulse = 0;   // N s/m, taken
};

// How blocks part as rigid ones: a block that strains stays on what it has hit until it has rung back, and flies off by
// that. Where they are now, so that impulses keep angular momentum.
Row parting_row(const Model& model, const Contact& contact, int block) {
  const Vec2 way = (block == contact.i ? 1 : -1) * edge_normal(model, contact);
  return {way.x(), way.y(),
          cross(model.vertex[size_t(contact.global_vertex)] - model.blocks[size_t(block)].centroid, way) /
              model.shapes[size_t(block)].length};
}

// An impulse on one of the blocks that bonds hold together would only strain its bonds: it moves all of them. Of a
// model whose blocks keep their places and bonds.
class Bodies {
 public:
  explicit Bodies(const Model& model)
      : model_(model),
        of_(model.fragment),
        bodies_(bodies_of(model, model.blocks, of_, body_count(of_))),
        blocks_(bodies_.size()),
        moves_(bodies_.size(), true) {
    for (size_t b = 0; b < of_.size(); ++b) {
      blocks_[size_t(of_[b])].push_back(int(b));
      if (model.shapes[b].dofs == 0 || model.sleeps(int(b))) moves_[size_t(of_[b])] = false;
    }
    for (const PointFixity& point : model.point_fixities) support(point.block);
    for (const EdgeFixity& edge : model.edge_fixities) support(edge.block);
  }
  int body(int block) const { return of_[size_t(block)]; }
  const Body& of(int block) const { return bodies_[size_t(body(block))]; }
  const std::vector<int>& blocks(int body) const { return blocks_[size_t(body)]; }

  // m/s, along the row of a block.
  double rate(int block, const Row& row) const {
    return way(row).dot(of(block).velocity) + of(block).spin * moment(block, row);
  }
  // m/s by a unit of impulse along it.
  double mobility(int block, const Row& row) const {
    const double turn = moment(block, row);
    return moves_[size_t(body(block))] ? way(row).squaredNorm() / of(block).mass + turn * turn / of(block).inertia : 0;
  }
  void push(int block, const Row& row, double impulse) {
    if (!moves_[size_t(body(block))]) return;
    Body& body = bodies_[size_t(of_[size_t(block)])];
    body.velocity += impulse / body.mass * way(row);
    body.spin += impulse * moment(block, row) / body.inertia;
  }

 private:
  static Vec2 way(const Row& row) { return {row[0], row[1]}; }
  double moment(int block, const Row& row) const {
    return cross(model_.blocks[size_t(block)].centroid - of(block).centroid, way(row)) +
           row[2] * model_.shapes[size_t(block)].length;
  }
  void support(int block) {  // bonded blocks would strain it
    if (blocks(body(block)).size() > 1) moves_[size_t(body(block))] = false;
  }

  const Model& model_;
  std::vector<int> of_;
  std::vector<Body> bodies_;
  std::vector<std::vector<int>> blocks_;  // of bodies_
  std::vector<bool> moves_;
};

double parting(const Bodies& bodies, int i, const Row& of_i, int j, const Row& of_j) {
  return bodies.body(i) == bodies.body(j) ? 0 : bodies.rate(i, of_i) + bodies.rate(j, of_j);
}

double parting(const Model& model, const Bodies& bodies, const Contact& contact) {
  return parting(bodies, contact.i, parting_row(model, contact, contact.i), contact.j,
                 parting_row(model, contact, contact.j));
}

// Gauss–Seidel over impulses that only hold back.
void hold_back(Bodies& bodies, std::vector<Opened>& opened) {
  double fastest = 0, change = 0;
  for (int sweep = 0; sweep < most_sweeps && (sweep == 0 || change > settled * fastest); ++sweep) {
    change = 0;
    for (Opened& contact : opened) {
      const double over = parting(bodies, contact.i, contact.of_i, contact.j, contact.of_j) - contact.most;
      const double more = std::max(over / contact.mobility, -contact.impulse);
      contact.impulse += more;
      bodies.push(contact.i, contact.of_i, -more);
      bodies.push(contact.j, contact.of_j, -more);
      fastest = std::max(fastest, std::abs(over));
      change = std::max(change, std::abs(more) * contact.mobility);
    }
  }
}

// Moves blocks with the bodies of opened contacts. What that took, J/m, beside what held blocks have `given`. Blocks
// that ring turn with their strains, and a change of spin may give them energy: where all of it together would, nothing
// moves, and the next step is another time.
std::optional<double> move_with(const Bodies& bodies, const Bodies& before, const std::vector<Opened>& opened,
                                double given, Model& model) {
  std::set<int> pushed;
  for (const Opened& contact : opened) pushed.insert({bodies.body(contact.i), bodies.body(contact.j)});
  std::vector<std::pair<int, Rates>> kept;
  double taken = given;
  for (const int body : pushed) {
    const int first = bodies.blocks(body)[0];
    const Body &is = bodies.of(first), &was = before.of(first);
    const double faster = is.spin - was.spin;
    for (const int b : bodies.blocks(body)) {
      BlockState& state = model.blocks[size_t(b)];
      kept.emplace_back(b, state.velocity);
      taken += kinetic_energy(model, b, 0);
      const Vec2 change = is.velocity - was.velocity + faster * perp(Vec2(state.centroid - is.centroid));
      state.velocity[0] += change.x();
      state.velocity[1] += change.y();
      state.velocity[2] += faster * model.shapes[size_t(b)].length;
      taken -= kinetic_energy(model, b, 0);
    }
  }
  if (taken >= 0) return taken;
  for (const auto& [b, velocity] : kept) model.blocks[size_t(b)].velocity = velocity;
  return {};
}

}  // namespace

Restitution::Restitution(const Model& model, const ContactTerms& contacts) {
  const Bodies bodies(model);
  for (const ContactRows& row : contacts.rows())
    parted_.push_back(parting(model, bodies, model.contacts[size_t(row.contact)]));
}

Restitution::Taken Restitution::limit(Model& model, const ContactTerms& contacts, const Scheme& scheme) const {
  const Bodies before(model);
  std::vector<Opened> opened;
  for (size_t k = 0; k < contacts.rows().size(); ++k) {
    const ContactRows& row = contacts.rows()[k];
    Contact& contact = model.contacts[size_t(row.contact)];
    const double part = model.scene.properties[size_t(contact.property)].restitution;
    if (part == 1) continue;
    const double parted = parted_[k];
    if (contact.parts && parted < 0) contact.may_part = -1, contact.parts = false;  // it comes back
    if (contact.normal_force > 0) {
      contact.lifted = 0;
      contact.may_part = std::max(contact.may_part, parted < 0 ? -part * parted : contact.may_part < 0 ? parted : 0);
      continue;
    }
    if (contact.may_part < 0) continue;
    Opened own{
        .i = row.i, .j = row.j, .of_i = parting_row(model, contact, row.i), .of_j = parting_row(model, contact, row.j)};
    // at y = X + ahead v
    const double now = parting(before, own.i, own.of_i, own.j, own.of_j), gap = contact.gap + contact.offset;
    contact.lifted = std::max(0.0, contact.lifted + now - contact.parting);
    own.most = contact.may_part + contact.lifted;
    contact.parts = contact.parts || now > 0;
    if (scheme.bond_ahead > 0) own.most = std::max(own.most, now - gap / scheme.bond_ahead);
    if (now <= own.most) continue;
    own.mobility = before.mobility(own.i, own.of_i) + before.mobility(own.j, own.of_j);
    if (own.mobility > 0) opened.push_back(own);
  }
  const auto keep_parting = [&](const Bodies& of) {
    for (const ContactRows& row : contacts.rows()) {
      Contact& contact = model.contacts[size_t(row.contact)];
      contact.parting = parting(model, of, contact);
    }
  };
  if (opened.empty()) {
    keep_parting(before);
    return {};
  }
  Bodies bodies = before;
  hold_back(bodies, opened);
  Taken taken;
  for (const Opened& contact : opened)
    for (const auto& [block, row] : {std::pair(contact.i, contact.of_i), std::pair(contact.j, contact.of_j)})
      if (model.shapes[size_t(block)].dofs == 0) taken.boundary_work += contact.impulse * bodies.rate(block, row);
  const std::optional<double> moved = move_with(bodies, before, opened, taken.boundary_work, model);
  keep_parting(moved ? bodies : before);
  if (!moved) return {};
  taken.energy = *moved;
  return taken;
}

}  // namespace talus
