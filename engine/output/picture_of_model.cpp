// The picture of a running model.
#include <filesystem>

#include "output/output.h"
#include "output/scenery.h"

namespace talus {

namespace {

std::string heading(const Model& model) {
  if (!model.scene.title.empty()) return model.scene.title;
  return model.scene.file.empty() ? "talus" : std::filesystem::path(model.scene.file).stem().string();
}

std::string note(const Model& model) {
  std::string text;
  const int tension = failed_joints(model, FailureMode::tension), shear = failed_joints(model, FailureMode::shear);
  if (tension > 0) text += ", " + std::to_string(tension) + " failed in tension (black)";
  if (shear > 0) text += ", " + std::to_string(shear) + " in shear (magenta)";
  if (!model.gas_faces.empty()) text += ", faces under gas (orange)";
  return text;
}

void add_blocks(Scenery& scenery, const Placement& placement) {
  const Model& model = placement.model();
  scenery.low = Vec2::Constant(INFINITY);
  scenery.high = Vec2::Constant(-INFINITY);
  for (const BlockShape& shape : model.shapes) {
    scenery.begin.push_back(static_cast<int>(scenery.corners.size()));
    for (int v = shape.vertex_begin; v < shape.vertex_end; ++v) {
      const Vec2 start = shape.reference_centroid + model.reference_vertex[v] + model.origin;
      scenery.low = scenery.low.cwiseMin(start);
      scenery.high = scenery.high.cwiseMax(start);
      scenery.corners.push_back(placement.vertices()[v]);
    }
  }
  scenery.begin.push_back(static_cast<int>(scenery.corners.size()));
}

}  // namespace

std::string draw_picture(const FieldContext& context, const PictureOptions& options) {
  const Model& model = context.model;
  const double magnification = options.scale == 0 ? 1 : options.scale;
  const Placement placement(model, magnification);
  Scenery scenery;
  scenery.title = heading(model);
  scenery.note = note(model);
  scenery.time = model.time;
  scenery.time_scale = model.scene.time.t_end;
  scenery.magnification = magnification;
  add_blocks(scenery, placement);
  scenery.field = picture_field(context, options.field);
  scenery.lines = {{gas_lines(placement), gas_colour, 4.5},
                   {open_lines(placement, FailureMode::none), real_joint_colour, real_joint_px},
                   {open_lines(placement, FailureMode::shear), shear_crack_colour},
                   {open_lines(placement, FailureMode::tension), tension_crack_colour}};
  scenery.arrows = [&](double px_per_metre) { return load_arrows(placement, px_per_metre); };
  scenery.marks = [&](Svg& svg, const Frame& frame) { draw_fixities(svg, frame, placement); };
  scenery.width = options.width;
  scenery.edges = options.edges;
  return draw_scenery(scenery);
}

}  // namespace talus
