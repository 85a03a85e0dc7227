# Finds CGAL's data folder, whose meshes the tests and examples use where it is there.
#
# The variable CGAL_DATA_DIR, or the environment variable of that name, wins. Else the archive of
# Debian's package libcgal-demo is unpacked into the build folder.

set(CGAL_DATA_DIR "$ENV{CGAL_DATA_DIR}" CACHE PATH "CGAL's data folder, which holds meshes/ (optional)")
set(CGAL_QUAD_MESHING_DATA_ARCHIVE "/usr/share/doc/libcgal-dev/data.tar.gz" CACHE FILEPATH
    "An archive of CGAL's data folder, used when CGAL_DATA_DIR is empty (optional)")
mark_as_advanced(CGAL_QUAD_MESHING_DATA_ARCHIVE)

if(NOT CGAL_DATA_DIR AND (CGAL_QUAD_MESHING_BUILD_TESTS OR CGAL_QUAD_MESHING_BUILD_EXAMPLES OR
                          CGAL_QUAD_MESHING_BUILD_BENCHMARKS))
  set(_data_dir "${CMAKE_BINARY_DIR}/cgal_data/data")
  if(NOT EXISTS "${_data_dir}/meshes" AND EXISTS "${CGAL_QUAD_MESHING_DATA_ARCHIVE}")
    file(ARCHIVE_EXTRACT INPUT "${CGAL_QUAD_MESHING_DATA_ARCHIVE}" DESTINATION "${CMAKE_BINARY_DIR}/cgal_data"
         PATTERNS "data/meshes")
  endif()
  if(EXISTS "${_data_dir}/meshes")
    # A normal variable: the cached one stays empty, as a build folder may be copied or cleaned.
    set(CGAL_DATA_DIR "${_data_dir}")
  else()
    message(STATUS "NOTICE: CGAL's data folder was not found, tests that use it will say so and skip it.")
  endif()
endif()
