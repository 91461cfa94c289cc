#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "base/page_file.hpp"

namespace waywright::memory {

/// Memory for the arrays (Array, Pages) of a large object that does not change, the *base*, or of a copy of the base.
/// The base and its copies share pages: the system copies a page only when the program writes to it. So a copy takes
/// little time to make, and takes memory only for the pages in which it differs from the base.
///
///     const std::unique_ptr<Arena> arena = Arena::make(size);
///     const Large base = [&] { ArenaScope scope(*arena); return Large(original); }();  // copies the arrays
///     const std::unique_ptr<Arena> second = arena->share();
///     Large copy = [&] { ArenaScope scope(*second); return Large(base); }();  // `second` has the arrays already
///
/// An arena must outlive the objects with arrays in it. The arena of the base may be destroyed before those of the
/// copies.
class Arena {
 public:
  /// Returns an empty arena with room for `size` bytes, or null if the system cannot share pages. Memory that contains
  /// nothing takes only addresses.
  [[nodiscard]] static std::unique_ptr<Arena> make(std::size_t size);
  /// Returns an arena that shares the pages of this one, or null if the system refuses. Requires: make() has made this
  /// arena, and from now on, nobody writes to the arrays in it.
  [[nodiscard]] std::unique_ptr<Arena> share() const;
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;
  ~Arena() {
    if (start_ != nullptr) base::PageFile::unmap(start_, size_);
  }

  /// Returns whether the memory at this address belongs to the arena.
  [[nodiscard]] bool contains(const void* address) const {
    const auto* const place = static_cast<const std::byte*>(address);
    return !std::less<>()(place, static_cast<const std::byte*>(start_)) && std::less<>()(place, start_ + size_);
  }
  /// Returns the copy of a block of `size` bytes in this arena, or null if there is none. In an arena from share(),
  /// each block of the base has a copy already. In an arena from make(), the function makes one, and leaves room for
  /// `capacity` bytes.
  [[nodiscard]] void* copy(const void* block, std::size_t size, std::size_t capacity) noexcept;

 private:
  Arena(std::size_t size, const Arena* base) : size_(size), base_(base) {}

  std::optional<base::PageFile> file_;  ///< nothing in an arena from share()
  std::byte* start_ = nullptr;
  std::size_t size_;
  const Arena* base_;     ///< the arena whose pages this one shares, or null
  std::size_t used_ = 0;  ///< in bytes
};

/// While an object of this class exists, the copy constructors of Array and Pages on this thread use an arena.
class ArenaScope {
 public:
  explicit ArenaScope(Arena& arena);
  ArenaScope(const ArenaScope&) = delete;
  ArenaScope& operator=(const ArenaScope&) = delete;
  ~ArenaScope();

  /// Returns the arena of the scope on this thread, or null.
  [[nodiscard]] static Arena* arena();
};

}  // namespace waywright::memory
