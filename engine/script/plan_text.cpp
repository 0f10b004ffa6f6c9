#include "script/plan_text.h"

#include <algorithm>
#include <utility>

namespace talus {

std::string plan_text(const Simulation& simulation) {
  const Model& m = simulation.model;
  const std::pair<const char*, std::size_t> sizes[] = {{"regions", m.scene.regions.size()},
                                                       {"blocks", m.blocks.size()},
                                                       {"unknowns", static_cast<std::size_t>(m.dofs)},
                                                       {"vertices", m.vertex.size()},
                                                       {"joints", m.joints.size()},
                                                       {"materials", m.scene.materials.size()},
                                                       {"joint properties", m.scene.properties.size()},
                                                       {"fixities", m.scene.fixities.size()},
                                                       {"point loads", m.scene.point_loads.size()},
                                                       {"edge loads", m.scene.edge_loads.size()},
                                                       {"probes", m.scene.probes.size()}};
  std::string text = "plan of " + (m.scene.title.empty() ? m.scene.file : m.scene.title) + "\n";
  for (const auto& [name, count] : sizes) {
    if (count > 0) text += "  " + std::to_string(count) + " " + name + "\n";
  }
  std::size_t width = 0;
  for (const auto& line : simulation.plan.lines) width = std::max(width, line.first.size());
  for (const auto& [part, what] : simulation.plan.lines) {
    text += "  " + part + std::string(width - part.size(), ' ') + "  " + what + "\n";
  }
  for (const std::string& note : simulation.notes) text += "  note: " + note + "\n";
  return text;
}

}  // namespace talus
