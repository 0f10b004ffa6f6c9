#include "step/restitution.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "equations/block_terms.h"
#include "fracture/cracks.h"
#include "step/energies.h"

namespace talus {

namespace {

constexpr int most_sweeps = 200;     // two contacts of a face take some twenty
constexpr double settled = 1e-12;    // of the fastest parting

// Blocks that bonds hold together, taken as one rigid body: an impulse on one of them alone would only strain its bonds.
struct Body {
  std::vector<int> blocks;
  bool moves = true;
  Vec2 centroid = Vec2::Zero(), velocity = Vec2::Zero();  // m, m/s: means
  double mass = 0, inertia = 0, spin = 0;                 // kg/m, kg m, rad/s
};

struct Opened {
  int i = 0, j = 0;
  Row of_i{}, of_j{};  // speed at which they part, by the blocks' rates
  double most = 0;     // m/s, at which it may part
  double mobility = 0; // m/s, by a unit of impulse
  double impulse = 0;  // N s/m, taken
};

// How blocks part as rigid ones: a block that strains stays on what it has hit until it has rung back, and flies off by that.
Row rigid(const Row& of) {
  Row own{};
  std::copy_n(of.begin(), rigid_dofs, own.begin());
  return own;
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// Of a model whose blocks keep their places and bonds.
class Bodies {
 public:
  explicit Bodies(const Model& model) : model_(model), of_(model.fragment.empty() ? find_fragments(model) : model.fragment) {
    for (const Fragment& fragment : fragments(model)) {
      Body& body = bodies_.emplace_back();
      body.centroid = fragment.centroid;
      body.velocity = fragment.velocity;
    }
    for (size_t b = 0; b < of_.size(); ++b) add(int(b));
    for (const PointFixity& point : model.point_fixities) support(point.block);
    for (const EdgeFixity& edge : model.edge_fixities) support(edge.block);
    for (Body& body : bodies_) body.spin /= body.inertia;
  }
  const Body& of(int block) const { return bodies_[size_t(of_[size_t(block)])]; }

  // m/s, along the row of a block.
  double rate(int block, const Row& row) const {
    const Body& body = of(block);
    return way(row).dot(body.velocity) + body.spin * moment(block, row);
  }
  // m/s by a unit of impulse along it.
  double mobility(int block, const Row& row) const {
    const Body& body = of(block);
    const double turn = moment(block, row);
    return body.moves ? way(row).squaredNorm() / body.mass + turn * turn / body.inertia : 0;
  }
  void push(int block, const Row& row, double impulse) {
    Body& body = bodies_[size_t(of_[size_t(block)])];
    if (!body.moves) return;
    body.velocity += impulse / body.mass * way(row);
    body.spin += impulse * moment(block, row) / body.inertia;
  }

  bool pushed(const Bodies& before, int block) const { return of(block).velocity != before.of(block).velocity || of(block).spin != before.of(block).spin; }

 private:
  static Vec2 way(const Row& row) { return {row[0], row[1]}; }
  double moment(int block, const Row& row) const {
    return cross(model_.blocks[size_t(block)].centroid - of(block).centroid, way(row)) + row[2] * model_.shapes[size_t(block)].length;
  }
  void support(int block) {  // bonded blocks would strain it
    Body& body = bodies_[size_t(of_[size_t(block)])];
    body.moves = body.moves && body.blocks.size() == 1;
  }
  void add(int b) {
    Body& body = bodies_[size_t(of_[size_t(b)])];
    const BlockState& state = model_.blocks[size_t(b)];
    const Vec2 arm = state.centroid - body.centroid;
    const double length = model_.shapes[size_t(b)].length, mass = model_.mass(b),
                 own = length * length * moment_of_inertia(model_, b, state.strain, state.bend);
    body.blocks.push_back(b);
    body.moves = body.moves && model_.shapes[size_t(b)].dofs > 0 && !model_.sleeps(b);
    body.mass += mass;
    body.inertia += own + mass * arm.squaredNorm();
    body.spin += own * state.velocity[2] / length + mass * cross(arm, Vec2(state.velocity[0], state.velocity[1]));
  }

  const Model& model_;
  std::vector<int> of_;
  std::vector<Body> bodies_;
};

double parting(const Bodies& bodies, int i, const Row& of_i, int j, const Row& of_j) {
  return &bodies.of(i) == &bodies.of(j) ? 0 : bodies.rate(i, of_i) + bodies.rate(j, of_j);
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

// What the bodies of opened contacts have changed by. Returns the kinetic energy that it took, J/m.
double move_with(const Bodies& bodies, const Bodies& before, const std::vector<Opened>& opened, Model& model) {
  std::vector<const Body*> pushed;
  for (const Opened& contact : opened) pushed.insert(pushed.end(), {&bodies.of(contact.i), &bodies.of(contact.j)});
  std::sort(pushed.begin(), pushed.end());
  pushed.erase(std::unique(pushed.begin(), pushed.end()), pushed.end());
  double taken = 0;
  for (const Body* body : pushed) {
    const Body& was = before.of(body->blocks[0]);
    const Vec2 faster = body->velocity - was.velocity;
    const double spins = body->spin - was.spin;
    for (const int b : body->blocks) {
      BlockState& state = model.blocks[size_t(b)];
      taken += kinetic_energy(model, b, 0);
      const Vec2 arm = state.centroid - body->centroid;
      state.velocity[0] += faster.x() - spins * arm.y();
      state.velocity[1] += faster.y() + spins * arm.x();
      state.velocity[2] += spins * model.shapes[size_t(b)].length;
      taken -= kinetic_energy(model, b, 0);
    }
  }
  return taken;
}

}  // namespace

Restitution::Restitution(const Model& model, const ContactTerms& contacts) {
  const Bodies bodies(model);
  for (const ContactRows& row : contacts.rows())
    parted_.push_back(parting(bodies, row.i, rigid(row.normal_i), row.j, rigid(row.normal_j)));
}

double Restitution::limit(Model& model, const ContactTerms& contacts, const Scheme& scheme) const {
  const Bodies before(model);
  std::vector<Opened> opened;
  for (size_t k = 0; k < contacts.rows().size(); ++k) {
    const ContactRows& row = contacts.rows()[k];
    Contact& contact = model.contacts[size_t(row.contact)];
    const double part = model.scene.properties[size_t(contact.property)].restitution;
    contact.held_back = false;
    if (part == 1) continue;
    const double parted = parted_[k];
    if (contact.parts && parted < 0) contact.may_part = -1, contact.parts = false;  // it comes back
    if (contact.normal_force > 0) {
      contact.may_part = std::max(contact.may_part, parted < 0 ? -part * parted : contact.may_part < 0 ? parted : 0);
      continue;
    }
    if (contact.may_part < 0) continue;
    Opened own{.i = row.i, .j = row.j, .of_i = rigid(row.normal_i), .of_j = rigid(row.normal_j), .most = contact.may_part};
    const double now = parting(before, own.i, own.of_i, own.j, own.of_j), gap = contact.gap + contact.offset;  // at y = X + ahead v
    contact.parts = contact.parts || now > 0;
    if (scheme.bond_ahead > 0) own.most = std::max(own.most, now - gap / scheme.bond_ahead);
    if (now <= own.most) continue;
    own.mobility = before.mobility(own.i, own.of_i) + before.mobility(own.j, own.of_j);
    if (own.mobility > 0) opened.push_back(own);
  }
  if (opened.empty()) return 0;
  Bodies bodies = before;
  hold_back(bodies, opened);
  for (const ContactRows& row : contacts.rows())
    model.contacts[size_t(row.contact)].held_back = bodies.pushed(before, row.i) || bodies.pushed(before, row.j);
  return move_with(bodies, before, opened, model);
}

}  // namespace talus
