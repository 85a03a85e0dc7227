# Finds what the headers need: CGAL, Eigen, threads, and CHOLMOD as CGAL_QUAD_MESHING_WITH_CHOLMOD says.
#
# Defines the targets CGAL::CGAL, CGAL::Eigen3_support, Threads::Threads and, where CGAL_QUAD_MESHING_USE_CHOLMOD
# becomes true, SuiteSparse::CHOLMOD. Used by the build and by the installed package.

find_package(Threads REQUIRED)
find_package(CGAL 5.5 REQUIRED)
find_package(Eigen3 3.3.4 REQUIRED)
include(CGAL_Eigen3_support)
if(NOT TARGET CGAL::Eigen3_support)
  message(FATAL_ERROR "Quad_meshing needs Eigen 3.3.4 or later.")
endif()

set(CGAL_QUAD_MESHING_USE_CHOLMOD OFF)
if(NOT CGAL_QUAD_MESHING_WITH_CHOLMOD STREQUAL "OFF")
  if(CGAL_QUAD_MESHING_WITH_CHOLMOD STREQUAL "AUTO")
    find_package(CHOLMOD QUIET)
  else()
    find_package(CHOLMOD REQUIRED)
  endif()
  set(CGAL_QUAD_MESHING_USE_CHOLMOD ${CHOLMOD_FOUND})
endif()
if(CGAL_QUAD_MESHING_USE_CHOLMOD)
  message(STATUS "Quad_meshing factors sparse matrices with CHOLMOD: ${CHOLMOD_LIBRARY}")
else()
  message(STATUS "Quad_meshing factors sparse matrices with Eigen")
endif()
