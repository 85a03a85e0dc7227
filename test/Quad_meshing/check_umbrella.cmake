# The header CGAL/Quad_meshing.h includes every public header, and nothing that is not there.
#
# cmake -DINCLUDE_DIR=<folder that holds CGAL> -P check_umbrella.cmake

file(READ "${INCLUDE_DIR}/CGAL/Quad_meshing.h" umbrella)
file(GLOB headers RELATIVE "${INCLUDE_DIR}"
     "${INCLUDE_DIR}/CGAL/Quad_meshing/*.h" "${INCLUDE_DIR}/CGAL/Quad_meshing/*/*.h")
list(FILTER headers EXCLUDE REGEX "/internal/")
foreach(header ${headers})
  string(FIND "${umbrella}" "#include <${header}>" position)
  if(position EQUAL -1)
    message(SEND_ERROR "CGAL/Quad_meshing.h does not include ${header}")
  endif()
endforeach()

string(REGEX MATCHALL "#include <[^>]*>" includes "${umbrella}")
foreach(include ${includes})
  string(REGEX REPLACE "#include <(.*)>" "\\1" header "${include}")
  if(NOT EXISTS "${INCLUDE_DIR}/${header}")
    message(SEND_ERROR "CGAL/Quad_meshing.h includes ${header}, which is not there")
  endif()
endforeach()
