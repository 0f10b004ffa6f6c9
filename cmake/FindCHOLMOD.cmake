# SuiteSparse 5 ships neither a CMake config nor a .pc file. Defines CHOLMOD::CHOLMOD.
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
set(CHOLMOD_LIBRARIES)
set(CHOLMOD_MISSING)
foreach(part cholmod amd colamd camd ccolamd suitesparseconfig)
  find_library(CHOLMOD_${part}_LIBRARY ${part})
  mark_as_advanced(CHOLMOD_${part}_LIBRARY)
  list(APPEND CHOLMOD_LIBRARIES ${CHOLMOD_${part}_LIBRARY})
  list(APPEND CHOLMOD_MISSING CHOLMOD_${part}_LIBRARY)
endforeach()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CHOLMOD REQUIRED_VARS CHOLMOD_INCLUDE_DIR ${CHOLMOD_MISSING})

if(CHOLMOD_FOUND AND NOT TARGET CHOLMOD::CHOLMOD)
  add_library(CHOLMOD::CHOLMOD INTERFACE IMPORTED)
  set_target_properties(CHOLMOD::CHOLMOD PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${CHOLMOD_INCLUDE_DIR}"
                        INTERFACE_LINK_LIBRARIES "${CHOLMOD_LIBRARIES}")
endif()
mark_as_advanced(CHOLMOD_INCLUDE_DIR)
