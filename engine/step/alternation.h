#pragma once
// What goes back and forth while equilibrium is looked for: contacts that change their state again and again, for the
// message of a search that does not end.
#include <cstdint>
#include <string>
#include <unordered_map>

#include "model/model.h"

namespace talus {

class Alternation {
 public:
  // After each solve whose displacements were taken.
  void note(const Model& model);
  // "the joint between block 3 … and block 4 … changes between open and pressed, 21 times in 40 solves", of up to
  // three; or nothing where no contact has changed in one solve of four.
  std::string text(const Model& model) const;

 private:
  struct Seen {
    ContactState last = ContactState::open, before = ContactState::open;  // of different states
    int changes = 0;
    int i = 0, j = 0;
    bool joint = false;  // its faces are those of a joint
  };
  std::unordered_map<std::int64_t, Seen> seen_;  // by Contact::key
  int solves_ = 0;
};

}  // namespace talus
