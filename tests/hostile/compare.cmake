# Builds tests/hostile with the flags FLAGS by the compiler COMPILER in the folder BINARY. Fails unless its program
# prints the same bytes as the program REFERENCE for the scripts in the folders SCRIPTS and RANDOM_SCRIPTS.

include(${CMAKE_CURRENT_LIST_DIR}/../project/run.cmake)

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${BINARY} -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER}
    -DCMAKE_BUILD_TYPE=Hostile "-DCMAKE_CXX_FLAGS=${FLAGS}")
run(${CMAKE_COMMAND} --build ${BINARY} --target run_scripts)
function(print_answers program file)
  execute_process(
    COMMAND ${program} ${SCRIPTS} ${RANDOM_SCRIPTS}
    OUTPUT_FILE ${BINARY}/${file}
    RESULT_VARIABLE status
    TIMEOUT 600)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${program} ended with ${status}")
  endif()
endfunction()
print_answers(${REFERENCE} expected)
print_answers(${BINARY}/run_scripts actual)
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${BINARY}/expected ${BINARY}/actual
                RESULT_VARIABLE is_different)
if(is_different)
  message(FATAL_ERROR "${COMPILER} ${FLAGS}: ${BINARY}/actual is not ${BINARY}/expected")
endif()
file(SHA256 ${BINARY}/actual hash)
file(SIZE ${BINARY}/actual size)
message("${COMPILER} ${FLAGS}: ${size} bytes, SHA-256 ${hash}, same")
