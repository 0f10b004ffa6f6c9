# find_package(Talus): the target Talus::talus, and TALUS_LIBRARY, the folder of its Lua library.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.4 NO_MODULE)
find_dependency(VTK 9.1 COMPONENTS CommonCore CommonDataModel IOCore IOXML)
find_dependency(OpenMP COMPONENTS CXX)
find_dependency(PkgConfig)
pkg_check_modules(TALUS_LUA REQUIRED IMPORTED_TARGET lua5.4-c++)

get_filename_component(TALUS_ROOT "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
if(NOT EXISTS ${TALUS_ROOT}/include/talus)  # lib/<architecture>/cmake/Talus
  get_filename_component(TALUS_ROOT "${TALUS_ROOT}/.." ABSOLUTE)
endif()
set(TALUS_LIBRARY ${TALUS_ROOT}/share/talus/lib)
find_library(TALUS_ARCHIVE talus PATHS "${CMAKE_CURRENT_LIST_DIR}/../.." NO_DEFAULT_PATH REQUIRED)
if(NOT TARGET Talus::talus)
  add_library(Talus::talus STATIC IMPORTED)
  set_target_properties(Talus::talus PROPERTIES
    IMPORTED_LOCATION ${TALUS_ARCHIVE}
    INTERFACE_INCLUDE_DIRECTORIES ${TALUS_ROOT}/include/talus
    INTERFACE_COMPILE_FEATURES cxx_std_20
    INTERFACE_LINK_LIBRARIES "Eigen3::Eigen;PkgConfig::TALUS_LUA;${CMAKE_DL_LIBS};OpenMP::OpenMP_CXX;VTK::CommonCore;VTK::CommonDataModel;VTK::IOCore;VTK::IOXML;mpfr;gmp")
endif()
