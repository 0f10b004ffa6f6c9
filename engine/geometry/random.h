#pragma once
// splitmix64 (Steele, Lea & Flood 2014): defined to the bit, so that a seed gives the same scene on every machine,
// which std::uniform_real_distribution does not promise.
#include <cstdint>

namespace talus {

class Random {
 public:
  explicit Random(std::uint64_t state) : state_(state) {}
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }  // [0, 1)
  double symmetric() { return 2 * unit() - 1; }                          // [-1, 1)

 private:
  std::uint64_t state_;
};

}  // namespace talus
