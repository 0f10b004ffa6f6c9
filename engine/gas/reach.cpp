#include "gas/reach.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "equations/side.h"
#include "geometry/polygon.h"

namespace talus {

namespace {

Vec2 joint_end(const Model& model, const Joint& joint, int end) {
  return (model.place(joint.a, joint.in_a[end]) + model.place(joint.b, joint.in_b[end])) / 2;
}

}  // namespace

void visit_state(ReachedJoint& reached, StateVisitor& v) {
  auto& [joint, from, to] = reached;
  v("joint", joint);
  v("from", from);
  v("to", to);
}

void visit_state(Reach& reach, StateVisitor& v) {
  auto& [joints, nodes, surface, outlet, walls] = reach;
  v.growing("joints", joints);
  v.growing("nodes", nodes);
  v("surface", surface);
  v("outlet", outlet);
  v.growing("walls", walls);
}

GasPaths::GasPaths(const Model& model)
    : joints_at_(model.nodes.position.size()),
      wall_nodes_(model.hole_walls.size()),
      corners_(model.nodes.position.size()),
      wall_at_(model.nodes.position.size(), -1) {
  for (size_t j = 0; j < model.joints.size(); ++j)
    for (const int node : model.joints[j].node) joints_at_[node].push_back(int(j));
  std::unordered_map<int, int> node_of;  // by index into Model::vertex
  const Nodes& nodes = model.nodes;
  for (size_t n = 0; n + 1 < nodes.begin.size(); ++n) {
    struct Seen {
      double angle;
      Corner corner;
    };
    std::vector<Seen> round;
    for (int k = nodes.begin[n]; k < nodes.begin[n + 1]; ++k) {
      const int block = nodes.blocks[k], vertex = model.shapes[block].vertex_begin + nodes.corners[k];
      const Vec2 inward = -model.reference_vertex[vertex];  // to the centroid: inside the corner of a convex block
      round.push_back({std::atan2(inward.y(), inward.x()), {block, vertex}});
      node_of[vertex] = int(n);
    }
    std::sort(round.begin(), round.end(), [](const Seen& a, const Seen& b) { return a.angle < b.angle; });
    size_t after = 0;
    double widest = -1;
    for (size_t k = 0; k < round.size(); ++k) {
      double gap = round[k].angle - round[(k + round.size() - 1) % round.size()].angle;
      if (k == 0) gap += 2 * std::numbers::pi;
      if (gap > widest) {
        widest = gap;
        after = k;
      }
    }
    std::rotate(round.begin(), round.begin() + long(after), round.end());
    for (const Seen& seen : round) corners_[n].push_back(seen.corner);
  }
  for (size_t w = 0; w < model.hole_walls.size(); ++w)
    for (const BlockEdge& edge : model.hole_walls[w].edges) {
      const auto node = node_of.find(model.shapes[edge.block].vertex_begin + edge.edge);
      if (node == node_of.end()) continue;  // of a block that was given ready
      wall_nodes_[w].push_back(node->second);
      wall_at_[node->second] = int(w);
    }
}

Reach GasPaths::find(const Model& model, const std::vector<int>& own,
                     const std::function<bool(const Vec2&)>& within) const {
  constexpr int halvings = 40;
  std::vector<char> pressed(model.joints.size(), 0), node_seen(corners_.size(), 0), joint_seen(model.joints.size(), 0);
  for (const Contact& c : model.contacts)
    if (c.joint >= 0 && c.normal_force > 0) pressed[c.joint] = 1;
  Reach reach;
  std::vector<int> met;
  for (const int wall : own)
    for (const int node : wall_nodes_[wall])
      if (!node_seen[node]++) reach.nodes.push_back(node);
  for (size_t head = 0; head < reach.nodes.size(); ++head)
    for (const int j : joints_at_[reach.nodes[head]]) {
      const Joint& joint = model.joints[j];
      if (joint.state != JointState::failed || pressed[j] || joint_seen[j]) continue;
      const int end = joint.node[0] == reach.nodes[head] ? 0 : 1;
      const Vec2 near = joint_end(model, joint, end), far = joint_end(model, joint, 1 - end);
      double part = 1;
      if (!within(far)) {
        double low = 0, high = 1;
        for (int k = 0; k < halvings; ++k) {
          const double middle = (low + high) / 2;
          (within(near + middle * (far - near)) ? low : high) = middle;
        }
        part = low;
      }
      if (part == 0) continue;
      joint_seen[j] = part == 1;  // what has been reached in part may yet be reached from its other end
      reach.joints.push_back(end == 0 ? ReachedJoint{j, 0, part} : ReachedJoint{j, 1 - part, 1});
      const int next = joint.node[1 - end];
      if (part == 1 && !node_seen[next]++) reach.nodes.push_back(next);
    }
  // Parts from both ends that have met are the whole.
  std::sort(reach.joints.begin(), reach.joints.end(), [](const ReachedJoint& a, const ReachedJoint& b) {
    return a.joint != b.joint ? a.joint < b.joint : a.from < b.from;
  });
  std::vector<ReachedJoint> merged;
  for (const ReachedJoint& r : reach.joints) {
    if (!merged.empty() && merged.back().joint == r.joint && merged.back().to >= r.from)
      merged.back().to = std::max(merged.back().to, r.to);
    else
      merged.push_back(r);
  }
  reach.joints = std::move(merged);
  for (const int node : reach.nodes) {
    const int wall = wall_at_[node];
    if (!reach.surface && model.nodes.free[node]) {
      reach.surface = true;
      reach.outlet = node;
    }
    if (wall >= 0 && std::find(own.begin(), own.end(), wall) == own.end() &&
        std::find(reach.walls.begin(), reach.walls.end(), wall) == reach.walls.end())
      reach.walls.push_back(wall);
  }
  return reach;
}

namespace {

// Along a face. That of a second-order block is a parabola: this corner in it gives the polygon the same area.
void follow(const BlockShape& shape, const Pose& pose, const Vec2& from, const Vec2& to, Polyline& outline) {
  const Vec2 p = pose.place(from), q = pose.place(to);
  outline.push_back(p);
  if (shape.second_order()) outline.push_back(4 * pose.place((from + to) / 2) / 3 - (p + q) / 6);
  outline.push_back(q);
}

}  // namespace

double gas_volume(const Model& model, const std::vector<BlockState>& blocks, double seconds, const GasPaths& paths,
                  const std::vector<int>& walls, const Reach& reach) {
  const auto place = [&](int block, const Vec2& in_block) {
    return flown(model.shapes[block], blocks[block], seconds).place(in_block);
  };
  const auto follow_face = [&](int block, const Vec2& from, const Vec2& to, Polyline& outline) {
    follow(model.shapes[block], flown(model.shapes[block], blocks[block], seconds), from, to, outline);
  };
  double volume = 0;
  for (const int wall : walls) {
    const HoleWall& own = model.hole_walls[wall];
    // blocks are on its left: the wall's has the hole on the right, that of what lies in the hole itself on the left
    Polyline outline;
    for (size_t k = 0; k < own.edges.size(); ++k) {
      if (std::find(own.outlines.begin() + 1, own.outlines.end(), k) != own.outlines.end()) {
        volume -= signed_area(outline);
        outline.clear();
      }
      const BlockEdge& edge = own.edges[k];
      const Vec2* const corners = &model.reference_vertex[model.shapes[edge.block].vertex_begin];
      follow_face(edge.block, corners[edge.edge], corners[model.next_vertex(edge.block, edge.edge)], outline);
    }
    volume -= signed_area(outline);
  }
  for (const ReachedJoint& r : reach.joints) {
    const Joint& joint = model.joints[r.joint];
    Polyline gap;
    follow_face(joint.b, between(joint.in_b, r.from), between(joint.in_b, r.to), gap);
    follow_face(joint.a, between(joint.in_a, r.to), between(joint.in_a, r.from), gap);
    volume += signed_area(gap);
  }
  for (const int node : reach.nodes) {
    Polyline gap;
    for (const GasPaths::Corner& c : paths.corners(node))
      gap.push_back(place(c.block, model.reference_vertex[c.vertex]));
    volume += signed_area(gap);
  }
  return volume;
}

void add_gas_faces(const Model& model, int chamber, const std::vector<int>& walls, const Reach& reach,
                   std::vector<GasFace>& faces) {
  for (const int wall : walls)
    for (const BlockEdge& edge : model.hole_walls[wall].edges) {
      const int begin = model.shapes[edge.block].vertex_begin;
      faces.push_back({chamber,
                       edge.block,
                       {model.reference_vertex[begin + edge.edge],
                        model.reference_vertex[begin + model.next_vertex(edge.block, edge.edge)]}});
    }
  for (const ReachedJoint& r : reach.joints) {
    const Joint& joint = model.joints[r.joint];
    faces.push_back({chamber, joint.a, {between(joint.in_a, r.from), between(joint.in_a, r.to)}});
    faces.push_back({chamber, joint.b, {between(joint.in_b, r.to), between(joint.in_b, r.from)}});
  }
}

double swept_by_faces(const Model& model, int chamber, const std::vector<BlockState>& moved) {
  double volume = 0;
  for (const GasFace& face : model.gas_faces) {
    if (face.chamber != chamber) continue;
    const BlockShape& shape = model.shapes[face.block];
    Polyline then, now;
    follow(shape, flown(model, face.block, 0), face.in_block[0], face.in_block[1], then);
    follow(shape, flown(shape, moved[face.block], 0), face.in_block[0], face.in_block[1], now);
    for (size_t k = 1; k < then.size(); ++k)
      volume += perp(then[k] + now[k] - then[k - 1] - now[k - 1]).dot(now[k - 1] + now[k] - then[k - 1] - then[k]) / 4;
  }
  return volume;
}

}  // namespace talus
