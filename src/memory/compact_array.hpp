#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "waywright/memory_use.hpp"

#include "base/compiler.hpp"
#include "memory/array.hpp"
#include "memory/count.hpp"

namespace waywright::memory {

/// An array of 32-bit numbers. pack() stores the array in a third of the memory if the numbers of each block of 16
/// differ by at most 255. For each block, the array then stores the smallest number in 32 bits and, for each of the 16
/// numbers, the difference from the smallest one in 8 bits. If the numbers of a block differ by more, the block is
/// *wide*: it contains the index of an array of 16 numbers of 32 bits. The same functions change a packed array and a
/// plain one. If so many blocks become wide that the packed array takes more memory than a plain one
/// (at most 84 bytes instead of 64 for 16 numbers), shrink_to_fit() makes it plain again.
class CompactArray {
 public:
  CompactArray() = default;
  /// A plain array of these numbers.
  explicit CompactArray(Array<std::uint32_t>&& values) : values_(std::move(values)), size_(values_.size()) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::uint32_t operator[](std::size_t i) const {
    if (blocks_.empty()) return values_[i];
    const Block& block = blocks_[i / kBlockSize];
    if ((block.base & kWide) != 0) return wide_[block.base & ~kWide][i % kBlockSize];
    return block.base + block.differences[i % kBlockSize];
  }
  /// Calls visit(number) for `count` numbers from index `i` on. Requires: the numbers lie in one block of 16, which
  /// starts at a multiple of 16.
  template <class Visit>
  void for_each(std::size_t i, std::size_t count, Visit&& visit) const {
    const Block* const block = blocks_.empty() ? nullptr : &blocks_[i / kBlockSize];
    if (block != nullptr && (block->base & kWide) == 0) {
      for (std::size_t k = i % kBlockSize; count > 0; ++k, --count) visit(block->base + block->differences[k]);
    } else {
      for (const std::size_t end = i + count; i < end; ++i) visit((*this)[i]);
    }
  }
  /// Prefetches the memory that operator[] reads.
  WAYWRIGHT_ALWAYS_INLINE void prefetch(std::size_t i) const {
    if (blocks_.empty()) {
      base::prefetch(&values_[i]);
    } else {
      base::prefetch(&blocks_[i / kBlockSize]);
    }
  }

  /// If memory runs out, the array does not change. Cost: O(1), amortised.
  void set(std::size_t i, std::uint32_t value) {
    if (blocks_.empty()) {
      values_[i] = value;
    } else {
      set_in_block(i, value);
    }
  }
  /// Adds `count` copies of a number at the end. If memory runs out, the array does not change. Cost: O(count),
  /// amortised.
  void append(std::size_t count, std::uint32_t value);
  /// Removes the numbers from index `size` on. The array is plain afterwards. Cost: linear.
  void truncate(std::size_t size);

  /// Packs the array, if this saves memory. Requires: the array is plain. Cost: linear.
  void pack();

  void count_memory(MemoryUse& use, std::size_t MemoryUse::*part) const {
    count(use, part, values_);
    count(use, part, blocks_);
    count(use, part, wide_);
  }
  /// Frees spare memory. Cost: linear.
  void shrink_to_fit();

 private:
  static constexpr std::size_t kBlockSize = 16;
  static constexpr std::uint32_t kWide = 0x80000000;
  static constexpr std::uint32_t kLargestDifference = 255;

  using WideBlock = std::array<std::uint32_t, kBlockSize>;
  /// The number `i` of the block is base + differences[i]. If `base` contains the bit kWide, the other bits are the
  /// index of a wide block instead.
  struct Block {
    std::uint32_t base;
    std::array<std::uint8_t, kBlockSize> differences;
  };

  void set_in_block(std::size_t i, std::uint32_t value);
  void add_block(const std::uint32_t* values, std::size_t count);
  void unpack();
  [[nodiscard]] bool is_smaller_if_plain() const {
    return blocks_.size() * sizeof(Block) + wide_.size() * sizeof(WideBlock) > size_ * sizeof(std::uint32_t);
  }

  Array<std::uint32_t> values_;  ///< empty if the array is packed
  Array<Block> blocks_;          ///< empty if the array is plain
  Array<WideBlock> wide_;
  std::size_t size_ = 0;
};

}  // namespace waywright::memory
