#pragma once
#include "model/registry.h"
#include "model/saved_state.h"

namespace talus {

// Puts the model back as it was when this began, unless keep() is called.
class Restored {
 public:
  explicit Restored(Model& model) : model_(model) { visit_state(model_, before_); }
  ~Restored() { back(); }
  Restored(const Restored&) = delete;
  Restored& operator=(const Restored&) = delete;
  void keep() { kept_ = true; }
  void back() {  // now
    if (kept_) return;
    StateReader reader(before_.bytes);
    visit_state(model_, reader);
    model_.place_vertices();
    kept_ = true;
  }

 private:
  Model& model_;
  StateWriter before_;
  bool kept_ = false;
};

}  // namespace talus
