#pragma once
#include <string>

namespace talus {

struct Versions {
  std::string talus, commit, eigen, cgal, vtk, suitesparse;
};
Versions versions();

}  // namespace talus
