#pragma once
#include <cmath>

#include "model/model.h"

namespace talus {

// Whether cracks have a path of their own where this bond fails (fracture/crack_tracking.h): as the scene says, or else
// where bonds stand for a continuum: they soften by a fracture energy in tension, their strengths do not scatter and
// their blocks are no grains.
inline bool is_tracked(const Model& model, const Joint& joint) {
  const Scene& scene = model.scene;
  if (scene.fracture.path != CrackPath::automatic) return scene.fracture.path == CrackPath::tracked;
  const JointProperty& property = scene.properties[joint.property];
  const auto of_triangles = [&](int block) {
    return scene.regions[model.shapes[block].region].mesh.kind == MeshKind::triangles;
  };
  return property.softening_compliance > 0 && std::isfinite(property.softening_compliance) && property.weibull == 0 &&
         of_triangles(joint.a) && of_triangles(joint.b);
}

}  // namespace talus
