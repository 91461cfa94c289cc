# Configures the project from the sources SOURCE in the folder BINARY, and checks the results and messages.

include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${BINARY})
set(configure ${CMAKE_COMMAND} -S ${SOURCE} -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER})
set(library_only -DWAYWRIGHT_BUILD_TESTS=OFF -DWAYWRIGHT_BUILD_TOOLS=OFF -DWAYWRIGHT_BUILD_EXAMPLES=OFF)

function(expect text pattern)
  if(NOT text MATCHES "${pattern}")
    message(FATAL_ERROR "expected ${pattern} in:\n${text}")
  endif()
endfunction()

# A build without a type would not be optimised, so the project sets a default and prints a message.
run(${configure} -B ${BINARY}/default ${library_only})
expect("${run_output}" "CMAKE_BUILD_TYPE is not set; building type Release")
file(STRINGS ${BINARY}/default/CMakeCache.txt build_type REGEX "^CMAKE_BUILD_TYPE:")
expect("${build_type}" "=Release$")

# If a package is missing, the message names the option that needs it and says what to do.
execute_process(COMMAND ${configure} -B ${BINARY}/missing -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON
                OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE status)
if(status EQUAL 0)
  message(FATAL_ERROR "CLI11 is missing, and nobody minds")
endif()
string(REGEX REPLACE "[ \n]+" " " output "${output}")
expect("${output}" "The command waywright needs the package CLI11 2.1.*-DWAYWRIGHT_BUILD_TOOLS=OFF")

# Users build with this preset, perhaps with a compiler that has more warnings than the project's compilers.
run(${CMAKE_COMMAND} -S ${SOURCE} --preset release -B ${BINARY}/release ${library_only})
file(STRINGS ${BINARY}/release/CMakeCache.txt warnings REGEX "^WAYWRIGHT_WARNINGS_AS_ERRORS:")
expect("${warnings}" "=OFF$")
