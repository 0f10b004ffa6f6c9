#pragma once
// The outlines of bodies at their corners, by global vertex: of blocks, and of blocks bonded to each other.
#include <cmath>

#include "contact/detection.h"
#include "geometry/vec2.h"
#include "model/model.h"

namespace talus {

// Edges within 3° count as lying along each other (Shi 1988 uses the same bound).
constexpr double parallel_sine = 0.052;
// A corner that stays this near to the plane of a face, in units of the smaller block's √area, with an edge along the
// face, slides on it and does not catch on the face round its end: coplanar blocks pass their load on without a snag.
constexpr double flush_part = 1e-4;
// m, likewise of two blocks at a face of this normal: also what they give way to along it under the stress of either,
// up to passing_tolerance of the smaller's √area. A column that bears a load lies lower than the next that does not
// yet, and is no ledge.
double flush_distance(const Model& model, const Faces& faces, int a, int b, const Vec2& normal);
// No less than that is for any normal; asked first.
double largest_flush_distance(const Model& model, const Faces& faces, int a, int b);
// An outline that turns inwards by so little that what goes by lies under the face beyond by less than this part of the
// smaller block's √area counts as straight: what lies on it is pressed in by as much.
constexpr double level_part = 1e-5;

class Outline {
 public:
  Outline(const Model& model, const Surface& surface) : model_(model), surface_(surface) {}

  const Vec2& place(int corner) const { return model_.vertex[size_t(corner)]; }
  // corner; the number of the edge
  int first(const OutlineEdge& side) const { return model_.shapes[size_t(side.block)].vertex_begin + side.edge; }
  int last(const OutlineEdge& side) const {
    return model_.shapes[size_t(side.block)].vertex_begin + model_.next_vertex(side.block, side.edge);
  }
  const OutlineEdge& leaving(int corner) const { return surface_.leaving[size_t(corner)]; }
  const OutlineEdge& arriving(int corner) const { return surface_.arriving[size_t(corner)]; }
  // m, its directions away from the corner, forwards and backwards.
  Vec2 ahead(int corner) const { return place(last(leaving(corner))) - place(corner); }
  Vec2 behind(int corner) const { return place(first(arriving(corner))) - place(corner); }
  // Sine of the angle by which it turns outwards there.
  double turn(int corner) const {
    const Vec2 d = ahead(corner), b = behind(corner);
    return cross(d, b) / (d.norm() * b.norm());
  }
  // Whether any edge is that the edge with the corners `from` and `to` turns outwards into, or that turns outwards into
  // it, or is part of a side that does so with its side.
  template <typename Is>
  bool any_round_corner(int from, int to, Is is) const {
    const auto goes_on = [this](int corner) {
      return std::abs(turn(corner)) <= parallel_sine && ahead(corner).dot(behind(corner)) < 0;
    };
    const auto any = [&](int corner, const auto& next, const auto& edge) {
      if (turn(corner) > 0 && is(edge(corner))) return true;
      int left = most_parts;
      while (goes_on(corner) && left-- > 0) corner = next(corner);
      if (goes_on(corner) || turn(corner) <= 0) return false;
      do {
        if (is(edge(corner))) return true;
        corner = next(corner);
      } while (goes_on(corner) && left-- > 0);
      return false;
    };
    return any(
               to, [this](int corner) { return last(leaving(corner)); },
               [this](int corner) { return first(leaving(corner)); }) ||
           any(
               from, [this](int corner) { return first(arriving(corner)); },
               [this](int corner) { return first(arriving(corner)); });
  }

 private:
  static constexpr int most_parts = 64;  // of a side as near to its end as a corner can be deep

  const Model& model_;
  const Surface& surface_;
};

}  // namespace talus
