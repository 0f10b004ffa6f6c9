#include <algorithm>
#include <cmath>
#include <span>

#include "output/colour_bar.h"
#include "output/scenery.h"
#include "output/text.h"

namespace talus {

namespace {

constexpr double title_size = 17, line_size = 13, line_height = 19;  // px
constexpr double room = 18;                                          // px between the blocks and the frame, at least
constexpr double tallest = 0.72;                                     // frame height / picture width
constexpr double least_width = 460;                                  // px, so that titles find room
constexpr double wide_frame = 2.2;                                   // width / height from which the bar lies below

struct Box {
  Vec2 low = Vec2::Constant(INFINITY), high = Vec2::Constant(-INFINITY);
  bool contains(const Vec2& p) const {
    const double rounding = 1e-6 * (high - low).maxCoeff();
    return (p - low).minCoeff() >= -rounding && (high - p).minCoeff() >= -rounding;
  }
};

// All blocks, but not farther out than the scene is large: one flying chip must not shrink all the rest.
Box shown_box(const Scenery& scenery) {
  Box now;
  for (const Vec2& p : scenery.corners) {
    if (!p.allFinite()) continue;
    now.low = now.low.cwiseMin(p);
    now.high = now.high.cwiseMax(p);
  }
  const Vec2 reach = Vec2::Constant((scenery.high - scenery.low).maxCoeff());
  return {now.low.cwiseMax(scenery.low - reach), now.high.cwiseMin(scenery.high + reach)};
}

struct Layout {
  Frame frame;
  ColourBar bar;
  std::vector<Arrow> arrows;
  ShownUnit metre;
  double width = 0, height = 0, px_per_metre = 1;
};

// Room (px) that arrows need beyond the box: left, right, top, bottom.
std::array<double, 4> arrow_room(const std::vector<Arrow>& arrows, const Box& box, double px_per_metre) {
  std::array<double, 4> out = {room, room, room, room};
  for (const Arrow& arrow : arrows) {
    const Vec2 end = far_end(arrow);
    const Vec2 to_low = (arrow.at - box.low) * px_per_metre, to_high = (box.high - arrow.at) * px_per_metre;
    out[0] = std::max(out[0], -end.x() - to_low.x() + room / 2);
    out[1] = std::max(out[1], end.x() - to_high.x() + room / 2);
    out[2] = std::max(out[2], -end.y() - to_high.y() + room / 2);
    out[3] = std::max(out[3], end.y() - to_low.y() + room / 2);
  }
  return out;
}

// Frame, bar and margins depend on each other through the width of the numbers: two passes settle them.
Layout lay_out(const Scenery& scenery) {
  const PictureField& field = scenery.field;
  const int width = scenery.width;
  const Box box = shown_box(scenery);
  const Vec2 size = box.high - box.low;
  const double extent = size.maxCoeff(), top = 2 * line_height + title_size + 22;
  Layout out;
  out.metre = extent >= 0.02 && extent < 2e5 ? ShownUnit{1, "m"} : shown_unit("m", extent);
  ColourBar& bar = out.bar;
  bar.scale = field.categories ? category_scale()
              : scenery.range  ? given_scale(*scenery.range, field.coloured, field.whole)
                               : colour_scale(field.coloured, field.whole, field.noise);
  const Span& range = bar.scale.range;
  const double largest =
      bar.scale.flat ? std::abs(range.low + range.high) / 2 : std::max(std::abs(range.low), std::abs(range.high));
  bar.unit = field.whole ? ShownUnit{} : shown_unit(field.unit, largest);
  bar.label = label(field.symbol, bar.unit);
  bar.subscripts = field.subscripts;
  bar.upright = size.x() < wide_frame * size.y();
  Frame& frame = out.frame;
  frame = {.left = 60, .top = top, .width = width - 160., .height = width * tallest / 2, .x = {}, .y = {}};
  frame.x = {box.low.x(), box.high.x()};
  frame.y = {box.low.y(), box.high.y()};
  for (int pass = 0; pass < 3; ++pass) {
    bar.length = bar.upright ? std::min(frame.height, 420.) : std::min(0.7 * frame.width, 560.);
    const double right = field.categories ? 24 : bar.upright ? 22 + bar_margin(bar) + 14 : 24;
    frame.left = left_margin(frame.y, frame.height, false, out.metre) + 8;
    if (scenery.arrows) out.arrows = scenery.arrows(out.px_per_metre);
    // on what has flown out of the picture
    std::erase_if(out.arrows, [&](const Arrow& arrow) { return !box.contains(arrow.at); });
    const auto beyond = arrow_room(out.arrows, box, out.px_per_metre);
    const Vec2 rooms(beyond[0] + beyond[1], beyond[2] + beyond[3]);
    out.px_per_metre =
        std::min((width - frame.left - right - rooms.x()) / size.x(), (width * tallest - rooms.y()) / size.y());
    frame.width = size.x() * out.px_per_metre + rooms.x();
    frame.height = size.y() * out.px_per_metre + rooms.y();
    frame.x = {box.low.x() - beyond[0] / out.px_per_metre, box.high.x() + beyond[1] / out.px_per_metre};
    frame.y = {box.low.y() - beyond[3] / out.px_per_metre, box.high.y() + beyond[2] / out.px_per_metre};
    out.width = std::max(least_width, frame.left + frame.width + right);
  }
  const double bottom = frame.top + frame.height + 52;
  if (bar.upright) {
    bar.corner = {frame.left + frame.width + 22, frame.top + (bar.length < frame.height ? 24 : 0)};
    bar.length = std::min(bar.length, frame.height - (bar.corner.y() - frame.top));
  } else {
    bar.corner = {frame.left + (frame.width - bar.length) / 2, bottom + 10};
  }
  out.height = bottom + (bar.upright || field.categories ? 0 : 10 + bar_margin(bar) + 14);
  return out;
}

void draw_titles(Svg& svg, const Scenery& scenery, double width) {
  const double left = 16, wanted = text_width(scenery.title, title_size) * 1.08;
  svg.text({left, 12 + title_size}, scenery.title,
           {.size = title_size * std::min(1.0, (width - 2 * left) / wanted), .bold = true});
  svg.text({left, 12 + title_size + line_height}, scenery.field.meaning, {.size = line_size, .colour = "#444"});
  const double scale = scenery.time_scale > 0 ? scenery.time_scale : scenery.time;  // one unit of time all run long
  std::string line = "t = " + quantity(scenery.time, shown_unit("s", scale), 4);
  if (scenery.magnification != 1) line += ", displacements × " + significant(scenery.magnification, 4);
  svg.text({left, 12 + title_size + 2 * line_height}, line + scenery.note, {.size = line_size, .colour = "#444"});
}

constexpr int held_level = ColourScale::levels, unknown_level = held_level + 1,
              pale_level = unknown_level + 1;  // beside those of the map

bool drawable(std::span<const Vec2> points) {
  return std::all_of(points.begin(), points.end(), [](const Vec2& p) { return p.norm() < 1e6; });
}

int level_of(const Layout& layout, double value) {
  return std::isfinite(value) ? layout.bar.scale.level(value) : unknown_level;
}

// Outlines of the blocks, those of one colour in one path.
std::vector<Path> paths_by_level(const Layout& layout, const Scenery& scenery) {
  std::vector<Path> paths(pale_level + 1);
  std::vector<Vec2> corners;
  for (std::size_t b = 0; b + 1 < scenery.begin.size(); ++b) {
    corners.clear();
    for (int v = scenery.begin[b]; v < scenery.begin[b + 1]; ++v)
      corners.push_back(layout.frame.at(scenery.corners[v]));
    if (!drawable(corners)) continue;
    int level = pale_level;
    if (!scenery.field.of_lines && scenery.field.grey[b])
      level = held_level;
    else if (!scenery.field.of_lines)
      level = level_of(layout, scenery.field.values[b]);
    paths[level].add(corners, true);
  }
  return paths;
}

std::string fill_of(const ColourScale& scale, int level) {
  if (level == held_level) return "#b4b4b4";
  if (level == unknown_level) return "#ff00ff";
  if (level == pale_level) return "#eeeeee";
  return colour(scale.map, ColourScale::place_of(level));
}

// Side of a square of the blocks' mean area, m.
double mean_side(const Scenery& scenery) {
  double area = 0;
  for (std::size_t b = 0; b + 1 < scenery.begin.size(); ++b)
    for (int v = scenery.begin[b]; v < scenery.begin[b + 1]; ++v)
      area += cross(scenery.corners[v], scenery.corners[v + 1 < scenery.begin[b + 1] ? v + 1 : scenery.begin[b]]) / 2;
  return std::sqrt(std::abs(area) / static_cast<double>(scenery.begin.size() - 1));
}

constexpr const char* in_frame = "transform=\"scale(.1)\" clip-path=\"url(#frame)\"";

// Thin outlines; without them a stroke of the block's own colour closes the seams between neighbours.
void draw_blocks(Svg& svg, const Layout& layout, const Scenery& scenery) {
  const double side = mean_side(scenery) * layout.px_per_metre;
  const bool edges = scenery.edges;
  const int tenths = edges ? 1 + static_cast<int>(10 * std::clamp(0.02 * side, 0.15, 0.8)) : 5;
  svg.raw("<g " + std::string(in_frame) + " stroke-linejoin=\"round\" stroke-width=\"" + std::to_string(tenths) +
          "\">\n");
  const std::vector<Path> paths = paths_by_level(layout, scenery);
  for (int level = 0; level <= pale_level; ++level) {
    if (paths[level].data().empty()) continue;
    const std::string fill = fill_of(layout.bar.scale, level);
    const std::string stroke = !edges ? fill : level == pale_level ? "#bbb" : dark(fill) ? "#8a8a8a" : "#222";
    svg.raw("<path fill=\"" + fill + "\" stroke=\"" + stroke + "\" d=\"" + paths[level].data() + "\"/>\n");
  }
  svg.raw("</g>\n");
}

void draw_lines(Svg& svg, const Path& path, const std::string& colour, double width) {
  if (path.data().empty()) return;
  svg.raw("<path " + std::string(in_frame) + " fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"" +
          px(10 * width) + "\" stroke-linecap=\"round\" d=\"" + path.data() + "\"/>\n");
}

void add_line(Path& path, const Layout& layout, const Segment& line) {
  const Vec2 ends[] = {layout.frame.at(line[0]), layout.frame.at(line[1])};
  if (drawable(ends)) path.add(ends, false);
}

void draw_all_lines(Svg& svg, const Layout& layout, const Scenery& scenery) {
  constexpr double coloured_width = 3.2;  // px
  for (const SceneryLines& group : scenery.lines) {
    Path path;
    for (const Segment& line : group.lines) add_line(path, layout, line);
    draw_lines(svg, path, group.colour, group.width);
  }
  std::vector<Path> paths(unknown_level + 1);
  for (std::size_t i = 0; i < scenery.coloured_lines.size(); ++i)
    add_line(paths[level_of(layout, scenery.field.values[i])], layout, scenery.coloured_lines[i]);
  for (int level = 0; level <= unknown_level; ++level)
    draw_lines(svg, paths[level], fill_of(layout.bar.scale, level), coloured_width);
}

// In tenths of a px: what it clips is drawn in them.
std::string clip(const Frame& frame) {
  return "<clipPath id=\"frame\"><rect x=\"" + px(10 * frame.left) + "\" y=\"" + px(10 * frame.top) + "\" width=\"" +
         px(10 * frame.width) + "\" height=\"" + px(10 * frame.height) + "\"/></clipPath>\n";
}

}  // namespace

std::string draw_scenery(const Scenery& scenery) {
  const Layout layout = lay_out(scenery);
  Svg svg;
  svg.raw(clip(layout.frame));
  draw_titles(svg, scenery, layout.width);
  draw_blocks(svg, layout, scenery);
  draw_all_lines(svg, layout, scenery);
  if (scenery.marks) scenery.marks(svg, layout.frame);
  draw_axes(svg, layout.frame, {.x = "x", .y = "y", .x_unit = layout.metre, .y_unit = layout.metre});
  draw_arrows(svg, layout.frame, layout.arrows);
  if (!layout.bar.scale.categories) draw_bar(svg, layout.bar);
  return svg.file(layout.width, layout.height);
}

}  // namespace talus
