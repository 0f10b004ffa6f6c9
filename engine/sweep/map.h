#pragma once
// A value over two parameters, by colour: cells where the two form a grid, discs where they are scattered.
#include <string>
#include <vector>

#include "geometry/vec2.h"

namespace talus {

struct ValueMap {
  std::string title = {}, x_label = {}, y_label = {};
  std::string label = {}, unit = {};  // of the value
  std::vector<Vec2> at = {};
  std::vector<double> values = {};  // as many; not finite: none there
  bool cells = true;
  bool log_x = false, log_y = false;
  int width = 800, height = 500;  // px
};

std::string draw_map(const ValueMap& map);

}  // namespace talus
