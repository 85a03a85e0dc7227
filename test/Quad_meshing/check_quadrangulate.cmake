# Runs the program `quadrangulate` on a cube: the result is valid, all faces have four vertices, and the
# figures are there.
#
# cmake -DPROGRAM=<file> -P check_quadrangulate.cmake

file(WRITE cube.off "OFF\n8 12 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
     "3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n")

foreach(result cube.obj cube_quads.off cube.ply)
  execute_process(COMMAND "${PROGRAM}" cube.off ${result} --target-quads 150 --json figures.json
                  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE error TIMEOUT 120)
  message("${result}: ${code}: ${output}${error}")
  if(NOT code EQUAL 0 OR NOT error STREQUAL "")
    message(FATAL_ERROR "exit code ${code}: ${error}")
  endif()
endforeach()

file(STRINGS cube.obj faces REGEX "^f ")
list(LENGTH faces number_of_faces)
foreach(face ${faces})
  if(NOT face MATCHES "^f +[0-9/]+ +[0-9/]+ +[0-9/]+ +[0-9/]+ *$")
    message(SEND_ERROR "not a quad: ${face}")
  endif()
endforeach()
# Six equal squares, and a number of quads near the one asked for.
math(EXPR rest "${number_of_faces} % 6")
if(NOT rest EQUAL 0 OR number_of_faces LESS 112 OR number_of_faces GREATER 188)
  message(SEND_ERROR "${number_of_faces} quads")
endif()

file(READ figures.json figures)
foreach(key status valid message input_faces components target_edge_length quads irregular_vertices singularities
        field_integers field_energy field_seconds parameterization_integers parameterization_energy
        parameterization_seconds flipped_triangles extraction_seconds total_seconds)
  string(JSON value ERROR_VARIABLE missing GET "${figures}" ${key})
  if(missing)
    message(SEND_ERROR "${missing}")
  endif()
endforeach()
string(JSON valid GET "${figures}" valid)
string(JSON quads GET "${figures}" quads)
string(JSON irregular GET "${figures}" irregular_vertices)
if(NOT valid OR NOT quads EQUAL number_of_faces OR NOT irregular EQUAL 8)
  message(SEND_ERROR "unexpected figures: ${figures}")
endif()

# A cube has 2 (a b + b c + c a) quads: 150 can be had, nothing near 13 can, which is an error only if it is asked for strictly.
foreach(request "150;--strict;0" "13;--strict;1" "13;--align-boundary=on;0")
  list(GET request 0 quads)
  list(GET request 1 option)
  list(GET request 2 expected)
  execute_process(COMMAND "${PROGRAM}" cube.off strict.obj --target-quads ${quads} ${option}
                  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE error TIMEOUT 120)
  message("${quads} ${option}: ${code}: ${output}${error}")
  if(NOT code EQUAL expected)
    message(SEND_ERROR "exit code ${code} instead of ${expected}")
  endif()
  if(expected EQUAL 1 AND NOT error MATCHES "quads instead of 13")
    message(SEND_ERROR "what was not met is not named: ${error}")
  endif()
endforeach()

# The tube is too thin for a grid of such quads and gets thinner ones. Where its borders need not be aligned that is not
# possible, and the message names the component by its first face in the file: here a face is dropped and the others are
# cut, so that the tube begins with face 7 of the file and with face 12 of the mesh.
set(points "0 0 0\n20 0 0\n30 0 0\n30 10 0\n20 10 0\n20 0 10\n30 0 10\n30 10 10\n20 10 10\n")
set(faces "3 0 1 1\n4 1 4 3 2\n4 5 6 7 8\n4 1 2 6 5\n4 2 3 7 6\n4 3 4 8 7\n4 4 1 5 8\n")
set(circle "1 0" ".8660254 .5" ".5 .8660254" "0 1" "-.5 .8660254" "-.8660254 .5"
    "-1 0" "-.8660254 -.5" "-.5 -.8660254" "0 -1" ".5 -.8660254" ".8660254 -.5")
foreach(i RANGE 11)
  list(GET circle ${i} place)
  string(APPEND points "${place} 0\n${place} 100\n")
  math(EXPR a "9 + 2 * ${i}")
  math(EXPR b "9 + 2 * ((${i} + 1) % 12)")
  math(EXPR c "${b} + 1")
  math(EXPR d "${a} + 1")
  string(APPEND faces "4 ${a} ${b} ${c} ${d}\n")
endforeach()
file(WRITE tube.off "OFF\n33 19 0\n${points}${faces}")
execute_process(COMMAND "${PROGRAM}" tube.off tube.obj --target-edge-length 3.3
                RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE error TIMEOUT 120)
message("tube.off: ${code}: ${output}${error}")
if(NOT code EQUAL 0 OR NOT output MATCHES "A pure quad mesh" OR NOT error MATCHES "1 face with fewer than three")
  message(SEND_ERROR "The tube has no quads.")
endif()
execute_process(COMMAND "${PROGRAM}" tube.off tube.obj --target-edge-length 3.3 --align-boundary=off
                RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE error TIMEOUT 120)
message("tube.off --align-boundary=off: ${code}: ${output}${error}")
if(NOT code EQUAL 1 OR NOT output MATCHES "1 of 2 components" OR NOT output MATCHES "that of face 7: ")
  message(SEND_ERROR "The tube is not named by face 7 of the file.")
endif()
