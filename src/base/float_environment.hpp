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

/// While an object of this class exists, the calling thread uses the floating-point settings that the library needs: it
/// rounds to nearest and keeps subnormal numbers, and no floating-point exception ends the program. The destructor
/// restores the thread's previous settings.
///
/// Each public function that computes in doubles first makes an object of this class. Threads that the function starts
/// use the same settings. If the function gives work to threads of a JobSystem, this work makes its own object.
///
/// The reason: a program may round in another direction (for interval arithmetic), flush subnormal numbers to zero (for
/// audio; GCC and Clang set this at the program's start if it is linked with -ffast-math), or trap exceptions (to find
/// its own errors). The error bounds of the predicates do not hold if a thread rounds in another direction. If a thread
/// treated subnormal numbers as zero, the library would accept a coordinate of 1e-310, and the lengths of paths between
/// crossings close to 0 would differ from their lengths on other machines.
///
/// Cost: a few instructions if the thread already uses these settings.
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
  // Defined in another file: a compiler then cannot move arithmetic across the calls.
  void switch_to_standard();
  void switch_back();

#if defined(WAYWRIGHT_FLOAT_CONTROL_SSE)
  /// All bits of the register MXCSR except its six exception flags: handling of subnormals, exception masks, rounding.
  static constexpr std::uint32_t kControlBits = 0xffc0;
  static constexpr std::uint32_t kStandardControl = 0x1f80;  ///< all exceptions are masked, no other bit is set
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
  /// Returns the register FPCR. It is 0 at a program's start.
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
