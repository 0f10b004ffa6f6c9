#pragma once
#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace talus {

// Who of 0…count-1 hangs together, pair by pair: a set is named by its least member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int root(int k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }
  void join(int a, int b) {
    const auto [low, high] = std::minmax({root(a), root(b)});
    parent_[high] = low;
  }

 private:
  std::vector<int> parent_;
};

// Sets by their members 0, 1, … in order of first appearance; what is in none keeps -1.
inline std::vector<int> counted(std::vector<int> set) {
  std::vector<int> number(set.size(), -1);
  int next = 0;
  for (int& s : set) {
    if (s < 0) continue;
    if (number[std::size_t(s)] < 0) number[std::size_t(s)] = next++;
    s = number[std::size_t(s)];
  }
  return set;
}

}  // namespace talus
