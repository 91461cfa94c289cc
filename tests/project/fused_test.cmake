# Compiles fused.cpp with the options OPTIONS by the compiler COMPILER, for processors with fused instructions. Fails if
# the file OUTPUT, which contains the instructions, contains a fused one.

separate_arguments(options UNIX_COMMAND "${OPTIONS}")
foreach(processor x86-64-v3 x86-64-v4)
  execute_process(
    COMMAND ${COMPILER} -std=c++20 -O3 -march=${processor} ${options} -S -o ${OUTPUT}
            ${CMAKE_CURRENT_LIST_DIR}/fused.cpp
    RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${COMPILER} -march=${processor} ended with ${status}")
  endif()
  file(STRINGS ${OUTPUT} multiplications REGEX "[ \t]v?mul[ps]d[ \t]")
  file(STRINGS ${OUTPUT} fused REGEX "[ \t]vfn?m[as]")
  list(LENGTH multiplications count)
  if(count EQUAL 0 OR NOT fused STREQUAL "")
    message(FATAL_ERROR "${COMPILER} -march=${processor}: ${count} multiplications; fused:\n${fused}")
  endif()
endforeach()
