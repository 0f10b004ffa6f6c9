#include "output/colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace talus {

namespace {

using Table = std::array<std::uint32_t, 17>;

// Viridis (van der Walt & Smith 2015, CC0) at 17 even places.
constexpr Table sequential = {0x440154, 0x48186a, 0x472d7b, 0x424086, 0x3b528b, 0x33638d, 0x2c728e, 0x26828e, 0x21918c,
                              0x1fa088, 0x28ae80, 0x3fbc73, 0x5ec962, 0x84d44b, 0xaddc30, 0xd8e219, 0xfde725};

// Hues 262° and 32° of CIELAB, lightness falling evenly from 96 in the middle to 30 and 32 at the ends.
constexpr Table diverging = {0x004b73, 0x005f90, 0x0474ae, 0x3789c4, 0x649ed1, 0x8ab2dc, 0xadc8e5, 0xd0dded, 0xf3f3f3,
                             0xf9d5cf, 0xf8b7ad, 0xf3998d, 0xe97c70, 0xdc5f55, 0xcb413c, 0xb42729, 0x990a1a};

// Hues 0°–360° of lightness 74, chroma 38 (CIELAB).
constexpr Table categories = {0xf79bb7, 0xfa9c9d, 0xf3a286, 0xe3ab76, 0xcdb470, 0xb2bc74, 0x95c283, 0x74c79a, 0x52c9b5,
                              0x33c8cf, 0x33c6e6, 0x58c1f6, 0x84b9fb, 0xaeb0f6, 0xd0a7e7, 0xe99fd1, 0xf79bb7};

const Table& table_of(ColourMap map) {
  return map == ColourMap::sequential ? sequential : map == ColourMap::diverging ? diverging : categories;
}

}  // namespace

std::string colour(ColourMap map, double t) {
  const Table& table = table_of(map);
  const double at = std::clamp(t, 0.0, 1.0) * (table.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), table.size() - 2);
  const double share = at - static_cast<double>(below);
  std::string text = "#";
  for (int shift = 20; shift >= 0; shift -= 4) {
    const int byte = shift / 8 * 8;
    const double low = (table[below] >> byte) & 255, high = (table[below + 1] >> byte) & 255;
    const auto mixed = static_cast<unsigned>(std::lround(low + share * (high - low)));
    text += "0123456789abcdef"[(mixed >> (shift - byte)) & 15];
  }
  return text;
}

bool dark(const std::string& colour, double luma) {
  const unsigned long rgb = std::stoul(colour.substr(1), nullptr, 16);
  // Luma of ITU-R BT.601
  return 0.299 * ((rgb >> 16) & 255) + 0.587 * ((rgb >> 8) & 255) + 0.114 * (rgb & 255) < luma;
}

}  // namespace talus
