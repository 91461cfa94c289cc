# Some standard libraries cannot read or write doubles (see src/base/number_text.hpp). This file tests the compiler, and
# finds a header library for each missing function: fast_float to read, fmt to write. Like Boost, only source files use
# them.

include(CheckCXXSourceCompiles)

function(waywright_check_numbers result code)
  set(CMAKE_CXX_STANDARD 20)
  set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
  check_cxx_source_compiles("#include <charconv>\nchar* f(char* a, char* b, double& x) { return ${code}; }" ${result})
endfunction()

waywright_check_numbers(WAYWRIGHT_STANDARD_READS_DOUBLES "std::from_chars(a, b, x).ec == std::errc{} ? a : b")
waywright_check_numbers(WAYWRIGHT_STANDARD_WRITES_DOUBLES
                        "std::to_chars(std::to_chars(a, b, x).ptr, b, x, std::chars_format::general, 5).ptr")

set(waywright_number_definitions)
set(waywright_number_includes)
if(NOT WAYWRIGHT_STANDARD_READS_DOUBLES)
  find_path(WAYWRIGHT_FAST_FLOAT_INCLUDE_DIR fast_float/fast_float.h)
  if(NOT WAYWRIGHT_FAST_FLOAT_INCLUDE_DIR)
    message(FATAL_ERROR "This compiler's standard library has no std::from_chars for double. Install fast_float "
                        "(Debian: libfast-float-dev) or set WAYWRIGHT_FAST_FLOAT_INCLUDE_DIR to the folder that has "
                        "fast_float/fast_float.h.")
  endif()
  list(APPEND waywright_number_definitions WAYWRIGHT_NUMBERS_BY_FAST_FLOAT)
  list(APPEND waywright_number_includes ${WAYWRIGHT_FAST_FLOAT_INCLUDE_DIR})
endif()
if(NOT WAYWRIGHT_STANDARD_WRITES_DOUBLES)
  find_path(WAYWRIGHT_FMT_INCLUDE_DIR fmt/format.h)
  if(NOT WAYWRIGHT_FMT_INCLUDE_DIR)
    message(FATAL_ERROR "This compiler's standard library has no std::to_chars for double. Install fmt (Debian: "
                        "libfmt-dev) or set WAYWRIGHT_FMT_INCLUDE_DIR to the folder that has fmt/format.h.")
  endif()
  list(APPEND waywright_number_definitions WAYWRIGHT_NUMBERS_BY_FMT)
  list(APPEND waywright_number_includes ${WAYWRIGHT_FMT_INCLUDE_DIR})
endif()

# For targets that compile base/number_text.cpp.
function(waywright_use_number_text target)
  target_compile_definitions(${target} PRIVATE ${waywright_number_definitions})
  target_include_directories(${target} SYSTEM PRIVATE ${waywright_number_includes})
endfunction()
