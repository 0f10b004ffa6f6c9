# SuiteSparse 5 ships neither a CMake config nor a .pc file. Defines CHOLMOD::headers; the library itself is loaded when
# a scene first needs it (engine/equations/linear_solver.cpp).
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
mark_as_advanced(CHOLMOD_INCLUDE_DIR CHOLMOD_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CHOLMOD REQUIRED_VARS CHOLMOD_INCLUDE_DIR CHOLMOD_LIBRARY)

if(CHOLMOD_FOUND AND NOT TARGET CHOLMOD::headers)
  add_library(CHOLMOD::headers INTERFACE IMPORTED)
  set_target_properties(CHOLMOD::headers PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${CHOLMOD_INCLUDE_DIR}")
endif()
