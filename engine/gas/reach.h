#pragma once
// How far the gas has got: from the walls of its holes along failed joints that hang together, within its front.
#include <functional>
#include <vector>

#include "model/model.h"
#include "model/state_visitor.h"

namespace talus {

struct ReachedJoint {
  int joint = 0;
  double from = 0, to = 1;  // part of it, from its end 0
};

struct Reach {
  std::vector<ReachedJoint> joints;
  std::vector<int> nodes;  // into Model::nodes
  bool surface = false;    // a free surface is among them
  int outlet = -1;         // node, the first on the way that is at one
  std::vector<int> walls;  // hole walls met, beside its own
};

void visit_state(ReachedJoint& joint, StateVisitor& visitor);
void visit_state(Reach& reach, StateVisitor& visitor);

// What joins the nodes of a model: settled when it is built.
class GasPaths {
 public:
  explicit GasPaths(const Model& model);

  // From the hole walls `own`. `within(p)`: whether the front has passed the place p, which it does once along a
  // straight way from a place it has passed (the front is a circle about a hole). A joint whose faces press on each
  // other lets no gas by.
  Reach find(const Model& model, const std::vector<int>& own, const std::function<bool(const Vec2&)>& within) const;

  // Nodes of a hole wall, in its order; corners of the blocks round a node, counter-clockwise, beginning after the
  // widest opening: indices into Model::vertex with their blocks.
  struct Corner {
    int block, vertex;
  };
  const std::vector<int>& wall_nodes(int wall) const { return wall_nodes_[wall]; }
  const std::vector<Corner>& corners(int node) const { return corners_[node]; }

 private:
  std::vector<std::vector<int>> joints_at_, wall_nodes_;
  std::vector<std::vector<Corner>> corners_;
  std::vector<int> wall_at_;  // per node: hole wall it lies on, or -1
};

// m2, of what the gas fills between the walls and the reached faces, where the blocks get in `seconds` of free flight:
// the holes' polygons, the part of each joint that it has reached and what opens between the corners that met in a
// node. Exact polygon areas.
double gas_volume(const Model& model, const std::vector<BlockState>& blocks, double seconds, const GasPaths& paths,
                  const std::vector<int>& walls, const Reach& reach);

// m3 per metre that a chamber's faces sweep from where the blocks are to `moved`, exact for faces that move straight.
double swept_by_faces(const Model& model, int chamber, const std::vector<BlockState>& moved);
// Appends the faces that `chamber` presses on.
void add_gas_faces(const Model& model, int chamber, const std::vector<int>& walls, const Reach& reach,
                   std::vector<GasFace>& faces);

}  // namespace talus
