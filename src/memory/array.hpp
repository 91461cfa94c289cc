#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <limits>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

#include "base/compiler.hpp"
#include "memory/arena.hpp"
#include "memory/count.hpp"

namespace waywright::memory {

/// An array that can grow, as std::vector, for values without destructors. Use it for the large arrays of a world: if
/// an ArenaScope exists, the copy constructor makes the copy in an arena, so that it can share pages with the original.
/// An array in an arena has some spare capacity. If it outgrows this, it moves to memory of its own.
template <class Value>
class Array {
  static_assert(std::is_trivially_copyable_v<Value> && std::is_trivially_destructible_v<Value>);
  static_assert(alignof(Value) <= Arena::kAlignment && alignof(Value) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);

 public:
  using value_type = Value;

  Array() = default;
  explicit Array(std::size_t size, const Value& value = Value()) { resize(size, value); }
  explicit Array(std::span<const Value> values) {
    reserve(values.size());
    std::copy_n(values.data(), values.size(), values_);
    size_ = values.size();
  }
  Array(const Array& other) { copy(other); }
  Array(Array&& other) noexcept { swap(other); }
  Array& operator=(const Array& other) { return *this = Array(other); }
  Array& operator=(Array&& other) noexcept {
    Array old(std::move(*this));
    swap(other);
    return *this;
  }
  ~Array() {
    if (!is_in_arena_) ::operator delete(values_);
  }
  void swap(Array& other) noexcept {
    std::swap(values_, other.values_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
    std::swap(is_in_arena_, other.is_in_arena_);
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t capacity() const { return capacity_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const Value* data() const { return values_; }
  [[nodiscard]] Value* data() { return values_; }
  [[nodiscard]] const Value* begin() const { return values_; }
  [[nodiscard]] Value* begin() { return values_; }
  [[nodiscard]] const Value* end() const { return values_ + size_; }
  [[nodiscard]] Value* end() { return values_ + size_; }
  [[nodiscard]] const Value& operator[](std::size_t i) const {
    assert(i < size_);
    return values_[i];
  }
  [[nodiscard]] Value& operator[](std::size_t i) {
    assert(i < size_);
    return values_[i];
  }
  [[nodiscard]] const Value& back() const { return (*this)[size_ - 1]; }
  [[nodiscard]] Value& back() { return (*this)[size_ - 1]; }

  // If memory runs out, none of these functions changes the array.

  void push_back(const Value& value) {
    if (size_ == capacity_) [[unlikely]] {
      const Value kept = value;  // it may lie in this array
      move_to(larger_capacity(size_ + 1));
      values_[size_++] = kept;
    } else {
      values_[size_++] = value;
    }
  }
  /// Cost: linear.
  void push_front(const Value& value) {
    push_back(value);
    std::rotate(begin(), end() - 1, end());
  }
  void pop_back() { --size_; }
  void clear() { size_ = 0; }
  /// Makes room for `capacity` values.
  void reserve(std::size_t capacity) {
    if (capacity > capacity_) move_to(capacity);
  }
  /// Removes the values from index `size` on, or appends copies of `value`.
  void resize(std::size_t size, const Value& value = Value()) {
    const Value kept = value;  // it may lie in this array
    if (size > capacity_) move_to(larger_capacity(size));
    if (size > size_) std::fill(values_ + size_, values_ + size, kept);
    size_ = size;
  }
  /// Frees the spare capacity. If there is no memory for a smaller array, or if the array is in an arena, does nothing.
  void shrink_to_fit() noexcept {
    if (size_ == capacity_ || is_in_arena_) return;
    if (size_ == 0) {
      *this = Array();
    } else if (void* const memory = try_allocate(size_ * sizeof(Value))) {
      move_to(memory, size_);
    }
  }

 private:
  WAYWRIGHT_NO_INLINE void copy(const Array& other) {
    if (other.size_ == 0) return;
    if constexpr (base::kHasPageFiles) {
      if (copy_in_arena(other)) return;
    }
    reserve(other.size_);
    std::copy_n(other.values_, other.size_, values_);
    size_ = other.size_;
  }
  bool copy_in_arena(const Array& other) {
    Arena* const arena = ArenaScope::arena();
    if (arena == nullptr) return false;
    const std::size_t capacity = other.is_in_arena_ ? other.capacity_ : with_spare(other.size_);
    void* const values = arena->copy(other.values_, other.size_ * sizeof(Value), capacity * sizeof(Value));
    if (values == nullptr) return false;
    values_ = static_cast<Value*>(values);
    size_ = other.size_;
    capacity_ = capacity;
    is_in_arena_ = true;
    return true;
  }
  [[nodiscard]] std::size_t larger_capacity(std::size_t least) const { return std::max(least, 2 * capacity_); }
  WAYWRIGHT_NO_INLINE void move_to(std::size_t capacity) {
    constexpr std::size_t kTooMuch = std::numeric_limits<std::size_t>::max() / 2;  // for every machine
    const bool is_too_large = capacity > kTooMuch / sizeof(Value);
    move_to(::operator new(is_too_large ? kTooMuch : capacity * sizeof(Value)), capacity);
  }
  void move_to(void* memory, std::size_t capacity) noexcept {
    Array moved;
    moved.values_ = static_cast<Value*>(memory);
    moved.capacity_ = capacity;
    std::copy_n(values_, size_, moved.values_);
    moved.size_ = size_;
    swap(moved);
  }

  Value* values_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
  bool is_in_arena_ = false;
};

}  // namespace waywright::memory
