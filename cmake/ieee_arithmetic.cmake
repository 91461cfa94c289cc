# Sets the floating-point arithmetic that the library's proofs assume, whatever flags the parent project sets:
# -ffast-math, -Ofast, -ffp-contract=fast, /fp:fast and others. src/base/ieee.hpp stops the compilation if it can detect
# that a wrong flag is still active.
#
# Of two options that contradict each other the later one counts. The compiler gets CMAKE_CXX_FLAGS first, then the
# options of the directory, of the target, of the libraries that the target links, and of the source file.

if(MSVC)
  set(WAYWRIGHT_IEEE_OPTIONS /fp:precise)
else()
  # The order matters. -fno-fast-math resets the settings of the options after it. -ffp-contract=on before it keeps
  # clang from warning that it overrides a parent's -ffp-contract=fast. -ffp-contract=off: a fused multiply-add rounds
  # once where the error bounds of the predicates count two roundings. -fno-math-errno changes no value: std::sqrt need
  # not set errno.
  set(WAYWRIGHT_IEEE_OPTIONS
      -ffp-contract=on
      -fno-fast-math
      -fno-unsafe-math-optimizations
      -fno-associative-math
      -fno-reciprocal-math
      -fno-finite-math-only
      -fsigned-zeros
      -fno-rounding-math
      -ffp-contract=off
      -fno-math-errno)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    list(APPEND WAYWRIGHT_IEEE_OPTIONS -ftrapping-math -fno-single-precision-constant)
    # When GCC vectorises code, it may fuse a multiplication with an addition despite -ffp-contract=off. On x86, it makes
    # a vfmaddsub of two products that lie side by side, if the code adds a number to one product and subtracts a number
    # from the other. So the library uses no instruction set with such instructions. For RISC-V, GCC fuses more. So for
    # all other processors, GCC vectorises nothing.
    include(CheckCXXCompilerFlag)
    check_cxx_compiler_flag("-mno-fma -mno-fma4 -mno-avx512f" WAYWRIGHT_HAS_X86_OPTIONS)
    if(WAYWRIGHT_HAS_X86_OPTIONS)
      list(APPEND WAYWRIGHT_IEEE_OPTIONS -mno-fma -mno-fma4 -mno-avx512f)
    else()
      list(APPEND WAYWRIGHT_IEEE_OPTIONS -fno-tree-vectorize)
    endif()
  else()
    # With -Ofast, clang assumes that the program flushes subnormal numbers to zero.
    list(APPEND WAYWRIGHT_IEEE_OPTIONS -fdenormal-fp-math=ieee)
    if(EMSCRIPTEN)
      # WebAssembly has one rounding mode, and clang warns about each option that names another.
      list(APPEND WAYWRIGHT_IEEE_OPTIONS -Wno-unsupported-floating-point-opt)
    endif()
  endif()
endif()

function(waywright_use_ieee_arithmetic target)
  # As one element: CMake removes elements that repeat one of the parent's elements, which would change the order.
  list(JOIN WAYWRIGHT_IEEE_OPTIONS " " options)
  target_compile_options(${target} PRIVATE "SHELL:${options}")
endfunction()
