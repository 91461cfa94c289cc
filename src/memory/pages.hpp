#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "waywright/memory_use.hpp"

#include "base/compiler.hpp"
#include "memory/count.hpp"

namespace waywright::memory {

/// Values by index, in pages that come with the first value there, for what most of a large world has no use for. A
/// page stays, so that what was once written can be written again without memory. A new page's values are Value{}.
template <class Value>
class Pages {
 public:
  /// Makes this a place for the values of indices below `count`.
  void cover(std::size_t count) {
    if (pages_.size() * kPageSize < count) pages_.resize((count + kPageSize - 1) / kPageSize);
  }
  [[nodiscard]] bool has_room(std::size_t index) const { return pages_[index / kPageSize] != nullptr; }
  void make_room(std::size_t index) {
    if (!has_room(index)) [[unlikely]]
      add_page(index / kPageSize);
  }

  // Requires: there is room.
  [[nodiscard]] const Value& operator[](std::size_t index) const {
    return (*pages_[index / kPageSize])[index % kPageSize];
  }
  [[nodiscard]] Value& operator[](std::size_t index) { return (*pages_[index / kPageSize])[index % kPageSize]; }

  /// Drops all values and their memory.
  void clear() {
    for (std::unique_ptr<Page>& page : pages_) page.reset();
    page_count_ = 0;
  }

  void count_memory(MemoryUse& use, std::size_t MemoryUse::*part) const {
    memory::count(use, part, pages_);
    use.*part += page_count_ * sizeof(Page);
  }
  /// Gives back what the table of pages has ready to grow into. Pages stay.
  void shrink_to_fit() { memory::shrink(pages_); }

 private:
  static constexpr std::size_t kPageSize = 1024;
  using Page = std::array<Value, kPageSize>;

  WAYWRIGHT_NO_INLINE void add_page(std::size_t index) {
    pages_[index] = std::make_unique<Page>();
    ++page_count_;
  }

  std::vector<std::unique_ptr<Page>> pages_;  ///< null where there never was a value
  std::size_t page_count_ = 0;
};

}  // namespace waywright::memory
