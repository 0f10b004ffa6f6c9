#include "contact/narrow_phase.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "contact/near_pair.h"
#include "contact/way_out.h"

namespace talus {

namespace {

// A contact that is less deep than this part of what blocks lie in each other does not stand for that.
constexpr double known_part = 0.5;

struct Candidate {
  int edge;
  double gap;
  bool on;  // or next to its end: it counts only beside others
};

enum class End { first, last };

// Place along an edge of a vertex that is at `s` now and goes `way`: where it comes to the edge's line from outside, if
// it does.
double place_met(const Face& edge, double gap, double s, const Vec2& way) {
  const double ahead = gap + edge.normal.dot(way);
  return gap > 0 && ahead < 0 ? s + edge.along.dot(way) * gap / (gap - ahead) : s;
}

// Where a vertex is inside two sides that share a convex corner it rests on the one it entered last; where these are
// parts of one side, on one of them, be it next to its end: the one that its own side lies on, as of a joint, and if
// that does on both, the one that it was on before.
void drop_deeper(const NearPair& pair, int vertex_block, int vertex, int block, std::vector<Candidate>& candidates) {
  if (candidates.size() < 2) {
    std::erase_if(candidates, [](const Candidate& c) { return !c.on; });
    return;
  }
  const auto lies = [&](const Candidate& c) {
    return pair.overlap(vertex_block, vertex, pair.edge(block, c.edge), 0, 0) > pair.meeting();
  };
  const auto loaded = [&](const Candidate& c) { return pair.loaded_before(vertex_block, vertex, block, c.edge); };
  const auto shallower = [](const Candidate& a, const Candidate& b) {
    return a.gap > b.gap || (a.gap == b.gap && a.edge < b.edge);
  };
  const auto better = [&](const Candidate& a, const Candidate& b) {
    if (lies(a) != lies(b)) return lies(a);
    if (loaded(a) != loaded(b)) return loaded(a);
    return a.on == b.on ? shallower(a, b) : a.on;
  };
  std::vector<Candidate> kept;
  for (const Candidate& c : candidates) {
    bool dropped = false, on = c.on;
    for (const Candidate& other : candidates) {
      if (other.edge == c.edge) continue;
      const bool follows = pair.next(block, c.edge) == other.edge, leads = pair.next(block, other.edge) == c.edge;
      if ((follows || leads) && pair.straight(block, follows ? other.edge : c.edge)) {
        dropped = dropped || better(other, c);
        on = on || other.on;
      } else if (c.gap < 0 && shallower(other, c)) {
        dropped = dropped || pair.turns_into(block, c.edge, other.edge) || pair.turns_into(block, other.edge, c.edge);
      }
    }
    if (!dropped && on) kept.push_back(c);
  }
  candidates = std::move(kept);
}

// Vertices of block `bv` on edges of block `be`.
void vertices_on_edges(const NearPair& pair, const Model& model, int bv, int be, std::vector<Contact>& found) {
  std::vector<Candidate> candidates;
  const double out_of_reach = pair.out_of_reach(be);
  for (int v = 0; v < model.vertex_count(bv); ++v) {
    if (!pair.exposed(bv, v)) continue;
    const Vec2 p = pair.vertex(bv, v);
    std::optional<Vec2> way;  // where it is needed
    candidates.clear();
    for (int e = 0; e < model.vertex_count(be); ++e) {
      if (!pair.free(be, e)) continue;
      const Face& edge = pair.edge(be, e);
      const double gap = edge.gap(p);
      if (gap > out_of_reach) break;
      if (gap > pair.reach() || gap < pair.deepest()) continue;
      const double at = edge.position(p);
      const auto met = [&] {
        if (gap <= 0) return at;
        if (!way) way = pair.way(bv, v, be);
        return place_met(edge, gap, at, *way);
      };
      const double s = pair.fast() ? met() : at;
      const auto still_on = [&] {
        const double turned = 2 * pair.aslant(bv, v, edge.normal) * -gap;
        return pair.within(be, e, s, edge.length, pair.slack(edge.length, -gap) + turned) &&
               pair.loaded_before(bv, v, be, e);
      };
      const bool on = pair.within(be, e, s, edge.length) || (gap < 0 && still_on());
      if (!on && (!pair.flush(edge.normal, gap) || !pair.within(be, e, s, edge.length, pair.meeting()))) continue;
      if (gap < -pair.meeting() && pair.behind(be, e, edge, p)) continue;
      if ((gap > 0 || pair.flush(edge.normal, gap)) &&
          pair.passes_flush(bv, v, be, e, pair.fast() ? s : met(), edge.length))
        continue;
      if (pair.can_rest(bv, v, edge.normal) || (gap > 0 && pair.will_rest(bv, v, edge.normal)))
        candidates.push_back({e, gap, on});
    }
    drop_deeper(pair, bv, v, be, candidates);
    for (const Candidate& c : candidates) found.push_back(pair.contact(bv, v, be, c.edge, c.gap, false));
  }
}

// The line of an edge at one of two corners, which the other corner can rest on.
struct Choice {
  int block_v, vertex, block_e, edge;
  double gap, ahead;   // m, now and where contacts are judged
  double from, until;  // parts of the way there between which the line keeps the corners apart; 2: to the end
  double beyond;       // m, from the edge's nearer end, outside it
  bool left;           // the corner is past the edge's end, and goes away from it: it cannot come to press there
};

// Of lines that separate two corners, the one that is penetrated last: what keeps them apart from now on the longest,
// or one that does before that ends, and to the end. `noise`: m, of places. What differs by that alone, as a corner on
// a face and the other corner on a face that is parallel to it, goes by the order of the choices, and so in a mirrored
// scene as in the scene.
Choice penetrated_last(std::vector<Choice>& choices, double rounding, double noise) {
  const auto farther = [&](const Choice& a, const Choice& b) {
    if (std::abs(a.ahead - b.ahead) > rounding) return a.ahead < b.ahead;
    return a.beyond > b.beyond + noise;
  };
  const auto sooner = [&](const Choice& a, const Choice& b) {
    return std::abs(a.until - b.until) > corner_part ? a.until < b.until : farther(a, b);
  };
  const auto begin = choices.begin(), end = choices.end();
  const auto later = std::partition(begin, end, [](const Choice& c) { return c.from == 0; });
  const auto now = std::max_element(begin, later, sooner), then = std::max_element(later, end, farther);
  if (begin == later) return *then;
  return then != end && then->from <= now->until && now->until < then->until ? *then : *now;
}

// Corner `v` of i near corner `w` of j: one contact at most, unless edges lie along each other. Two convex corners are
// apart while any of the lines that one of them can rest on still separates them, so of all choices that one counts
// which is penetrated last (Shi 1988, entrance line), by this step's velocities: where corners coincide, as
// all do round a node of a mesh, the gaps themselves tell nothing, and any other choice would bar a way that is free.
void corner_on_corner(const NearPair& pair, int v, int w, size_t first, std::vector<Contact>& found,
                      std::vector<MeetingCorners>& meeting) {
  const int i = pair.i(), j = pair.j();
  const double distance = (pair.vertex(i, v) - pair.vertex(j, w)).norm();
  if (distance > pair.reach()) return;
  if (pair.inner(i, v) || pair.inner(j, w)) return;  // two faces, each met by itself
  // edges before the corners; those after bear its number
  const int w0 = pair.previous(j, w), v0 = pair.previous(i, v);
  if (distance <= pair.meeting()) meeting.push_back({i, pair.global(i, v), j, pair.global(j, w)});
  if (pair.valley(i, v) || pair.valley(j, w) || pair.straight(i, v) || pair.straight(j, w)) return;
  const auto is_here = [&](const Contact& c) {
    return (c.i == i && c.vertex == v && c.j == j && (c.edge == w || c.edge == w0)) ||
           (c.i == j && c.vertex == w && c.j == i && (c.edge == v || c.edge == v0));
  };
  for (size_t c = first; c < found.size(); ++c)
    if (is_here(found[c]) && found[c].kind == ContactKind::edge_edge) return;
  std::vector<Choice> choices;
  // Keeps above the face, and farther than what passes flush with it.
  const auto clear = [&](const Face& face, double gap, double ahead) {
    return std::min(gap, ahead) > 0 && !pair.flush(face.normal, std::min(gap, ahead));
  };
  // `end`: of the edge, at which the corners are to meet.
  const auto consider = [&](int bv, int vertex, int be, int e, End end) {
    if (!pair.free(be, e)) return;
    const Face& edge = pair.edge(be, e);
    if (!pair.can_rest(bv, vertex, edge.normal)) return;
    const Vec2 p = pair.vertex(bv, vertex), way = pair.way(bv, vertex, be);
    const double gap = edge.gap(p), ahead = gap + edge.normal.dot(way), s = edge.position(p),
                 met = place_met(edge, gap, s, way);
    if (gap < -pair.meeting() && pair.behind(be, e, edge, p)) return;
    if (!clear(edge, gap, ahead) && (gap > 0 || pair.flush(edge.normal, gap)) &&
        pair.passes_flush(bv, vertex, be, e, met, edge.length))
      return;
    // Where it comes to the line there is no edge: nothing is met there, and nothing kept apart. Beyond the other end
    // that is for the corner there to say.
    const double past = end == End::first ? -met : met - edge.length;
    const double back = edge.along.dot(way) * (end == End::first ? 1 : -1);
    const auto comes_on = [&] { return past < back && pair.slides_on(bv, vertex, be, e); };
    if (ahead < 0 && past > pair.beside() && !comes_on()) return;
    if (ahead < 0 && past < -edge.length && !pair.within(be, e, met, edge.length)) return;
    const double apart = std::max(0.0, gap - pair.meeting()), until = ahead < 0 ? apart / (apart - ahead) : 2;
    choices.push_back({bv, vertex, be, e, gap, ahead, 0, until, std::max({0.0, -s, s - edge.length}),
                       past > pair.beside() && back < 0});
  };
  consider(i, v, j, w, End::first);
  consider(i, v, j, w0, End::last);
  consider(j, w, i, v, End::first);
  consider(j, w, i, v0, End::last);
  found.erase(std::remove_if(found.begin() + long(first), found.end(), is_here), found.end());
  if (choices.empty()) return;
  const auto flush = [&](const Choice& c) { return pair.slides_on(c.block_v, c.vertex, c.block_e, c.edge); };
  // Flush with a side that ends before the corner comes by, as it goes off a step down past it, is not what keeps it
  // apart.
  const auto parts = [&](const Choice& c) { return !flush(c) && clear(pair.edge(c.block_e, c.edge), c.gap, c.ahead); };
  if (std::any_of(choices.begin(), choices.end(), flush) && std::none_of(choices.begin(), choices.end(), parts)) {
    std::erase_if(choices, [&](const Choice& c) { return !flush(c); });
    // Flush with two faces: blocks that meet in one point across a crossing of joints. They press once one has moved.
    const Vec2 along = pair.edge(choices[0].block_e, choices[0].edge).along;
    for (const Choice& c : choices)
      if (std::abs(cross(along, pair.edge(c.block_e, c.edge).along)) > parallel_sine) return;
  }
  // Corners in one place may be under each other's lines by as much; others only as deep as they press.
  double pressed = pair.meeting();
  if (distance > pair.meeting())
    for (const Choice& c : choices) pressed = std::min(pressed, std::max(0.0, -c.gap) + corner_part * pair.least());
  for (Choice& c : choices)
    if (const double under = -c.gap - pressed; under > 0) c.from = under / (under + std::max(0.0, c.ahead));
  const Choice best = penetrated_last(choices, corner_part * pair.least(), pair.noise(v));
  if (best.left && best.ahead >= 0) return;
  if (best.gap > pair.reach() || best.gap < pair.deepest()) return;
  found.push_back(pair.contact(best.block_v, best.vertex, best.block_e, best.edge, best.gap, true));
}

// Corners that coincide along a face, however deep they press, give the same contact twice, once from each block: the
// second is dropped, or the one that was not loaded before. Else the two would share a load, half of which is lost
// where one of them goes; and where they took turns, as shear moves from the one corner to the other by how deep they
// press, there would be no equilibrium. Where a side goes straight on, that is no corner to come off at: then they need
// not be as near, and a corner is kept before it.
void drop_twins(const NearPair& pair, size_t first, std::vector<Contact>& found) {
  const auto turns = [&pair](const Contact& c) { return !pair.straight(c.i, c.vertex); };
  const auto loaded = [&pair](const Contact& c) {  // also on the next part of a side that goes straight on
    const auto on = [&](int e) { return pair.loaded_before(c.i, c.vertex, c.j, e); };
    const int end = pair.next(c.j, c.edge);
    return on(c.edge) || (pair.straight(c.j, c.edge) && on(pair.previous(c.j, c.edge))) ||
           (pair.straight(c.j, end) && on(end));
  };
  const auto twins = [&](const Contact& a, const Contact& b) {
    if (b.i != a.j) return false;
    const Face &face = pair.edge(a.j, a.edge), &facing = pair.edge(b.j, b.edge);
    const Vec2 apart = pair.vertex(b.i, b.vertex) - pair.vertex(a.i, a.vertex);
    const double deep = std::abs(face.normal.dot(apart)), aslant = std::abs(cross(face.along, facing.along));
    const double near = turns(a) && turns(b)
                            ? 2 * pair.slack(std::max(face.length, facing.length), deep) + aslant * deep
                            : pair.meeting();
    return std::abs(face.along.dot(apart)) <= near && deep <= -pair.deepest() && face.normal.dot(facing.normal) < -0.99;
  };
  for (size_t c = first; c < found.size(); ++c)
    for (size_t other = c + 1; other < found.size();) {
      if (!twins(found[c], found[other])) {
        ++other;
        continue;
      }
      const bool later =
          turns(found[c]) == turns(found[other]) ? loaded(found[other]) && !loaded(found[c]) : turns(found[other]);
      if (later) found[c] = found[other];
      found.erase(found.begin() + long(other));
    }
}

// Where blocks lie in each other and none of these contacts is as deep, as with thin tips that have gone through each
// other, they stand by the face that is to be left by the shortest way.
void least_deep(const NearPair& pair, const Model& model, size_t first, std::vector<Contact>& found) {
  const std::array blocks{pair.i(), pair.j()}, corners{model.vertex_count(blocks[0]), model.vertex_count(blocks[1])};
  for (const int block : blocks)
    if (model.dented(block,
                     std::span(model.vertex)
                         .subspan(size_t(model.shapes[size_t(block)].vertex_begin), size_t(model.vertex_count(block)))))
      return;
  const std::array parts{pair.parts_of(blocks[0]), pair.parts_of(blocks[1])};
  const auto out = parts[0] || parts[1]
                       ? way_out(parts, corners, pair.meeting(),
                                 [&](int of, int corner) { return pair.vertex(blocks[size_t(of)], corner); })
                       : way_out(corners, pair.meeting(), [&](int of, int face, int corner) {
                           return pair.edge(blocks[size_t(of)], face).gap(pair.vertex(blocks[size_t(1 - of)], corner));
                         });
  if (!out) return;
  const double rise = std::max(model.largest_rise(blocks[0], model.blocks[blocks[0]]),
                               model.largest_rise(blocks[1], model.blocks[blocks[1]]));
  const auto knows = [&](const Contact& c) { return c.gap - rise <= known_part * out->gap; };
  if (std::any_of(found.begin() + long(first), found.end(), knows)) return;
  const int bv = blocks[size_t(1 - out->of)], be = blocks[size_t(out->of)];
  if (pair.free(be, out->face) && pair.on_outline(bv, out->corner))
    found.push_back(pair.contact(bv, out->corner, be, out->face, out->gap, true));
}

}  // namespace

void find_contacts(const Model& model, const Surface& surface, const Faces& faces, int a, int b, double dt,
                   std::vector<Contact>& found, std::vector<MeetingCorners>& meeting) {
  const auto rim = [&](int k) { return std::abs(block_spin(model, k)) * model.shapes[k].radius; };
  const Vec2 approach(model.blocks[a].velocity[0] - model.blocks[b].velocity[0],
                      model.blocks[a].velocity[1] - model.blocks[b].velocity[1]);
  const NearPair pair(model, surface, faces, a, b, 1.5 * dt * (approach.norm() + rim(a) + rim(b)), dt);
  if (pair.apart()) return;
  const size_t first = found.size();
  vertices_on_edges(pair, model, a, b, found);
  vertices_on_edges(pair, model, b, a, found);
  for (int v = 0; v < model.vertex_count(a); ++v)
    if (pair.exposed(a, v))
      for (int w = 0; w < model.vertex_count(b); ++w)
        if (pair.exposed(b, w)) corner_on_corner(pair, v, w, first, found, meeting);
  drop_twins(pair, first, found);
  least_deep(pair, model, first, found);
}

double meeting_distance(const Model& model, int a, int b) {
  return meeting_part * std::min(model.shapes[a].length, model.shapes[b].length);
}

}  // namespace talus
