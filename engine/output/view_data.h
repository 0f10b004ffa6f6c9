#pragma once
// The numbers of a page of a finished run, collected frame by frame.
#include <map>
#include <string>
#include <vector>

#include "output/results_folder.h"

namespace talus {

struct ViewArray {
  std::string name, of;  // of "blocks", "joints", "corners"
  int components = 1;    // 1 or 2
  bool whole = false;
  std::vector<float> values;  // frame after frame
};

struct ViewData {
  Vec2 centre = Vec2::Zero();  // m; points are relative to it, so that float32 serves
  std::vector<double> times;   // s
  std::vector<int> begin;      // of the blocks' corners
  std::vector<float> start;    // x, y of each corner before it moved
  // End k of joint j lies on an edge of each of its two blocks: at `along` of the way from corner `edge` to the next of
  // that block.
  std::vector<int> joint_blocks, edge;  // two a joint; four a joint: end 0 on a, on b, end 1 on a, on b
  std::vector<float> along;
  std::vector<ViewArray> arrays;
  std::map<std::string, std::vector<std::string>> names;
  std::size_t joints() const { return joint_blocks.size() / 2; }
};

ViewData view_data(const ResultsFolder& run, const std::vector<std::size_t>& frames,
                   const std::vector<std::string>& fields);

}  // namespace talus
