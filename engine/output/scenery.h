#pragma once
// What one picture shows, in the scene's coordinates (m): made of a model while it runs, or of the files of a finished
// run.
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "output/picture_field.h"
#include "output/picture_marks.h"

namespace talus {

struct SceneryLines {
  std::vector<Segment> lines;
  std::string colour;
  double width = 1.6;  // px
};

struct Scenery {
  std::string title, note;                       // note: what follows the time
  double time = 0, time_scale = 0;               // s; the scale gives one unit of time for a whole series
  double magnification = 1;                      // of displacements, already in `corners` and lines
  std::vector<Vec2> corners;                     // of the blocks, one after the other
  std::vector<int> begin;                        // block b: corners begin[b] … begin[b + 1] - 1
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();  // the box that the scene began in
  PictureField field;
  // where the field is one of lines: its values are theirs, and the blocks are pale
  std::vector<Segment> coloured_lines;
  std::vector<SceneryLines> lines;                                // cracks and gas, drawn in this order
  std::function<std::vector<Arrow>(double px_per_metre)> arrows;  // may be empty
  std::function<void(Svg&, const Frame&)> marks;                  // supports; may be empty
  std::optional<Span> range;                                      // of the colours; else from the values
  int width = 1200;                                               // px
  bool edges = true;
};

std::string draw_scenery(const Scenery& scenery);  // an SVG file

}  // namespace talus
