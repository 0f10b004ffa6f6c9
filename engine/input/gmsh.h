#pragma once
// Meshes of Gmsh: .msh files of versions 2.x and 4.1, ASCII.
#include <array>
#include <map>
#include <string>
#include <vector>

#include "geometry/vec2.h"

namespace talus {

struct GmshMesh {
  struct Group {
    std::vector<std::vector<int>> cells;    // triangles and quadrangles, counter-clockwise: indices of points
    std::vector<std::array<int, 2>> lines;  // of a physical curve
  };
  std::vector<Vec2> points;               // units of the file
  std::map<std::string, Group> surfaces;  // by physical name; "group 3" where it has none, "" for elements of no group
  std::map<std::string, Group> curves;    // likewise; elements of no group are left out
  long curved = 0;                        // elements of second order, taken by their corners
};

// Throws FileError with the file's line.
GmshMesh read_gmsh(const std::string& text, const std::string& file);

// Lines end to end made to straight runs, as few as there can be: {from, to}.
std::vector<std::array<Vec2, 2>> straight_runs(const GmshMesh& mesh, const std::vector<std::array<int, 2>>& lines);

}  // namespace talus
