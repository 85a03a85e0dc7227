# Runs geodesic_distance on files whose mesh has other numbers than the file: options and results speak of the file.
#
# cmake -DPROGRAM=<file> -P check_geodesic_distance.cmake

# The lines of the result, as a list.
function(distances result)
  execute_process(COMMAND "${PROGRAM}" ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE error TIMEOUT 60)
  message("${ARGN}: ${code}: ${output}${error}")
  if(NOT code EQUAL 0)
    message(SEND_ERROR "exit code ${code}")
  endif()
  list(GET ARGN 1 file)
  file(STRINGS "${file}" lines)
  set(${result} "${lines}" PARENT_SCOPE)
endfunction()

function(expect list)
  if(NOT "${list}" STREQUAL "${ARGN}")
    message(SEND_ERROR "'${list}' instead of '${ARGN}'")
  endif()
endfunction()

# Vertex 0 is in no face.
file(WRITE unused.off "OFF\n5 2 0\n100 100 100\n0 0 0\n0 -4 0\n3 0 0\n0 4 0\n3 1 2 3\n3 1 3 4\n")
distances(lines unused.off unused.txt --vertices 3)
expect("${lines}" inf 3 5 0 5)
distances(lines unused.off unused.txt --vertices 3 --certified)
file(STRINGS unused.txt.enclosures.txt lines)
list(GET lines 0 first)
list(GET lines 3 fourth)
expect("${first}" "inf inf")
expect("${fourth}" "0 0")

# Two triangles with vertices of their own that are one rectangle, and a vertex that is two in the mesh.
file(WRITE loose.off "OFF\n6 2 0\n0 0 0\n4 0 0\n4 3 0\n0 0 0\n4 3 0\n0 3 0\n3 0 1 2\n3 3 4 5\n")
distances(lines loose.off loose.txt --vertices 1)
expect("${lines}" 4 0 3 4 3 5)
file(WRITE split.off "OFF\n5 2 0\n0 0 0\n4 0 0\n4 3 0\n-4 0 0\n-4 -3 0\n3 0 1 2\n3 0 3 4\n")
distances(lines split.off split.txt --vertices 0)
expect("${lines}" 0 4 5 4 5)

# A source that is in no face, and numbers that are none.
foreach(source 0 5 -1 1.5)
  execute_process(COMMAND "${PROGRAM}" unused.off unused.txt --vertices=${source} RESULT_VARIABLE code ERROR_VARIABLE error)
  if(NOT code EQUAL 2 OR NOT error MATCHES "geodesic_distance: --vertices: [^\n]*\n$")
    message(SEND_ERROR "--vertices ${source}: exit code ${code}, ${error}")
  endif()
endforeach()

execute_process(COMMAND "${PROGRAM}" --version RESULT_VARIABLE code OUTPUT_VARIABLE output)
if(NOT code EQUAL 0 OR NOT output MATCHES "^geodesic_distance [0-9]+\\.[0-9]+\\.[0-9]+\n$")
  message(SEND_ERROR "--version: exit code ${code}, ${output}")
endif()
