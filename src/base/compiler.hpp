#pragma once

#include <bit>
#include <cstring>
#include <type_traits>

/// This file contains all code that depends on the compiler. The other files are standard C++:
/// scripts/check_portable.py refuses constructs like these in other files. Each construct has a fallback for compilers
/// that do not have it.

#if defined(__GNUC__)
/// The compiler inlines each call of the function.
#define WAYWRIGHT_ALWAYS_INLINE [[gnu::always_inline]] inline
/// The compiler never inlines the function.
#define WAYWRIGHT_NO_INLINE [[gnu::noinline]]
#elif defined(_MSC_VER)
#define WAYWRIGHT_ALWAYS_INLINE __forceinline
#define WAYWRIGHT_NO_INLINE __declspec(noinline)
#else
#define WAYWRIGHT_ALWAYS_INLINE inline
#define WAYWRIGHT_NO_INLINE
#endif

namespace waywright::base {

/// Asks the processor to fetch the memory at `address` because the program will read it soon. This is a hint: it
/// changes no result, and every address is allowed.
WAYWRIGHT_ALWAYS_INLINE void prefetch([[maybe_unused]] const void* address) {
#if defined(__GNUC__) || defined(__clang__)
  __builtin_prefetch(address);
#endif
}

/// Like prefetch(), for memory that the program will write soon.
WAYWRIGHT_ALWAYS_INLINE void prefetch_to_write([[maybe_unused]] const void* address) {
#if defined(__GNUC__) || defined(__clang__)
  __builtin_prefetch(address, 1);
#endif
}

#if defined(__SIZEOF_INT128__)
#define WAYWRIGHT_HAS_UINT128
/// An unsigned integer of 128 bits. GCC and Clang have one on 64-bit targets.
__extension__ using UInt128 = unsigned __int128;
#endif

/// Whether std::thread can start a thread. It cannot in WebAssembly that is built without `-pthread`.
#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
inline constexpr bool kHasThreads = false;
#else
inline constexpr bool kHasThreads = true;
#endif

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
