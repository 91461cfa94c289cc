#pragma once

#include <cstdint>
#include <limits>

namespace waywright::memory {

/// The number of a search. A search writes it into the entries of arrays that it uses; an entry with another number is
/// from an earlier search and counts as empty. So no array is cleared between searches, until the numbers run out.
class Stamp {
 public:
  [[nodiscard]] std::uint32_t value() const { return value_; }

  /// Starts a search: takes the number `step` higher than the last one. Calls clear() on each array when the numbers
  /// begin again. Entries may hold bits below `step` beside the number, if `step` is a power of two.
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
