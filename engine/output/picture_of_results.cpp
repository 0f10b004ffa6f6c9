#include "output/picture_of_results.h"

#include <algorithm>
#include <cmath>

#include "output/colour_bar.h"
#include "output/plot.h"
#include "output/result_fields.h"
#include "output/scenery.h"
#include "output/text.h"
#include "scene/error.h"
#include "script/nearest.h"

namespace talus {

namespace {

// Blocks as drawn, and how far lines between them move with the magnification.
class PlacedBlocks {
 public:
  PlacedBlocks(const ResultFrame& blocks, double scale) : blocks_(blocks), extra_(scale - 1) {
    moved_ = blocks.of_point("displacement");
    if (extra_ != 0 && !moved_) throw RunError("--scale: these results have no displacement of corners");
  }
  Vec2 corner(std::size_t v) const { return blocks_.points[v] + extra_ * moved(v); }
  Vec2 start(std::size_t v) const { return blocks_.points[v] - moved(v); }
  // A point of the line between blocks a and b (from 1) goes with the corners of the two that are nearest to it.
  Vec2 beside(const Vec2& p, int a, int b) const {
    return extra_ == 0 ? p : Vec2(p + extra_ / 2 * (nearest_moved(p, a) + nearest_moved(p, b)));
  }

 private:
  Vec2 moved(std::size_t v) const { return moved_ ? Vec2(moved_->at(v, 0), moved_->at(v, 1)) : Vec2::Zero(); }
  Vec2 nearest_moved(const Vec2& p, int block) const {
    if (block < 1 || std::size_t(block) > blocks_.size()) return Vec2::Zero();
    double least = INFINITY;
    Vec2 out = Vec2::Zero();
    for (int v = blocks_.begin[block - 1]; v < blocks_.begin[block]; ++v) {
      const double far = (blocks_.points[v] - p).squaredNorm();
      if (far < least) least = far, out = moved(std::size_t(v));
    }
    return out;
  }
  const ResultFrame& blocks_;
  double extra_;
  const ResultArray* moved_;
};

std::vector<Segment> segments(const ResultFrame& lines, const PlacedBlocks& placed) {
  const ResultArray *a = lines.cell("block_a"), *b = lines.cell("block_b");
  std::vector<Segment> out;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    Segment& line = out.emplace_back();
    for (const int k : {0, 1})
      line[k] =
          placed.beside(lines.points[std::size_t(lines.begin[i] + k)], a ? int(a->at(i)) : 0, b ? int(b->at(i)) : 0);
  }
  return out;
}

// Cracks by mode, those with gas in them orange beneath; says so in the note.
void add_cracks(Scenery& scenery, const ResultFrame& cracks, const PlacedBlocks& placed) {
  const ResultArray *mode = cracks.cell("mode"), *gas = cracks.cell("gas"), *opening = cracks.cell("opening");
  const std::vector<Segment> all = segments(cracks, placed);
  SceneryLines with_gas = {{}, gas_colour, 4.5}, real = {{}, real_joint_colour, real_joint_px},
               shear = {{}, shear_crack_colour}, tension = {{}, tension_crack_colour};
  int count[3] = {};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const int how = mode ? int(mode->at(i)) : 0;
    if (how == 1 || how == 2) ++count[how];
    if (opening && opening->at(i) > (all[i][1] - all[i][0]).norm() / 2) continue;  // it would stand in the air
    (how == 1 ? tension : how == 2 ? shear : real).lines.push_back(all[i]);
    if (gas && gas->at(i) > 0) with_gas.lines.push_back(all[i]);
  }
  if (count[1] > 0) scenery.note += ", " + std::to_string(count[1]) + " failed in tension (black)";
  if (count[2] > 0) scenery.note += ", " + std::to_string(count[2]) + " in shear (magenta)";
  if (!with_gas.lines.empty()) scenery.note += ", gas in cracks (orange)";
  scenery.lines = {with_gas, real, shear, tension};
}

// Arrows from the middles of blocks, the longest 46 px; of blocks side by side only some.
void add_vectors(Scenery& scenery, const ResultFrame& blocks, const std::string& name) {
  const ResultArray* array = blocks.cell(name);
  if (!array || array->components != 3 || name == "strain") {
    std::vector<std::string> known;
    for (const ResultArray& each : blocks.cells)
      if (each.components == 3 && each.name != "strain") known.push_back(each.name);
    throw InputError({}, "--vectors", "an array of vectors", "\"" + name + "\"" + suggestion(name, known));
  }
  const Field* field = find_field(block_fields(), name);
  std::vector<Arrow> arrows;
  double largest = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Vec2 value(array->at(b, 0), array->at(b, 1));
    if (!value.allFinite() || !(value.norm() > 0)) continue;
    Vec2 middle = Vec2::Zero();
    for (int v = scenery.begin[b]; v < scenery.begin[b + 1]; ++v) middle += scenery.corners[v];
    middle /= scenery.begin[b + 1] - scenery.begin[b];
    arrows.push_back({middle, value.normalized(), value.norm(), false, ""});
    largest = std::max(largest, value.norm());
  }
  if (arrows.empty()) return;
  std::sort(arrows.begin(), arrows.end(), [](const Arrow& a, const Arrow& b) { return a.length > b.length; });
  scenery.note += ", longest arrow " + quantity(largest, field ? field->unit : "");
  scenery.arrows = [arrows, largest](double px_per_metre) {
    constexpr double longest = 46, apart = 20, shortest_shown = 3;  // px
    std::vector<Arrow> shown;
    for (Arrow arrow : arrows) {
      arrow.length *= longest / largest;
      if (arrow.length < shortest_shown) break;
      const auto near = [&](const Arrow& other) { return (other.at - arrow.at).norm() * px_per_metre < apart; };
      if (std::none_of(shown.begin(), shown.end(), near)) shown.push_back(arrow);
    }
    return shown;
  };
}

void add_blocks(Scenery& scenery, const ResultFrame& blocks, const PlacedBlocks& placed) {
  scenery.begin = blocks.begin;
  scenery.low = Vec2::Constant(INFINITY);
  scenery.high = Vec2::Constant(-INFINITY);
  for (std::size_t v = 0; v < blocks.points.size(); ++v) {
    scenery.corners.push_back(placed.corner(v));
    scenery.low = scenery.low.cwiseMin(placed.start(v));
    scenery.high = scenery.high.cwiseMax(placed.start(v));
  }
}

const HistoryColumn& column_named(const std::vector<HistoryColumn>& columns, const std::string& name) {
  std::vector<std::string> known;
  for (const HistoryColumn& column : columns) {
    if (column.name == name || column.name + " [" + column.unit + "]" == name) return column;
    known.push_back(column.name);
  }
  throw InputError({}, "--history", "a column of history.csv", "\"" + name + "\"" + suggestion(name, known));
}

}  // namespace

std::string draw_result(const ResultsFolder& run, std::size_t frame, const ResultPicture& options) {
  const ResultFrame blocks = run.blocks(frame);
  const PlacedBlocks placed(blocks, options.scale);
  Scenery scenery;
  scenery.title = run.title();
  scenery.time = run.times()[frame].first;
  scenery.time_scale = run.times().back().first;
  scenery.magnification = options.scale;
  scenery.range = options.range;
  scenery.width = options.width;
  scenery.edges = options.edges;
  add_blocks(scenery, blocks, placed);
  const ResultField field = result_field(run, frame, blocks, options.field);
  scenery.field = field.picture;
  if (!field.lines.empty()) scenery.coloured_lines = segments(*run.lines(field.lines, frame), placed);
  if (options.cracks && field.lines.empty())
    if (const auto cracks = run.lines("cracks", frame)) add_cracks(scenery, *cracks, placed);
  if (!options.vectors.empty()) add_vectors(scenery, blocks, options.vectors);
  return draw_scenery(scenery);
}

Span range_of(const ResultsFolder& run, const std::vector<std::size_t>& frames, const ResultPicture& options) {
  std::vector<double> values;
  bool whole = false;
  double noise = 0;
  for (const std::size_t frame : frames) {
    const ResultFrame blocks = run.blocks(frame);
    const PictureField field = result_field(run, frame, blocks, options.field).picture;
    values.insert(values.end(), field.coloured.begin(), field.coloured.end());
    whole = field.whole;
    noise = std::max(noise, field.noise);
  }
  return colour_scale(std::move(values), whole, noise).range;
}

std::string draw_history(const ResultsFolder& run, const std::vector<std::string>& names) {
  const std::vector<HistoryColumn> columns = run.history();
  if (columns.empty()) throw RunError(run.dir() + "/history.csv: expected a table, got none");
  Plot plot = {.title = run.title()};
  for (const std::string& name : names) {
    const HistoryColumn& column = column_named(columns, name);
    if (plot.series.empty()) {
      plot.y_unit = column.unit;
    } else if (column.unit != plot.y_unit) {
      throw InputError({}, "--history", "columns of one unit (" + plot.y_unit + ")",
                       "\"" + name + "\" in " + column.unit);
    }
    plot.series.push_back({.name = column.name, .x = columns.front().values, .y = column.values});
  }
  plot.y_label = names.size() == 1 ? plot.series.front().name : "value";
  std::replace(plot.y_label.begin(), plot.y_label.end(), '_', ' ');  // which would begin a subscript
  return draw_plot(plot);
}

}  // namespace talus
