# Runs a program on arguments and files that it must refuse: exit code 2, one line on the standard error
# stream that names the file, nothing on the standard output.
#
# cmake -DPROGRAM=<file> "-DARGUMENTS=<what follows the input file>" -DTAKES_ANY_SURFACE=ON/OFF -P check_bad_input.cmake

set(good "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")

file(WRITE good.obj "${good}")
file(WRITE empty.off "")
file(WRITE cloud.off "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n")
file(WRITE nan.off "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n")
file(WRITE index.off "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n")
file(WRITE garbage.ply "no mesh at all\n")
file(WRITE format.xyz "0 0 0\n")
# A Moebius strip of five squares.
file(WRITE moebius.obj "v 1 0 -1\nv 1 0 1\nv 0.3 1 -1\nv 0.3 1 1\nv -0.8 0.6 -1\nv -0.8 0.6 1\nv -0.8 -0.6 -1\nv -0.8 -0.6 1\nv 0.3 -1 -1\nv 0.3 -1 1\n"
     "f 1 3 4 2\nf 3 5 6 4\nf 5 7 8 6\nf 7 9 10 8\nf 9 2 1 10\n")

function(check_refused file_name)
  execute_process(COMMAND "${PROGRAM}" ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE error TIMEOUT 60)
  message("${ARGN}: ${code}: ${error}")
  string(REGEX MATCHALL "\n" lines "${error}")
  list(LENGTH lines number_of_lines)
  string(FIND "${error}" "${file_name}" position)
  if(NOT code EQUAL 2)
    message(SEND_ERROR "exit code ${code} instead of 2")
  elseif(NOT number_of_lines EQUAL 1)
    message(SEND_ERROR "${number_of_lines} lines instead of one")
  elseif(position EQUAL -1)
    message(SEND_ERROR "'${file_name}' is not named")
  elseif(NOT output STREQUAL "")
    message(SEND_ERROR "printed '${output}'")
  endif()
endfunction()

set(file_names missing.off empty.off cloud.off nan.off index.off garbage.ply format.xyz)
if(NOT TAKES_ANY_SURFACE)
  list(APPEND file_names moebius.obj)
endif()
foreach(file_name ${file_names})
  check_refused("${file_name}" ${file_name} ${ARGUMENTS})
endforeach()
check_refused("--no-such-option" good.obj ${ARGUMENTS} --no-such-option)
check_refused("" ) # no arguments at all

execute_process(COMMAND "${PROGRAM}" --help RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE error)
if(NOT code EQUAL 0 OR NOT output MATCHES "usage:.*--json")
  message(SEND_ERROR "--help: exit code ${code}, ${output}")
endif()
