#pragma once

#include <bit>
#include <cstring>
#include <type_traits>

namespace waywright::base {

/// std::bit_cast, which libc++ has from version 14 on only. Not a constant expression before that.
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
