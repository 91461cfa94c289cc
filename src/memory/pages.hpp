#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "waywright/memory_use.hpp"

#include "base/compiler.hpp"
#include "memory/arena.hpp"
#include "memory/count.hpp"

namespace waywright::memory {

/// A sparse array: values by index, stored in pages. Use it for data that most vertices, edges or items of a large
/// world do not have: make_room() allocates a page only when its first value needs room. A page is not freed before
/// clear(), so a program can write a value again without an allocation if it has written the value before. The values
/// of a new page are Value{}. A page has kPageSize values. If an object is made by a copy in an arena, the arena must
/// outlive it.
template <class Value, std::size_t kPageSize = 1024>
class Pages {
 public:
  Pages() = default;
  /// Copies the values. If an ArenaScope exists, makes the copy of each page in its arena.
  /// Cost: linear in the length of the table of pages and in the values of the pages.
  Pages(const Pages& other) : Pages() {
    pages_.resize(other.pages_.size());
    page_count_ = other.page_count_;
    if constexpr (base::kHasPageFiles) arena_ = ArenaScope::arena();
    for (std::size_t i = 0; i < pages_.size(); ++i) {
      if (other.pages_[i] != nullptr) pages_[i] = copy(*other.pages_[i]);
    }
  }
  Pages(Pages&& other) noexcept { swap(other); }
  Pages& operator=(const Pages&) = delete;
  Pages& operator=(Pages&& other) noexcept {
    Pages old(std::move(*this));
    swap(other);
    return *this;
  }
  ~Pages() { clear(); }

  /// Makes the table of pages large enough for the indices below `count`. Allocates no page.
  void grow_to(std::size_t count) {
    if (pages_.size() * kPageSize < count) pages_.resize((count + kPageSize - 1) / kPageSize);
  }
  [[nodiscard]] bool has_room(std::size_t index) const { return pages_[index / kPageSize] != nullptr; }
  void make_room(std::size_t index) {
    if (!has_room(index)) [[unlikely]]
      add_page(index / kPageSize);
  }

  /// The value, or null if there is no room for it. `index` may be larger than grow_to() has allowed for.
  [[nodiscard]] const Value* find(std::size_t index) const {
    const std::size_t page = index / kPageSize;
    return page < pages_.size() && pages_[page] != nullptr ? &(*pages_[page])[index % kPageSize] : nullptr;
  }

  /// Prefetches the value, if there is room for it.
  WAYWRIGHT_ALWAYS_INLINE void prefetch(std::size_t index) const {
    if (const Value* const value = find(index)) base::prefetch_to_write(value);
  }

  // Requires: has_room(index).
  [[nodiscard]] const Value& operator[](std::size_t index) const {
    return (*pages_[index / kPageSize])[index % kPageSize];
  }
  [[nodiscard]] Value& operator[](std::size_t index) { return (*pages_[index / kPageSize])[index % kPageSize]; }

  /// Removes all values and frees their memory. (Pages in an arena stay there.)
  void clear() {
    for (Page*& page : pages_) free(std::exchange(page, nullptr));
    page_count_ = 0;
  }

  void count_memory(MemoryUse& use, std::size_t MemoryUse::*part) const {
    memory::count(use, part, pages_);
    use.*part += page_count_ * sizeof(Page);
  }
  /// Frees the unused capacity of the table of pages. Keeps the pages.
  void shrink_to_fit() { memory::shrink(pages_); }

 private:
  using Page = std::array<Value, kPageSize>;
  static_assert(std::is_trivially_copyable_v<Page> && alignof(Page) <= Arena::kAlignment);

  WAYWRIGHT_NO_INLINE void add_page(std::size_t index) {
    pages_[index] = new Page();
    ++page_count_;
  }
  [[nodiscard]] Page* copy(const Page& page) const {
    if (arena_ != nullptr) {
      if (void* const place = arena_->copy(&page, sizeof(Page), sizeof(Page))) return static_cast<Page*>(place);
    }
    return new Page(page);
  }
  void free(Page* page) const {
    if (arena_ == nullptr || !arena_->contains(page)) delete page;
  }
  void swap(Pages& other) noexcept {
    std::swap(pages_, other.pages_);
    std::swap(page_count_, other.page_count_);
    std::swap(arena_, other.arena_);
  }

  std::vector<Page*> pages_;  ///< null until the page has a value
  std::size_t page_count_ = 0;
  Arena* arena_ = nullptr;  ///< the arena in which some of the pages may lie, or null
};

}  // namespace waywright::memory
