#include "memory/compact_array.hpp"

namespace waywright::memory {

namespace {

/// Makes room for `count` elements more. The capacity grows by a factor, as for push_back().
template <class Value>
void make_room(Array<Value>& list, std::size_t count) {
  if (list.capacity() - list.size() < count) list.reserve(std::max(2 * list.capacity(), list.size() + count));
}

}  // namespace

// After make_room(), no step allocates. So if memory runs out, the array keeps its size.
void CompactArray::append(std::size_t count, std::uint32_t value) {
  if (blocks_.empty()) {
    values_.resize(size_ + count, value);
    size_ += count;
    return;
  }
  const std::size_t new_blocks = (count + kBlockSize - 1) / kBlockSize;
  make_room(blocks_, new_blocks);
  make_room(wide_, new_blocks + 1);
  for (; count > 0; --count) {
    if (size_ % kBlockSize == 0) blocks_.push_back({value & ~kWide, {}});
    ++size_;
    set_in_block(size_ - 1, value);
  }
}

void CompactArray::truncate(std::size_t size) {
  if (!blocks_.empty()) unpack();
  values_.resize(size);
  size_ = size;
}

void CompactArray::pack() {
  if (values_.empty()) return;
  CompactArray packed;
  packed.size_ = size_;
  packed.blocks_.reserve((size_ + kBlockSize - 1) / kBlockSize);
  for (std::size_t i = 0; i < size_; i += kBlockSize) {
    packed.add_block(&values_[i], std::min(kBlockSize, size_ - i));
    if (packed.is_smaller_if_plain()) return;
  }
  *this = std::move(packed);
}

void CompactArray::add_block(const std::uint32_t* values, std::size_t count) {
  const auto [least, largest] = std::minmax_element(values, values + count);
  if (*largest < kWide && *largest - *least <= kLargestDifference) {
    Block block{*least, {}};
    for (std::size_t i = 0; i < count; ++i) block.differences[i] = static_cast<std::uint8_t>(values[i] - *least);
    blocks_.push_back(block);
  } else {
    WideBlock wide{};
    std::copy(values, values + count, wide.begin());
    wide_.push_back(wide);
    blocks_.push_back({kWide | static_cast<std::uint32_t>(wide_.size() - 1), {}});
  }
}

void CompactArray::set_in_block(std::size_t i, std::uint32_t value) {
  Block& block = blocks_[i / kBlockSize];
  if ((block.base & kWide) == 0) {
    const std::uint32_t difference = value - block.base;  // very large if `value` is less than the base
    if (value < kWide && difference <= kLargestDifference) {
      block.differences[i % kBlockSize] = static_cast<std::uint8_t>(difference);
      return;
    }
    WideBlock wide;
    for (std::size_t k = 0; k < kBlockSize; ++k) wide[k] = block.base + block.differences[k];
    wide_.push_back(wide);
    block.base = kWide | static_cast<std::uint32_t>(wide_.size() - 1);
  }
  wide_[block.base & ~kWide][i % kBlockSize] = value;
}

void CompactArray::shrink_to_fit() {
  if (!blocks_.empty() && is_smaller_if_plain()) unpack();
  shrink(values_, blocks_, wide_);
}

void CompactArray::unpack() {
  Array<std::uint32_t> values;
  values.reserve(size_);
  for (std::size_t i = 0; i < size_; i += kBlockSize) {
    for_each(i, std::min(kBlockSize, size_ - i), [&](std::uint32_t value) { values.push_back(value); });
  }
  *this = CompactArray(std::move(values));
}

}  // namespace waywright::memory
