#pragma once

#include <bit>
#include <cstring>
#include <type_traits>

namespace waywright::base {

/// Does what std::bit_cast does, also with libc++ before version 14, which has no std::bit_cast. In that case, a call
/// is not a constant expression.
template <class To, class From>
[[nodiscard]] constexpr To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From>);
#if defined(__cpp_lib_bit_cast)
  return std::bit_cast<To>(from);
#else
  To to;
  std::memcpy(&to, &from, sizeof(To));
  return to;
#endif
}

}  // namespace waywright::base
