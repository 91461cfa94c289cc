#pragma once

#include <cstdint>
#include <limits>

namespace waywright::memory {

/// Gives each search a number. A search writes its number into the array entries that it uses. An entry with another
/// number is from an earlier search and counts as empty. So the arrays need not be cleared between searches. This class
/// clears them only when the numbers run out.
class Stamp {
 public:
  [[nodiscard]] std::uint32_t value() const { return value_; }

  /// Starts a search: its number is the last number plus `step`. If the numbers run out, calls clear() on each array
  /// and starts again with `step`. If `step` is a power of two, an entry can also contain other data, in the bits below
  /// `step`.
  template <class... Arrays>
  void next(std::uint32_t step, Arrays&... arrays) {
    if (value_ > std::numeric_limits<std::uint32_t>::max() - step) [[unlikely]] {
      (arrays.clear(), ...);
      value_ = 0;
    }
    value_ += step;
  }

 private:
  std::uint32_t value_ = 0;
};

}  // namespace waywright::memory
