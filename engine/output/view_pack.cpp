#include "output/view_pack.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include "output/vtk_reader.h"

namespace talus {

namespace {

// Bytes of one weight stand together, the heaviest first: neighbours differ little in it, so that it packs well.
template <class Bits>
std::string packed(std::size_t count, int bytes, Bits bits) {
  std::string planes(count * std::size_t(bytes), '\0');
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t value = bits(i);
    for (int k = 0; k < bytes; ++k) planes[std::size_t(k) * count + i] = static_cast<char>(value >> (24 - 8 * k));
  }
  return base64(deflated(planes));
}

std::uint32_t rounded(float value) {
  constexpr std::uint32_t dropped = 11;  // of float32's 23 bits
  const auto bits = std::bit_cast<std::uint32_t>(value);
  if (!std::isfinite(value)) return bits;
  return (bits + (1u << (dropped - 1))) & ~((1u << dropped) - 1);
}

}  // namespace

std::string packed_floats(const std::vector<float>& values, int bytes) {
  return packed(values.size(), bytes, [&](std::size_t i) {
    return bytes == 4 ? std::bit_cast<std::uint32_t>(values[i]) : rounded(values[i]);
  });
}

std::string packed_whole(const std::vector<int>& values) {
  return packed(values.size(), 4, [&](std::size_t i) { return static_cast<std::uint32_t>(values[i]); });
}

std::string base64(const std::string& bytes) {
  constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? letters[word >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

}  // namespace talus
