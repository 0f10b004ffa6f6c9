#include "output/versions.h"

#include <CGAL/version.h>
#include <SuiteSparse_config.h>

#include <Eigen/Core>

#include "output/vtk_writer.h"
#include "scene/version.h"

namespace talus {

Versions versions() {
  const auto dotted = [](int a, int b, int c) {
    return std::to_string(a) + "." + std::to_string(b) + "." + std::to_string(c);
  };
  return {.talus = version,
          .commit = commit,
          .eigen = dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION),
          .cgal = CGAL_VERSION_STR,
          .vtk = vtk_version(),
          .suitesparse = dotted(SUITESPARSE_MAIN_VERSION, SUITESPARSE_SUB_VERSION, SUITESPARSE_SUBSUB_VERSION)};
}

}  // namespace talus
