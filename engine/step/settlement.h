#pragma once
#include <vector>

#include "fracture/cracks.h"

namespace talus {

// Whether a body has toppled or fallen while equilibrium was looked for: it lies then, but elsewhere than where it was
// asked whether it stands.
class Settlement {
 public:
  explicit Settlement(const Model& model) : before_(fragments(model)) {}  // where the search begins
  // The first block of a body that has turned or gone away since, unless something holds it; or -1.
  int left(const Model& model) const;

 private:
  std::vector<Fragment> before_;
};

}  // namespace talus
