#include "step/load_step_booking.h"

#include <algorithm>
#include <cmath>

#include "equations/block_terms.h"
#include "equations/boundary_terms.h"
#include "equations/contact_terms.h"

namespace talus {

namespace {

// N, against which a contact that has slid in a load step that drives it began to: its shear force before where its
// limit came down to that, else the limit. `limit`: now.
double began_against(const Model& model, const Contact& c, double limit) {
  if (std::isnan(c.load_normal)) return limit;
  const Strength strength = model.contact_strength(c);
  const double before =
      c.load_normal > 0 ? std::tan(strength.friction) * c.load_normal + strength.cohesion * c.length : 0;
  return std::max(std::abs(c.load_shear), std::min(before, limit));
}

std::vector<Vec2> moved_of(const Model& model, double time) {
  std::vector<Vec2> moved;
  for (const Fixity& fixity : model.scene.fixities) moved.push_back(model.moved(fixity, time));
  return moved;
}

}  // namespace

LoadStepBooking::LoadStepBooking(const Model& model, const Supports& supports, double time, bool unloaded,
                                 const Constants& before)
    : unloaded_(unloaded),
      forces_(forces(model, unloaded ? model.time : time)),  // unloaded: for their places alone
      moved_(moved_of(model, time)) {
  for (const BlockState& state : model.blocks) centroids_.push_back(state.centroid);
  if (before.given()) {
    const WithConstants then(model, before);
    weights_ = weights(then.model);
    reactions_ = support_reactions(then.model, then.supports, time);
    change_.emplace(model, before, moved_);
  } else {
    weights_ = weights(model);
    reactions_ = support_reactions(model, supports, time);
  }
}

std::vector<LoadStepBooking::Force> LoadStepBooking::forces(const Model& model, double time) {
  Poses now;
  now.predict(model, Scheme::equilibrium());
  std::vector<Force> all;
  each_load(model, now, time, [&](int block, const LoadPoint& point, const Vec2& force) {
    if (model.shapes[size_t(block)].dofs > 0) all.push_back({force, point.at});
  });
  for (size_t b = 0; b < model.blocks.size(); ++b)
    if (model.shapes[b].dofs > 0)
      all.push_back(
          {model.shapes[b].area * body_force(model, model.shapes[b].region, 0, time), model.blocks[b].centroid});
  return all;
}

std::vector<Vec2> LoadStepBooking::weights(const Model& model) {
  std::vector<Vec2> all;
  for (int b = 0; b < int(model.blocks.size()); ++b)
    all.push_back(model.shapes[b].dofs > 0 ? Vec2(model.mass(b) * model.gravity()) : Vec2(0, 0));
  return all;
}

void LoadStepBooking::book(Model& model, const Supports& supports, Ledger& ledger) const {
  const std::vector<Force> now = forces(model, model.time);
  const double earlier = unloaded_ ? 0 : 1;
  bool driven = change_.has_value();
  for (size_t k = 0; k < now.size(); ++k) {
    ledger.external_work += (earlier * forces_[k].force + now[k].force).dot(now[k].place - forces_[k].place) / 2;
    driven |= now[k].force != forces_[k].force;
  }
  const std::vector<Vec2> weight = weights(model);
  for (size_t b = 0; b < weight.size(); ++b)
    ledger.gravity_work += (earlier * weights_[b] + weight[b]).dot(model.blocks[b].centroid - centroids_[b]) / 2;
  const std::vector<Vec2> reaction = support_reactions(model, supports, model.time),
                          moved = moved_of(model, model.time);
  for (size_t f = 0; f < reaction.size(); ++f) {
    ledger.boundary_work += (reactions_[f] + reaction[f]).dot(moved[f] - moved_[f]) / 2;
    driven |= moved[f] != moved_[f];
  }
  if (change_) ledger.external_work += change_->work(model, moved);
  book_friction(model, driven, ledger);
  book_climbs(model, ledger);
  ledger.keep_largest();
}

void LoadStepBooking::book_friction(const Model& model, bool driven, Ledger& ledger) const {
  for (const Contact& c : model.contacts) {
    if (c.state != ContactState::open && c.slip != c.load_slip) {
      const double limit = std::abs(c.shear_force), before = unloaded_                  ? 0
                                                             : driven                   ? began_against(model, c, limit)
                                                             : std::isnan(c.load_shear) ? limit
                                                                                        : std::abs(c.load_shear);
      ledger.friction_work += (before + limit) / 2 * std::abs(c.slip - c.load_slip);
    }
  }
}

// What friction is too little to pay for, up a slope that turns back nothing, is lifted after the load step, under the
// mean of the forces before and after: none of a drive's, so that smooth faces stay smooth.
void LoadStepBooking::book_climbs(Model& model, Ledger& ledger) {
  for (Contact& c : model.contacts) {
    if (c.load_climb > 0)
      ledger.numerical_flow -=
          ((std::isnan(c.load_normal) ? c.normal_force : c.load_normal) + c.normal_force) / 2 * c.load_climb;
    const double slid = c.state == ContactState::slip && c.height > 0 ? std::abs(c.slip - c.load_slip) : 0;
    c.load_climb = slid > 0 ? std::clamp(slid * (full_climb(model, c, slid) - std::abs(c.slope)), 0.0, c.height) : 0;
    c.offset -= c.load_climb;
    c.height -= c.load_climb;
    c.load_normal = c.normal_force;
    c.load_shear = c.shear_force;
    c.load_slip = c.slip;
  }
}

}  // namespace talus
