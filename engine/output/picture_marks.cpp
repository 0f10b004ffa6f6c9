#include "output/picture_marks.h"

#include <algorithm>
#include <cmath>

namespace talus {

namespace {

constexpr double point_load_px = 52, edge_load_px = 26;  // length of the largest arrow
constexpr double least_share = 0.35;                     // of that, for the smallest
constexpr double mark_px = 8;                            // height of a fixity's triangle

// Keeps marks apart: a fine mesh has more fixed edges than there is room for triangles.
class Spaced {
 public:
  explicit Spaced(double distance) : distance_(distance) {}
  bool takes(const Vec2& p) {
    const auto near = [&](const Vec2& q) { return (p - q).norm() < distance_; };
    if (std::any_of(taken_.begin(), taken_.end(), near)) return false;
    taken_.push_back(p);
    return true;
  }

 private:
  double distance_;
  std::vector<Vec2> taken_;
};

Vec2 value_at(const std::array<History, 2>& histories, double t) {
  return {histories[0].at(t), histories[1].at(t)};
}

Vec2 outward(const Vec2& from, const Vec2& to) {
  return -perp(to - from).normalized();
}

void scale_lengths(std::vector<Arrow>& arrows, double largest_px) {
  double largest = 0;
  for (const Arrow& arrow : arrows) largest = std::max(largest, arrow.length);
  for (Arrow& arrow : arrows) arrow.length = largest_px * std::max(least_share, arrow.length / largest);
}

std::vector<Arrow> point_arrows(const Placement& placement) {
  const Model& model = placement.model();
  std::vector<Arrow> arrows;
  int last = -1;  // where several blocks share a load it is drawn once
  for (const PointForce& force : model.point_forces) {
    const Vec2 value = value_at(model.scene.point_loads[force.load].force, model.time);
    if (force.load == last || !(value.norm() > 0)) continue;
    last = force.load;
    arrows.push_back({placement.place(force.block, force.in_block), value.normalized(), value.norm(), true,
                      quantity(value.norm(), "N/m")});
  }
  scale_lengths(arrows, point_load_px);
  return arrows;
}

std::vector<Arrow> edge_arrows(const Placement& placement, double px_per_metre) {
  const Model& model = placement.model();
  std::vector<Arrow> arrows;
  Spaced room(22);
  for (const EdgeForce& edge : model.edge_forces) {
    const EdgeLoad& load = model.scene.edge_loads[edge.load];
    const Vec2 from = placement.place(edge.block, edge.in_block[0]), to = placement.place(edge.block, edge.in_block[1]);
    const Vec2 given = value_at(load.traction, model.time), out = outward(from, to);
    const Vec2 value = load.is_pressure ? Vec2(-given.x() * out) : given;
    if (!(value.norm() > 0)) continue;
    const int count = std::max(1, static_cast<int>((to - from).norm() * px_per_metre / 24));
    for (int k = 0; k < count; ++k) {
      const Vec2 at = from + (k + 0.5) / count * (to - from);
      if (room.takes(at * px_per_metre))
        arrows.push_back({at, value.normalized(), value.norm(), value.dot(out) <= 0, ""});
    }
  }
  scale_lengths(arrows, edge_load_px);
  return arrows;
}

// A triangle whose tip touches `tip` and whose foot lies towards `away` (px, y down).
void draw_triangle(Svg& svg, const Vec2& tip, const Vec2& away, bool hollow) {
  const Vec2 foot = tip + mark_px * away, half = 0.6 * mark_px * perp(away);
  const Vec2 corners[] = {tip, foot + half, foot - half};
  svg.polyline(corners, true, hollow ? "fill=\"#fff\" stroke=\"#111\"" : "fill=\"#111\" stroke=\"#111\"");
}

// Where a fixed point's triangle has room: outside the box that the scene starts in, else below the point.
class Sides {
 public:
  explicit Sides(const Model& model) {
    for (std::size_t b = 0; b < model.shapes.size(); ++b)
      for (int v = model.shapes[b].vertex_begin; v < model.shapes[b].vertex_end; ++v) {
        const Vec2 p = model.shapes[b].reference_centroid + model.reference_vertex[v];
        low_ = low_.cwiseMin(p);
        high_ = high_.cwiseMax(p);
      }
  }
  Vec2 away(const Vec2& p) const {
    const double near = 1e-6 * (high_ - low_).maxCoeff();
    if (p.y() - low_.y() < near) return {0, -1};
    if (p.x() - low_.x() < near) return {-1, 0};
    if (high_.x() - p.x() < near) return {1, 0};
    return {0, high_.y() - p.y() < near ? 1. : -1.};
  }

 private:
  Vec2 low_ = Vec2::Constant(INFINITY), high_ = Vec2::Constant(-INFINITY);
};

bool hollow(const Model& model, int fixity) {
  const auto& held = model.scene.fixities[fixity].held;
  return !(held[0] && held[1]);
}

}  // namespace

Placement::Placement(const Model& model, double magnification) : model_(model), magnification_(magnification) {
  vertices_.resize(model.vertex.size());
  for (std::size_t b = 0; b < model.shapes.size(); ++b)
    for (int v = model.shapes[b].vertex_begin; v < model.shapes[b].vertex_end; ++v) {
      const Vec2 start = model.shapes[b].reference_centroid + model.reference_vertex[v];
      vertices_[v] = start + magnification * (model.vertex[v] - start) + model.origin;
    }
}

Vec2 Placement::place(int block, const Vec2& in_block) const {
  const Vec2 start = model_.reference_place(block, in_block);
  return start + magnification_ * (model_.place(block, in_block) - start) + model_.origin;
}

std::vector<Arrow> load_arrows(const Placement& placement, double px_per_metre) {
  std::vector<Arrow> arrows = edge_arrows(placement, px_per_metre);
  const std::vector<Arrow> points = point_arrows(placement);
  arrows.insert(arrows.end(), points.begin(), points.end());
  return arrows;
}

Vec2 far_end(const Arrow& arrow) {
  const Vec2 direction(arrow.direction.x(), -arrow.direction.y());
  return arrow.length * (arrow.tip_at_point ? Vec2(-direction) : direction);
}

int failed_joints(const Model& model, FailureMode mode) {
  return static_cast<int>(std::count_if(model.joints.begin(), model.joints.end(),
                                        [mode](const Joint& joint) { return joint.mode == mode; }));
}

std::vector<Segment> gas_lines(const Placement& placement) {
  std::vector<Segment> lines;
  for (const GasFace& face : placement.model().gas_faces)
    lines.push_back({placement.place(face.block, face.in_block[0]), placement.place(face.block, face.in_block[1])});
  return lines;
}

// Between the two faces; none where these have parted by more than half their length: it would stand in the air.
std::vector<Segment> open_lines(const Placement& placement, FailureMode mode) {
  std::vector<Segment> lines;
  for (const Joint& joint : placement.model().joints) {
    if (joint.state == JointState::intact || joint.mode != mode) continue;
    Segment line, apart;
    for (int k = 0; k < 2; ++k) {
      const Vec2 a = placement.place(joint.a, joint.in_a[k]), b = placement.place(joint.b, joint.in_b[k]);
      line[k] = (a + b) / 2;
      apart[k] = b - a;
    }
    if ((apart[0] + apart[1]).norm() < (line[1] - line[0]).norm()) lines.push_back(line);
  }
  return lines;
}

void draw_fixities(Svg& svg, const Frame& frame, const Placement& placement) {
  const Model& model = placement.model();
  Spaced room(1.7 * mark_px);
  for (const EdgeFixity& fixity : model.edge_fixities) {
    const Vec2 from = frame.at(placement.place(fixity.block, fixity.in_block[0]));
    const Vec2 to = frame.at(placement.place(fixity.block, fixity.in_block[1]));
    const Vec2 normal = Rotation::of(model.blocks[fixity.block].angle).turn(fixity.normal);
    const int count = std::max(1, static_cast<int>((to - from).norm() / (1.8 * mark_px)));
    for (int k = 0; k < count; ++k) {
      const Vec2 at = from + (k + 0.5) / count * (to - from);
      if (room.takes(at)) draw_triangle(svg, at, {normal.x(), -normal.y()}, hollow(model, fixity.fixity));
    }
  }
  const Sides sides(model);
  for (const PointFixity& fixity : model.point_fixities) {
    const Vec2 at = frame.at(placement.place(fixity.block, fixity.in_block));
    const Vec2 away = sides.away(model.reference_place(fixity.block, fixity.in_block));
    if (room.takes(at)) draw_triangle(svg, at, {away.x(), -away.y()}, hollow(model, fixity.fixity));
  }
}

void draw_arrows(Svg& svg, const Frame& frame, const std::vector<Arrow>& arrows) {
  for (const Arrow& arrow : arrows) {
    const Vec2 at = frame.at(arrow.at), end = at + far_end(arrow);
    const Vec2 tip = arrow.tip_at_point ? at : end, tail = arrow.tip_at_point ? end : at;
    const Vec2 back = (tail - tip).normalized();
    const double head = std::min(11.0, 0.45 * arrow.length);
    const Vec2 foot = tip + head * back, half = 0.38 * head * perp(back);
    const Vec2 corners[] = {tip, foot + half, foot - half};
    svg.line(tail, foot, "stroke=\"#c1121f\" stroke-width=\"2\"");
    svg.polyline(corners, true, "fill=\"#c1121f\"");
    if (!arrow.text.empty()) {
      const bool left = back.x() > 0.3 || tail.x() > frame.left + 0.8 * frame.width;
      svg.text(tail + Vec2(left ? -7 : 7, 5), arrow.text,
               {.size = 12, .align = left ? Align::end : Align::start, .colour = "#9b0f19"});
    }
  }
}

}  // namespace talus
