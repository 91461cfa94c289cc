#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace waywright::memory {

/// An array that grows and whose new values are all zero bits. Unlike std::vector it does not write them: the system
/// hands out large pieces of memory as zeros, and gives them a place in memory only where they are written. So what a
/// program pays for is what it uses, not what it has room for.
template <class Value>
class ZeroedArray {
  static_assert(std::is_trivially_copyable_v<Value> && std::is_trivially_destructible_v<Value>);

 public:
  ZeroedArray() = default;
  ZeroedArray(ZeroedArray&& other) noexcept
      : values_(std::move(other.values_)), size_(std::exchange(other.size_, std::size_t{0})) {}
  ZeroedArray& operator=(ZeroedArray&& other) noexcept {
    values_ = std::move(other.values_);
    size_ = std::exchange(other.size_, std::size_t{0});
    return *this;
  }

  /// Makes room for the values of indices below `count`. Values that were there stay.
  void cover(std::size_t count) {
    if (count > size_) [[unlikely]]
      grow(std::max(count, size_ + size_ / 2));
  }
  /// Sets all values to zero bits.
  void clear() {
    if (size_ != 0) std::memset(static_cast<void*>(values_.get()), 0, size_ * sizeof(Value));
  }

  // Requires: there is room.
  [[nodiscard]] const Value& operator[](std::size_t index) const { return values_.get()[index]; }
  [[nodiscard]] Value& operator[](std::size_t index) { return values_.get()[index]; }

 private:
  struct Free {
    void operator()(Value* values) const { std::free(values); }
  };

  void grow(std::size_t size) {
    std::unique_ptr<Value, Free> values(static_cast<Value*>(std::calloc(size, sizeof(Value))));
    if (values == nullptr) fail();
    if (size_ != 0) std::memcpy(static_cast<void*>(values.get()), values_.get(), size_ * sizeof(Value));
    values_ = std::move(values);
    size_ = size;
  }
  /// Throws std::bad_alloc, also where this code is compiled without exceptions: asks for more memory than there is.
  [[noreturn]] static void fail() {
    volatile std::size_t too_much = std::numeric_limits<std::size_t>::max() / 2;
    for (;;) ::operator delete(::operator new(too_much));
  }

  std::unique_ptr<Value, Free> values_;
  std::size_t size_ = 0;
};

}  // namespace waywright::memory
