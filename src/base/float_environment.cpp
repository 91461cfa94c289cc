#include "base/float_environment.hpp"

namespace waywright::base {

void FloatEnvironment::switch_to_standard() {
  is_switched_ = true;
#if defined(WAYWRIGHT_FLOAT_CONTROL_SSE)
  before_ = control();
  set_control(kStandardControl);
#elif defined(WAYWRIGHT_FLOAT_CONTROL_AARCH64)
  before_ = control();
  __asm__ volatile("msr fpcr, %0" : : "r"(std::uint64_t{0}));
#elif !defined(WAYWRIGHT_FLOAT_CONTROL_NONE)
  before_ = static_cast<std::uint64_t>(std::fegetround());
  std::fesetround(FE_TONEAREST);
#endif
}

void FloatEnvironment::switch_back() {
#if defined(WAYWRIGHT_FLOAT_CONTROL_SSE)
  set_control(static_cast<std::uint32_t>(before_));
#elif defined(WAYWRIGHT_FLOAT_CONTROL_AARCH64)
  __asm__ volatile("msr fpcr, %0" : : "r"(before_));
#elif !defined(WAYWRIGHT_FLOAT_CONTROL_NONE)
  std::fesetround(static_cast<int>(before_));
#endif
}

}  // namespace waywright::base
