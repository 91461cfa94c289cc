#pragma once

#include <bit>
#include <cstring>
#include <type_traits>

namespace waywright::base {

/// Does what std::bit_cast does; libc++ has that function from version 14 on only. A constant expression only where the
/// standard library has std::bit_cast.
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
