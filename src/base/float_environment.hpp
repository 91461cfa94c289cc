#pragma once

#include <cstdint>

#include "base/ieee.hpp"

#if defined(__SSE2__) || defined(_M_X64) || (defined(_M_IX86_FP) && _M_IX86_FP >= 2)
#define WAYWRIGHT_FLOAT_CONTROL_SSE
#if !defined(__GNUC__)
#include <intrin.h>
#endif
#elif defined(__aarch64__) && defined(__GNUC__)
#define WAYWRIGHT_FLOAT_CONTROL_AARCH64
#elif defined(__wasm__)
#define WAYWRIGHT_FLOAT_CONTROL_NONE
#else
#include <cfenv>
#endif

namespace waywright::base {

/// As long as it lives, the calling thread computes as the library needs it: it rounds to nearest, keeps subnormal
/// numbers, and no floating-point exception ends the program. Afterwards the thread computes as before.
///
/// Each public function that computes in doubles makes one first. Threads that it starts compute as it does; work that
/// it hands to threads of others makes one, too. For a program may round in another direction (for interval
/// arithmetic), flush subnormal numbers to zero (for audio; GCC and clang set this at the program's start if it is
/// linked with -ffast-math), or trap exceptions (to find its own faults). The error bounds of the predicates do not
/// hold when a thread rounds in another direction. When it takes subnormal numbers for zero, a coordinate of 1e-310
/// would not be refused, and lengths of ways between crossings next to 0 would differ from those on other machines.
///
/// Cost: a few instructions where the thread computes so already.
class FloatEnvironment {
 public:
  FloatEnvironment() {
    if (!is_standard()) [[unlikely]]
      switch_to_standard();
  }
  ~FloatEnvironment() {
    if (is_switched_) [[unlikely]]
      switch_back();
  }
  FloatEnvironment(const FloatEnvironment&) = delete;
  FloatEnvironment& operator=(const FloatEnvironment&) = delete;

 private:
  [[nodiscard]] static bool is_standard() {
#if defined(WAYWRIGHT_FLOAT_CONTROL_SSE)
    return (control() & kControlBits) == kStandardControl;
#elif defined(WAYWRIGHT_FLOAT_CONTROL_AARCH64)
    return control() == 0;
#elif defined(WAYWRIGHT_FLOAT_CONTROL_NONE)
    return true;
#else
    return std::fegetround() == FE_TONEAREST;
#endif
  }
  // Functions in another file, so that no compiler moves arithmetic across them.
  void switch_to_standard();
  void switch_back();

#if defined(WAYWRIGHT_FLOAT_CONTROL_SSE)
  /// All of the register MXCSR but its six flags: what to do with subnormals, masks of exceptions, rounding.
  static constexpr std::uint32_t kControlBits = 0xffc0;
  static constexpr std::uint32_t kStandardControl = 0x1f80;  ///< all exceptions masked, nothing else
  [[nodiscard]] static std::uint32_t control() {
#if defined(__GNUC__)
    return __builtin_ia32_stmxcsr();
#else
    return _mm_getcsr();
#endif
  }
  static void set_control(std::uint32_t value) {
#if defined(__GNUC__)
    __builtin_ia32_ldmxcsr(value);
#else
    _mm_setcsr(value);
#endif
  }
#elif defined(WAYWRIGHT_FLOAT_CONTROL_AARCH64)
  /// The register FPCR, 0 at a program's start.
  [[nodiscard]] static std::uint64_t control() {
    std::uint64_t value = 0;
    __asm__ volatile("mrs %0, fpcr" : "=r"(value));
    return value;
  }
#endif

  bool is_switched_ = false;
  [[maybe_unused]] std::uint64_t before_ = 0;
};

}  // namespace waywright::base
