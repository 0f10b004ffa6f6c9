#include "contact/hidden.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/outline.h"

namespace talus {

namespace {

// Contacts of all pairs in order of their corners, by the outlines of bodies.
class Hiding {
 public:
  Hiding(const Model& model, const Surface& surface, const Faces& faces, const std::vector<Contact>& found)
      : model_(model), outline_(model, surface), faces_(faces), found_(found) {}

  // Whether the corner is inside two sides of a body that share a convex corner, but belong to different blocks, and
  // less deep in the other: it rests on the one it entered last. By so much that both blocks, whose corners lie a
  // bond's strain apart, would say so.
  bool deeper_than_beside(const Contact& c) const {
    // Not by what blocks give way to: a wall that is none would be the harder to see the more it presses.
    const double flush = flush_part * std::min(model_.shapes[size_t(c.i)].length, model_.shapes[size_t(c.j)].length);
    if (c.gap >= -flush) return false;
    const auto beside = [&](const Contact& other) {
      return other.gap > c.gap + flush && other.j != c.j &&
             outline_.any_round_corner(c.global_edge, outline_.last({c.j, c.edge}),
                                       [&](int edge) { return edge == other.global_edge; });
    };
    return any_of_corner(c.global_vertex, beside);
  }

  // Whether the corner comes to the end of the edge in a surface on which others carry the body of the one, while that
  // of the other lies under it, as the tip of a piece between joints that come out there: no wall stands above it. A
  // wall of the one that goes on under the surface, as that of a box on whose floor others lie, is one.
  bool under_a_face(const Contact& c) const {
    const Vec2 &at = outline_.place(c.global_vertex), &from = outline_.place(c.global_edge),
               along = outline_.place(outline_.last({c.j, c.edge})) - from;
    const Vec2 rate = model_.velocity_at(c.i, at) - model_.velocity_at(c.j, at);
    // m/s
    const double length = along.norm(), flush = flush_distance(model_, faces_, c.i, c.j, along / length),
                 closing = cross(along, rate) / length;
    // faces that press each other, as of a crack with a kink
    if (c.kind == ContactKind::edge_edge && 2 * c.length > flush) return false;
    // where it comes to the edge's line
    const double s =
        along.dot(at - from) / length + (c.gap > 0 && closing > 0 ? along.dot(rate) / length * c.gap / closing : 0);
    if (s > flush && s < length - flush) return false;
    const int end = s <= flush ? c.global_edge : outline_.last({c.j, c.edge});
    if (outline_.turn(end) < -parallel_sine) return false;  // it ends at a wall of its own
    const auto carried = [&](int above, int below) {
      // the surface is the edge of k, its normal up times outwards
      const auto lies_under = [&](const Contact& k, double up) {
        if (std::abs(k.gap) > flush) return false;
        const Vec2 normal = up * faces_[k.global_edge].normal;
        if (std::abs(normal.dot(along)) < parallel_sine * length ||
            normal.dot(outline_.place(below) - outline_.place(k.global_edge)) >
                flush_distance(model_, faces_, k.i, k.j, normal))
          return false;
        const auto leads = [&](double side, const Vec2& way) {
          return side * normal.dot(way) >= -parallel_sine * way.norm();
        };
        const auto lead = [&](double side, int corner) {
          return leads(side, outline_.ahead(corner)) && leads(side, outline_.behind(corner));
        };
        return lead(1, above) && lead(-1, below);
      };
      const auto third = [&](int block) { return block != c.i && block != c.j; };
      return any_of_corner(above, [&](const Contact& k) { return third(k.j) && lies_under(k, 1); }) ||
             any_on_edge(outline_.first(outline_.leaving(above)),
                         [&](const Contact& k) { return third(k.i) && lies_under(k, -1); }) ||
             any_on_edge(outline_.first(outline_.arriving(above)),
                         [&](const Contact& k) { return third(k.i) && lies_under(k, -1); });
    };
    return carried(c.global_vertex, end) || carried(end, c.global_vertex);
  }

 private:
  template <typename Is>
  bool any_of_corner(int corner, Is is) const {
    auto c = std::lower_bound(found_.begin(), found_.end(), corner,
                              [](const Contact& of, int vertex) { return of.global_vertex < vertex; });
    for (; c != found_.end() && c->global_vertex == corner; ++c)
      if (is(*c)) return true;
    return false;
  }

  template <typename Is>
  bool any_on_edge(int edge, Is is) const {
    if (by_edge_.size() != found_.size()) {
      for (const Contact& c : found_) by_edge_.push_back({c.global_edge, &c});
      std::sort(by_edge_.begin(), by_edge_.end());
    }
    auto c = std::lower_bound(by_edge_.begin(), by_edge_.end(), std::pair<int, const Contact*>(edge, nullptr));
    for (; c != by_edge_.end() && c->first == edge; ++c)
      if (is(*c->second)) return true;
    return false;
  }

  const Model& model_;
  const Outline outline_;
  const Faces& faces_;
  const std::vector<Contact>& found_;
  mutable std::vector<std::pair<int, const Contact*>> by_edge_;  // where it has been asked for
};

}  // namespace

void drop_hidden(const Model& model, const Surface& surface, const Faces& faces, std::vector<Contact>& found) {
  const Hiding hiding(model, surface, faces, found);
  std::vector<char> hidden;
  for (const Contact& c : found) hidden.push_back(hiding.deeper_than_beside(c) || hiding.under_a_face(c));
  size_t at = 0;
  std::erase_if(found, [&](const Contact&) { return hidden[at++] != 0; });
}

}  // namespace talus
