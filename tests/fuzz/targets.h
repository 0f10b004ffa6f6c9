#pragma once
// What is fuzzed: each takes any bytes and must come back, with a message of its own at most.
#include <cstdint>
#include <string>
#include <vector>

namespace talus::fuzz {

struct Target {
  const char* name;
  void (*run)(const std::string& input);  // what it throws, but for what it documents, is a find
  std::vector<std::string> words;         // put into inputs now and then
};
std::vector<Target> readers();         // of files: few parts of the engine
const std::vector<Target>& targets();  // all

// Random numbers by a seed, the same everywhere (SplitMix64).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  std::size_t below(std::size_t n) { return n == 0 ? 0 : std::size_t(next() % n); }
  double unit() { return double(next() >> 11) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

// A scene in Lua, drawn at random: shapes, meshes, joints, loads, gas; some of its values are wrong.
std::string random_scene(std::uint64_t seed);

}  // namespace talus::fuzz
