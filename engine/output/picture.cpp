#include <algorithm>
#include <cmath>
#include <filesystem>

#include "output/colour_bar.h"
#include "output/output.h"
#include "output/picture_field.h"
#include "output/picture_marks.h"
#include "output/text.h"

namespace talus {

namespace {

constexpr double title_size = 17, line_size = 13, line_height = 19;  // px
constexpr double room = 18;          // px between the blocks and the frame, at least
constexpr double tallest = 0.72;     // frame height / picture width
constexpr double least_width = 460;  // px, so that titles find room
constexpr double wide_frame = 2.2;   // width / height from which the bar lies below

struct Box {
  Vec2 low = Vec2::Constant(INFINITY), high = Vec2::Constant(-INFINITY);
  void add(const Vec2& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
};

// All blocks, but not farther out than the scene is large: one flying chip must not shrink all the rest.
Box shown_box(const Placement& placement) {
  const Model& model = placement.model();
  Box start, now;
  for (std::size_t b = 0; b < model.shapes.size(); ++b)
    for (int v = model.shapes[b].vertex_begin; v < model.shapes[b].vertex_end; ++v) {
      start.add(model.shapes[b].reference_centroid + model.reference_vertex[v] + model.origin);
      if (placement.vertices()[v].allFinite()) now.add(placement.vertices()[v]);
    }
  const Vec2 reach = Vec2::Constant((start.high - start.low).maxCoeff());
  return {now.low.cwiseMax(start.low - reach), now.high.cwiseMin(start.high + reach)};
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
Layout lay_out(const Placement& placement, const PictureField& field, int width) {
  const Box box = shown_box(placement);
  const Vec2 size = box.high - box.low;
  const double extent = size.maxCoeff(), top = 2 * line_height + title_size + 22;
  Layout out;
  out.metre = extent >= 0.02 && extent < 2e5 ? ShownUnit{1, "m"} : shown_unit("m", extent);
  ColourBar& bar = out.bar;
  bar.scale = colour_scale(field.coloured, field.whole, field.noise);
  const Span& range = bar.scale.range;
  const double largest = bar.scale.flat ? std::abs(range.low + range.high) / 2
                                        : std::max(std::abs(range.low), std::abs(range.high));
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
    const double right = bar.upright ? 22 + bar_margin(bar) + 14 : 24;
    frame.left = left_margin(frame.y, frame.height, false, out.metre) + 8;
    out.arrows = load_arrows(placement, out.px_per_metre);
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
  out.height = bottom + (bar.upright ? 0 : 10 + bar_margin(bar) + 14);
  return out;
}

std::string heading(const Model& model) {
  if (!model.scene.title.empty()) return model.scene.title;
  return model.scene.file.empty() ? "talus" : std::filesystem::path(model.scene.file).stem().string();
}

void draw_titles(Svg& svg, const Model& model, const PictureField& field, double magnification, double width) {
  const std::string title = heading(model);
  const double left = 16, wanted = text_width(title, title_size) * 1.08;
  svg.text({left, 12 + title_size}, title,
           {.size = title_size * std::min(1.0, (width - 2 * left) / wanted), .bold = true});
  svg.text({left, 12 + title_size + line_height}, field.meaning, {.size = line_size, .colour = "#444"});
  const double t_end = model.scene.time.t_end;  // one unit of time all run long
  std::string line = "t = " + quantity(model.time, shown_unit("s", t_end > 0 ? t_end : model.time), 4);
  if (magnification != 1) line += ", displacements × " + significant(magnification, 4);
  const int tension = failed_joints(model, FailureMode::tension), shear = failed_joints(model, FailureMode::shear);
  if (tension > 0) line += ", " + std::to_string(tension) + " failed in tension (black)";
  if (shear > 0) line += ", " + std::to_string(shear) + " in shear (magenta)";
  if (!model.gas_faces.empty()) line += ", faces under gas (orange)";
  svg.text({left, 12 + title_size + 2 * line_height}, line, {.size = line_size, .colour = "#444"});
}

constexpr int held_level = ColourScale::levels, unknown_level = held_level + 1;  // beside those of the map

// Outlines of the blocks, those of one colour in one path.
std::vector<Path> paths_by_level(const Layout& layout, const Placement& placement, const PictureField& field) {
  std::vector<Path> paths(unknown_level + 1);
  const auto& shapes = placement.model().shapes;
  std::vector<Vec2> corners;
  for (std::size_t b = 0; b < shapes.size(); ++b) {
    corners.clear();
    for (int v = shapes[b].vertex_begin; v < shapes[b].vertex_end; ++v)
      corners.push_back(layout.frame.at(placement.vertices()[v]));
    if (std::any_of(corners.begin(), corners.end(), [](const Vec2& p) { return !(p.norm() < 1e6); })) continue;
    const double value = field.values[b];
    const int level = !std::isfinite(value) ? unknown_level : layout.bar.scale.level(value);
    paths[field.grey[b] ? held_level : level].add(corners, true);
  }
  return paths;
}

std::string fill_of(const ColourScale& scale, int level) {
  if (level == held_level) return "#b4b4b4";
  if (level == unknown_level) return "#ff00ff";
  return colour(scale.map, ColourScale::place_of(level));
}

// Thin outlines; without them a stroke of the block's own colour closes the seams between neighbours.
void draw_blocks(Svg& svg, const Layout& layout, const Placement& placement, const PictureField& field,
                 bool edges) {
  double area = 0;
  for (const BlockShape& shape : placement.model().shapes) area += shape.area;
  const double side = std::sqrt(area / static_cast<double>(field.values.size())) * layout.px_per_metre;
  const int tenths = edges ? 1 + static_cast<int>(10 * std::clamp(0.02 * side, 0.15, 0.8)) : 5;
  svg.raw("<g transform=\"scale(.1)\" clip-path=\"url(#frame)\" stroke-linejoin=\"round\" stroke-width=\"" +
          std::to_string(tenths) + "\">\n");
  const std::vector<Path> paths = paths_by_level(layout, placement, field);
  for (int level = 0; level <= unknown_level; ++level) {
    if (paths[level].data().empty()) continue;
    const std::string fill = fill_of(layout.bar.scale, level);
    const std::string stroke = !edges ? fill : dark(fill) ? "#8a8a8a" : "#222";
    svg.raw("<path fill=\"" + fill + "\" stroke=\"" + stroke + "\" d=\"" + paths[level].data() + "\"/>\n");
  }
  svg.raw("</g>\n");
}

// In tenths of a px: what it clips is drawn in them.
std::string clip(const Frame& frame) {
  return "<clipPath id=\"frame\"><rect x=\"" + px(10 * frame.left) + "\" y=\"" + px(10 * frame.top) +
         "\" width=\"" + px(10 * frame.width) + "\" height=\"" + px(10 * frame.height) + "\"/></clipPath>\n";
}

}  // namespace

std::string draw_picture(const FieldContext& context, const PictureOptions& options) {
  const double magnification = options.scale == 0 ? 1 : options.scale;
  const PictureField field = picture_field(context, options.field);
  const Placement placement(context.model, magnification);
  const Layout layout = lay_out(placement, field, options.width);
  Svg svg;
  svg.raw(clip(layout.frame));
  draw_titles(svg, context.model, field, magnification, layout.width);
  draw_blocks(svg, layout, placement, field, options.edges);
  draw_gas(svg, layout.frame, placement);
  draw_failed_joints(svg, layout.frame, placement);
  draw_fixities(svg, layout.frame, placement);
  draw_axes(svg, layout.frame, {.x = "x", .y = "y", .x_unit = layout.metre, .y_unit = layout.metre});
  draw_arrows(svg, layout.frame, layout.arrows);
  draw_bar(svg, layout.bar);
  return svg.file(layout.width, layout.height);
}

}  // namespace talus
