#pragma once
// Which vertices may meet which edges during the next step of `dt` seconds.
#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "contact/box_grid.h"
#include "contact/faces.h"
#include "geometry/convex_parts.h"
#include "model/model.h"

namespace talus {

// Part of its length by which a block is taken larger when neighbours are sought: what a block moves a step at
// ten times the default displacement ratio in a scene one block high.
constexpr double search_margin = 0.05;
// What moves past another body and comes nearer than this to it touches it, in units of the smaller block's √area; what
// no contact knows of may be so deep.
constexpr double passing_tolerance = 0.01;

// s, from the end of a step to where the bodies come to at its velocities in y, the places that contacts are judged at
// (theory, § 2).
inline double judged_ahead(const Numerics& numerics, double dt) {
  return numerics.integrator == Integrator::theta ? (numerics.theta - 0.5) * dt : 0;
}

// Which blocks come near each other, from a list of those that do within some steps: it is made anew when one leaves
// the box that it was made with.
class NearBlocks {
 public:
  // Pairs of blocks (a < b, sorted) of the list, which rises, whose boxes, grown by their motion in `dt` at the
  // velocities of `states` and by a part of their length, meet. Hierarchical grid: linear in the number of blocks
  // whatever their sizes. Pairs of held blocks are left out.
  std::vector<std::pair<int, int>> find(const Model& model, const std::vector<BlockState>& states,
                                        const std::vector<int>& blocks, double dt);

 private:
  std::vector<int> blocks_;
  std::vector<Box> wide_;                   // of blocks_
  std::vector<std::pair<int, int>> pairs_;  // places in blocks_, of which those boxes meet
};

struct OutlineEdge {  // of a block: the edge that begins at its corner of this number
  int block, edge;
};

inline std::int64_t pair_key(int a, int b) {
  return (std::int64_t(std::min(a, b)) << 32) | std::max(a, b);
}

// The outlines of bodies: of blocks, and of blocks bonded to each other, all by global vertex.
struct Surface {
  std::vector<int> joint;       // open joint whose face begins here, or -1
  std::vector<char> free_edge;  // no intact joint covers the edge that begins here; others cannot touch
  std::vector<char> convex;     // by block
  std::unordered_map<int, std::vector<ConvexPart>> parts;  // of those that are not
  std::vector<char> whole;                                 // by block: all its edges are free
  // sides of the outline that meet in the corner, of blocks of the same body round it: what the body is at a corner, of
  // which one block is only a part
  std::vector<OutlineEdge> leaving, arriving;
  std::unordered_set<std::int64_t> bonded;  // pairs glued along an edge, or round a corner they share
  const std::vector<ConvexPart>* parts_of(int block) const {
    return convex[size_t(block)] ? nullptr : &parts.at(block);
  }
  bool together(int a, int b) const { return bonded.contains(pair_key(a, b)); }
};

class ContactSearch {
 public:
  // Replaces the contacts of what is awake by the candidates of the next step, in order of (vertex, edge). Contacts
  // that go on keep their state; one that hands over to a neighbouring edge or to its partner's vertex passes it on.
  // `seen`, if any: where a solution of the step led; what that did not know of is looked for on those ways.
  // `cracked`: bonds have failed in this step, whose bodies met by other corners before.
  void update(Model& model, double dt, const std::vector<BlockState>& seen = {}, bool cracked = false);
  // Whether nothing had moved since the search before it, which had found all there is.
  bool found_as_before() const { return found_as_before_; }
  // J/m, what those stored that ended in the last search, pressed off the end of a face as a rule, beyond what went on
  // in others.
  double ended() const { return ended_; }
  // Pairs of blocks that came near each other in the last search.
  const std::vector<std::pair<int, int>>& near() const { return near_; }
  // Those that would at other velocities.
  std::vector<std::pair<int, int>> near(const Model& model, const std::vector<BlockState>& states, double dt) const;
  bool bonded(int a, int b) const { return surface_.together(a, b); }
  const Surface& surface() const { return surface_; }
  double least_length() const { return least_length_; }  // m, of all blocks
  // The next search looks whatever has moved.
  void forget_last() { seen_.clear(); }
  // Bonds that had failed are whole again: as many as others may fail before the next search.
  void forget_surface() { intact_joints_ = -1; }
  // States of joints were set from outside: the surface is found anew.
  void forget(const Model& model) {
    intact_joints_ = -1;
    forget_last();
    find_surface(model);
  }
  template <class Visitor>  // of the registry, model/registry.h
  void visit_state(Visitor& visitor) {
    visitor("time", time_);
    visitor("last_dt", last_dt_);
  }

 private:
  void find_surface(const Model& model);
  std::vector<int> awake(const Model& model) const;
  void find_outlines(const Model& model);
  bool unmoved(const Model& model, double dt);

  int intact_joints_ = -1;           // the surface is found anew when this changes
  std::vector<int> surface_blocks_;  // blocks with a free edge
  Surface surface_;
  double least_length_ = 0;
  double time_ = 0, last_dt_ = 0;  // s, of the last search of another time, and the accepted step since
  std::vector<double> seen_;       // places in the last search, if nothing moved
  double seen_dt_ = 0;
  bool found_as_before_ = false;
  double ended_ = 0;
  NearBlocks near_blocks_;
  std::vector<std::pair<int, int>> near_;
  Faces faces_;
};

}  // namespace talus
