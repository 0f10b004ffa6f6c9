#include <gtest/gtest.h>

#include "input/drawing.h"
#include "input/gmsh.h"

namespace talus {
namespace {

// Two triangles and a quadrangle, the first triangle clockwise; group 1 "rock", 2 "steel", curve 7 "base" of two lines.
const std::string version_2 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
3
1 7 "base"
2 1 "rock"
2 2 "steel plate"
$EndPhysicalNames
$Nodes
6
1 0 0 0
2 1 0 0
30 1 1 0
4 0 1 0
5 2 0 0
6 2 1 0
$EndNodes
$Comments
anything
$EndComments
$Elements
6
1 15 2 0 1 1
2 1 2 7 1 1 2
3 1 2 7 1 2 5
4 2 2 1 1 1 30 2
5 2 2 1 1 1 30 4
6 3 2 2 1 2 5 6 30
$EndElements
)";

const std::string version_4 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
1 7 "base"
2 1 "rock"
$EndPhysicalNames
$Entities
1 2 2 0
1 0 0 0 0
1 0 0 0 2 0 0 1 7 2 1 -2
2 0 0 0 2 1 0 0 2 1 -2
1 0 0 0 1 1 0 1 1 2 1 2
2 1 0 0 2 1 0 0 2 1 2
$EndEntities
$Nodes
2 6 1 6
1 1 0 3
1
2
5
0 0 0
1 0 0
2 0 0
2 1 0 3
3
4
6
1 1 0
0 1 0
2 1 0
$EndNodes
$Elements
3 5 1 5
1 1 1 2
1 1 2
2 2 5
2 1 2 2
3 1 2 3
4 1 3 4
2 2 3 1
5 2 5 6 3
$EndElements
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::string refusal(const std::string& text) {
  try {
    read_gmsh(text, "a.msh");
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

TEST(Gmsh, Version2HasGroupsByName) {
  const GmshMesh mesh = read_gmsh(version_2, "a.msh");
  ASSERT_EQ(mesh.points.size(), 6u);
  ASSERT_EQ(mesh.surfaces.size(), 2u);
  const auto& rock = mesh.surfaces.at("rock").cells;
  ASSERT_EQ(rock.size(), 2u);
  EXPECT_EQ(rock[0], (std::vector<int>{1, 2, 0}));  // turned to be counter-clockwise
  EXPECT_EQ(rock[1], (std::vector<int>{0, 2, 3}));
  EXPECT_EQ(mesh.surfaces.at("steel plate").cells, (std::vector<std::vector<int>>{{1, 4, 5, 2}}));
  EXPECT_EQ(mesh.points[2], Vec2(1, 1));
}

TEST(Gmsh, Version4HasGroupsOfItsEntities) {
  const GmshMesh mesh = read_gmsh(version_4, "a.msh");
  EXPECT_EQ(mesh.surfaces.at("rock").cells, (std::vector<std::vector<int>>{{0, 1, 3}, {0, 3, 4}}));
  EXPECT_EQ(mesh.surfaces.at("").cells, (std::vector<std::vector<int>>{{1, 2, 5, 3}}));  // of no group
  EXPECT_EQ(mesh.curves.at("base").lines.size(), 2u);
}

TEST(Gmsh, CurvesAreJoinedToStraightRuns) {
  const GmshMesh mesh = read_gmsh(version_2, "a.msh");
  const auto runs = straight_runs(mesh, mesh.curves.at("base").lines);
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0][0], Vec2(0, 0));
  EXPECT_EQ(runs[0][1], Vec2(2, 0));
  EXPECT_EQ(straight_runs(mesh, {{0, 1}, {1, 2}}).size(), 2u);  // a corner
}

TEST(Gmsh, ElementsOfSecondOrderAreTakenByTheirCorners) {
  const GmshMesh mesh = read_gmsh(replaced(version_2, "5 2 2 1 1 1 30 4", "5 9 2 1 1 1 30 4 2 5 6"), "a.msh");
  EXPECT_EQ(mesh.curved, 1);
  EXPECT_EQ(mesh.surfaces.at("rock").cells[1], (std::vector<int>{0, 2, 3}));
}

TEST(Gmsh, WhatIsWrongIsSaidWithItsLine) {
  EXPECT_EQ(refusal(replaced(version_2, "2.2 0 8", "2.2 1 8")),
            "a.msh:2: expected an ASCII mesh, got a binary one: save it without -bin, with Mesh.Binary = 0");
  EXPECT_EQ(refusal(replaced(version_4, "4.1 0 8", "4.0 0 8")),
            "a.msh:2: expected version 2.2 or 4.1, got version 4.0: save it with gmsh -format msh22 or -format msh41");
  EXPECT_EQ(refusal(replaced(version_2, "4 0 1 0", "4 0 nan 0")),
            "a.msh:15: expected a finite number for a coordinate, got \"nan\"");
  EXPECT_EQ(refusal(replaced(version_2, "6 2 1 0", "6 2 1 3")).substr(0, 50),
            "a.msh:17: expected a mesh in a plane z = const, go");
  EXPECT_EQ(refusal(replaced(version_2, "5 2 0 0", "4 2 0 0")), "a.msh:16: expected each node once, got node 4 again");
  EXPECT_EQ(refusal(replaced(version_2, "5 2 2 1 1 1 30 4", "5 2 2 1 1 1 30 9")),
            "a.msh:28: expected a node of the section $Nodes, which comes before $Elements, got node 9");
  EXPECT_EQ(
      refusal(replaced(version_2, "5 2 2 1 1 1 30 4", "5 4 2 1 1 1 30 4 2")),
      "a.msh:28: expected points, lines, triangles and quadrangles, got an element of type 4 (a solid: mesh in two dimensions, gmsh -2)");
  EXPECT_EQ(refusal(replaced(version_2, "5 2 2 1 1 1 30 4", "5 2 2 1 1 1 30")),
            "a.msh:28: expected 3 nodes of an element of type 2, got 2");
  EXPECT_EQ(refusal(replaced(version_2, "5 2 2 1 1 1 30 4", "5 2 2 1 1 1 2 5")),
            "a.msh:28: expected an element with an area, got one without");
  EXPECT_EQ(refusal("0\nSECTION\n"), "a.msh:1: expected a .msh file of Gmsh, which begins with $MeshFormat, got \"0\"");
  EXPECT_EQ(refusal(""), "a.msh: expected a .msh file of Gmsh, which begins with $MeshFormat, got an empty file");
}

TEST(Gmsh, FilesCutShortAreRefused) {
  for (const std::string& text : {version_2, version_4})
    for (std::size_t kept = 0; kept + 2 < text.size(); ++kept) EXPECT_NE(refusal(text.substr(0, kept)), "") << kept;
}

}  // namespace
}  // namespace talus
