#pragma once
// A frame of results read back: what a .vtp file of a run holds, as plain arrays.
#include <map>
#include <string>
#include <vector>

#include "geometry/vec2.h"

namespace talus {

struct ResultArray {
  std::string name;
  int components = 1;  // 1 or 3
  bool whole = false;
  std::vector<double> values;  // item after item
  double at(std::size_t item, int component = 0) const {
    return values[item * std::size_t(components) + std::size_t(component)];
  }
};

struct ResultFrame {
  double time = 0;           // s
  std::vector<Vec2> points;  // m
  std::vector<int> begin;    // cell c (a block, a line) has the points begin[c] … begin[c + 1] - 1
  std::vector<ResultArray> cells, of_points;
  std::map<std::string, std::vector<std::string>> names;  // "region_names", …
  std::size_t size() const { return begin.size() - 1; }
  const ResultArray* cell(const std::string& name) const;  // null where there is none
  const ResultArray* of_point(const std::string& name) const;
};

// Throws RunError naming the file where it is none that Talus wrote.
ResultFrame read_vtp(const std::string& path);

// zlib's format (RFC 1950), as browsers take it back.
std::string deflated(const std::string& bytes);

}  // namespace talus
