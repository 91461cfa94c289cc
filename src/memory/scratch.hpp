#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace waywright::memory {

/// Returns memory for `count` values of `size` bytes each, as std::calloc does: all bits are zero, and null if there is
/// not enough memory.
///
/// These three functions have a source file of their own. So a program that links the static library can
/// replace all of them, as it can replace `operator new`. The library for C programs (`bindings/c`) does this for its
/// allocator hooks.
[[nodiscard]] void* allocate_zeroed(std::size_t count, std::size_t size) noexcept;
/// Frees memory that allocate_zeroed() has returned, or does nothing for null.
void free_zeroed(void* memory) noexcept;

/// Returns whether the library may map pages (Arena), which take memory directly from the operating system.
[[nodiscard]] bool may_map_pages() noexcept;

/// An array that can grow. All bits of a new value are zero, but unlike std::vector the array does not write them: the
/// operating system provides large blocks of memory as zeros, and assigns physical memory to an address only when the
/// program writes there. So only the values that a program writes take physical memory.
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

  /// Makes room for the indices below `count`. Keeps the present values.
  void grow_to(std::size_t count) {
    if (count > size_) [[unlikely]]
      grow(std::max(count, size_ + size_ / 2));
  }
  /// The number of values for which there is room.
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Sets all values to zero bits.
  void clear() {
    if (size_ != 0) std::memset(static_cast<void*>(values_.get()), 0, size_ * sizeof(Value));
  }

  // Requires: grow_to() has made room for `index`.
  [[nodiscard]] const Value& operator[](std::size_t index) const { return values_.get()[index]; }
  [[nodiscard]] Value& operator[](std::size_t index) { return values_.get()[index]; }

 private:
  struct Free {
    void operator()(Value* values) const { free_zeroed(values); }
  };

  void grow(std::size_t size) {
    std::unique_ptr<Value, Free> values(static_cast<Value*>(allocate_zeroed(size, sizeof(Value))));
    if (values == nullptr) fail();
    if (size_ != 0) std::memcpy(static_cast<void*>(values.get()), values_.get(), size_ * sizeof(Value));
    values_ = std::move(values);
    size_ = size;
  }
  /// Throws std::bad_alloc: asks `operator new` for more memory than any machine has. This also works in code that is
  /// compiled without exceptions.
  [[noreturn]] static void fail() {
    volatile std::size_t too_much = std::numeric_limits<std::size_t>::max() / 2;
    for (;;) ::operator delete(::operator new(too_much));
  }

  std::unique_ptr<Value, Free> values_;
  std::size_t size_ = 0;
};

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
