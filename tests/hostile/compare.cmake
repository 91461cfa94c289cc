# Builds tests/hostile with the flags FLAGS by the compiler COMPILER in the folder BINARY. Fails unless its program
# run_scripts prints the same bytes as the program REFERENCE for the scripts in the folders SCRIPTS and RANDOM_SCRIPTS,
# and its program print_meshes the same bytes as the program REFERENCE_MESHES. Runs the quick start if it is built.

include(${CMAKE_CURRENT_LIST_DIR}/../project/run.cmake)

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${BINARY} -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER}
    -DCMAKE_BUILD_TYPE=Hostile "-DCMAKE_CXX_FLAGS=${FLAGS}" -DWAYWRIGHT_UNITY=8)
run(${CMAKE_COMMAND} --build ${BINARY})

# print_output(FILE PROGRAM ARGUMENT...): runs the program, and writes its output to FILE.
function(print_output file)
  execute_process(
    COMMAND ${ARGN}
    OUTPUT_FILE ${file}
    RESULT_VARIABLE status
    TIMEOUT 600)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN} ended with ${status}")
  endif()
endfunction()

# compare(NAME REFERENCE ARGUMENT...): compares the output of the program NAME with the output of the program REFERENCE.
function(compare name reference)
  set(expected ${BINARY}/${name}.expected)
  set(actual ${BINARY}/${name}.actual)
  print_output(${expected} ${reference} ${ARGN})
  print_output(${actual} ${BINARY}/${name} ${ARGN})
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${expected} ${actual} RESULT_VARIABLE is_different)
  if(is_different)
    message(FATAL_ERROR "${COMPILER} ${FLAGS}: ${actual} is not ${expected}")
  endif()
  file(SHA256 ${actual} hash)
  file(SIZE ${actual} size)
  message("${COMPILER} ${FLAGS}: ${name}: ${size} bytes, SHA-256 ${hash}, same")
endfunction()

compare(run_scripts ${REFERENCE} ${SCRIPTS} ${RANDOM_SCRIPTS})
compare(print_meshes ${REFERENCE_MESHES})
set(quick_start ${BINARY}/waywright/examples/quick_start)
if(EXISTS ${quick_start})
  run(${quick_start})
endif()
