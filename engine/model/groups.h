#pragma once
#include <algorithm>
#include <numeric>
#include <vector>

namespace talus {

// Who of 0…count-1 hangs together: group[k] is the least number that k reaches through pairs (k, m), m < k, for
// which joined(k, m) holds. For the few blocks round a corner.
template <typename Joined>
void find_groups(int count, const Joined& joined, std::vector<int>& group) {
  group.resize(count);
  std::iota(group.begin(), group.end(), 0);
  for (int k = 0; k < count; ++k)
    for (int m = 0; m < k; ++m)
      if (joined(k, m)) {
        const int from = std::max(group[k], group[m]), to = std::min(group[k], group[m]);
        std::replace(group.begin(), group.end(), from, to);
      }
}

}  // namespace talus
