# What every target of this project is compiled with, whoever includes it.

set(WAYWRIGHT_SANITIZE "" CACHE STRING "Sanitizers for every target, as -fsanitize takes them: address,undefined")

function(waywright_target_defaults target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  # A fused multiply-add rounds once where the error bounds of the predicates count two roundings.
  target_compile_options(${target} PRIVATE -ffp-contract=off -fno-math-errno -Wall -Wextra -Wconversion -Wshadow)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # Its -O3 sees overlapping copies in every `"text" + string` (GCC bug 105651).
    target_compile_options(${target} PRIVATE -Wno-restrict)
  endif()
  if(WAYWRIGHT_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(WAYWRIGHT_SANITIZE)
    target_compile_options(
      ${target} PRIVATE -fsanitize=${WAYWRIGHT_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE -fsanitize=${WAYWRIGHT_SANITIZE})
  endif()
endfunction()

# For tests and benchmarks that look inside the library.
function(waywright_use_internals target)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_include_directories(${target} SYSTEM PRIVATE ${Boost_INCLUDE_DIRS})
endfunction()
