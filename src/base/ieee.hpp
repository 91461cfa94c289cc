#pragma once

// Checks that the compiler provides the arithmetic that every proof in this library assumes: IEEE 754 doubles, each
// operation rounded once, to nearest. Compiler flags can change this arithmetic, so every source file that computes in
// doubles includes this header, and the compiler refuses the flags that it can detect here. The CMake targets switch
// these flags off (cmake/ieee_arithmetic.cmake). base/float_environment.hpp handles the settings that a program changes
// at run time. No macro says whether a compiler fuses multiplications with additions. So this header refuses the
// instruction sets for which GCC ignores -ffp-contract=off, and tests/hostile compares the answers of builds with and
// without the flags that allow fused instructions.

#if (defined(__i386__) && !defined(__SSE2_MATH__)) || (defined(_M_IX86) && _M_IX86_FP < 2)
#error "Waywright cannot use the x87 unit, which rounds doubles twice: on 32-bit x86, add -msse2 -mfpmath=sse"
#endif
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error \
    "Waywright needs IEEE 754 arithmetic: compile its sources without -ffast-math and -Ofast, or use its CMake target"
#endif
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0
#error "Waywright needs infinities and NaNs: compile its sources without -ffinite-math-only, or use its CMake target"
#endif
// GCC 12 and later define these macros.
#if defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "Waywright needs IEEE 754 arithmetic: compile without -fassociative-math and -freciprocal-math"
#endif
// GCC uses these instructions in vectorised code despite -ffp-contract=off: see cmake/ieee_arithmetic.cmake.
#if defined(__GNUC__) && !defined(__clang__) && (defined(__FMA__) || defined(__FMA4__) || defined(__AVX512F__))
#error \
    "Waywright needs unfused multiplications: compile its sources with -mno-fma -mno-fma4 -mno-avx512f, or use its CMake target"
#endif
#if defined(_MSC_VER) && !defined(__clang__)
#pragma fp_contract(off)  // before Visual Studio 2022, /fp:precise fuses multiplications with additions
#endif

#include <cfloat>
#include <limits>

namespace waywright::base {

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53,
              "Waywright needs IEEE 754 doubles");
// 0: the compiler computes each type in its own precision; 1: it computes only `float` in the precision of `double`.
static_assert(
    FLT_EVAL_METHOD == 0 || FLT_EVAL_METHOD == 1,
    "Waywright needs doubles that are computed as doubles, without excess precision; on x86, add -mfpmath=sse");
static_assert(static_cast<double>(0.1f) != 0.1,
              "Waywright needs double constants: compile without "
              "-fsingle-precision-constant");

}  // namespace waywright::base
