#pragma once
// What an attempt at a step changes before it is known to succeed; put back unless keep() is called.
#include <array>
#include <utility>
#include <vector>

#include "contact/detection.h"
#include "fracture/fracture.h"
#include "model/model.h"
#include "scene/plan.h"
#include "step/ledger.h"

namespace talus {

class Attempt {
 public:
  // `contacts`: where those of what is awake are kept meanwhile, the same memory for every attempt.
  Attempt(Model& model, const Plan& plan, Ledger& ledger, ContactSearch& search, std::vector<Contact>& contacts,
          Fracture* fracture)
      : model_(model), ledger_(ledger), before_(ledger), search_(search), contacts_(contacts), fracture_(fracture) {
    if (plan.contacts) contacts_.assign(model.contacts.begin() + model.sleeping_contacts, model.contacts.end());
    for (const int b : model.held_blocks) held_.emplace_back(b, model.blocks[b].velocity);
    held_rising_ = model.held_rising;
  }
  ~Attempt() {
    if (kept_) return;
    restore_contacts();
    search_.forget_last();
    if (fracture_ && !fracture_->events().empty()) search_.forget_surface();
    if (!blocks_.empty()) {
      model_.blocks = std::move(blocks_);
      model_.vertex = std::move(vertex_);
      model_.support_gaps = std::move(support_gaps_);
      model_.support_speeds = std::move(support_speeds_);
    }
    ledger_ = before_;
    if (fracture_) fracture_->heal();
    for (const auto& [block, velocity] : held_) model_.blocks[block].velocity = velocity;
    model_.held_rising = std::move(held_rising_);
  }
  Attempt(const Attempt&) = delete;
  Attempt& operator=(const Attempt&) = delete;
  void keep() { kept_ = true; }
  void keep_places() {
    blocks_ = model_.blocks;
    vertex_ = model_.vertex;
    support_gaps_ = model_.support_gaps;
    support_speeds_ = model_.support_speeds;
  }
  double ahead_before() const { return before_.ahead; }
  void restore_contacts() {  // those of the step's start
    model_.contacts.resize(size_t(model_.sleeping_contacts));
    model_.contacts.insert(model_.contacts.end(), contacts_.begin(), contacts_.end());
  }

 private:
  Model& model_;
  Ledger& ledger_;
  const Ledger before_;
  ContactSearch& search_;
  std::vector<Contact>& contacts_;
  Fracture* fracture_;
  std::vector<BlockState> blocks_;  // and vertices: before X was moved as the step changed, or empty
  std::vector<Vec2> vertex_, support_gaps_, support_speeds_;
  std::vector<std::pair<int, Rates>> held_;
  std::vector<Vec2> held_rising_;
  bool kept_ = false;
};

}  // namespace talus
