# A target does not compile, and the one error of the compiler holds a sentence.
#
# cmake -DTARGET=<target> -DSENTENCE=<text> -DBUILD_DIR=<build folder> -P check_mistake.cmake

execute_process(COMMAND ${CMAKE_COMMAND} --build "${BUILD_DIR}" --target ${TARGET}
                OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE result)
if(result EQUAL 0)
  message(FATAL_ERROR "${TARGET} compiles")
endif()
string(FIND "${output}" "${SENTENCE}" position)
if(position EQUAL -1)
  message(FATAL_ERROR "The compiler does not say \"${SENTENCE}\" but:\n${output}")
endif()
string(REGEX MATCHALL "error: " errors "${output}")
list(LENGTH errors number_of_errors)
if(NOT number_of_errors EQUAL 1)
  message(FATAL_ERROR "${number_of_errors} errors instead of one:\n${output}")
endif()
