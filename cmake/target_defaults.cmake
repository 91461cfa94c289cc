# The options with which every target of this project is compiled, whichever project includes it.

include(${CMAKE_CURRENT_LIST_DIR}/ieee_arithmetic.cmake)

set(WAYWRIGHT_SANITIZE "" CACHE STRING "Sanitizers for every target, as -fsanitize takes them: address,undefined")

# CMake also sets MSVC for clang-cl, which accepts the same flags.
function(waywright_warnings target)
  if(MSVC)
    target_compile_options(${target} PRIVATE /W4 /permissive- /utf-8 $<$<BOOL:${WAYWRIGHT_WARNINGS_AS_ERRORS}>:/WX>)
    return()
  endif()
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Wshadow)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # At -O3, GCC reports overlapping copies in every `"text" + string` (GCC bug 105651).
    target_compile_options(${target} PRIVATE -Wno-restrict)
  endif()
  if(WAYWRIGHT_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

function(waywright_target_defaults target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  # Files of one target share local names, so they must not be compiled together (CMAKE_UNITY_BUILD).
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF UNITY_BUILD OFF)
  waywright_use_ieee_arithmetic(${target})
  waywright_warnings(${target})
  if(WAYWRIGHT_SANITIZE)
    target_compile_options(
      ${target} PRIVATE -fsanitize=${WAYWRIGHT_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE -fsanitize=${WAYWRIGHT_SANITIZE})
  endif()
endfunction()

# For tests and benchmarks that use the library's internals.
function(waywright_use_internals target)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  waywright_use_boost(${target})
  waywright_use_number_text(${target})
endfunction()

# For targets whose own sources include Boost's headers. A target that links them does not need Boost.
function(waywright_use_boost target)
  target_include_directories(
    ${target} SYSTEM PRIVATE $<TARGET_PROPERTY:Boost::headers,INTERFACE_INCLUDE_DIRECTORIES>)
endfunction()

# waywright_find(PACKAGE VERSION PURPOSE OPTION): finds a package that one component of the project needs. If it is
# missing, says what to do.
macro(waywright_find package version purpose option)
  find_package(${package} ${version} QUIET)
  if(NOT ${package}_FOUND)
    message(
      FATAL_ERROR
        "${purpose} the package ${package} ${version}, which CMake does not find. Install it (scripts/packages.txt \
names Debian's packages), say where it is with CMAKE_PREFIX_PATH, or build without it: -D${option}=OFF.")
  endif()
endmacro()
