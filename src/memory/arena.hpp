#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "base/system.hpp"

namespace waywright::memory {

/// Returns memory from `operator new`, or null if there is not enough. In code that is compiled without exceptions, the
/// program ends instead. (A program may have replaced `operator new` without the form that returns null, so the
/// function does not use this form.)
[[nodiscard]] void* try_allocate(std::size_t bytes) noexcept;

/// Memory for the arrays (Array, Pages) of a large object. There are two kinds. make() makes an arena for an object
/// that never changes again, the *base*. share() makes an arena for a copy of the base. The two share pages of memory:
/// the system copies a page only when the program first writes to it. So a copy takes little time to make, and takes
/// memory only for the pages in which it differs from the base.
///
///     const std::unique_ptr<Arena> arena = Arena::make(size);
///     const Large base = [&] { ArenaScope scope(*arena); return Large(original); }();  // copies the arrays
///     const std::unique_ptr<Arena> second = arena->share();
///     Large copy = [&] { ArenaScope scope(*second); return Large(base); }();  // `second` has the arrays already
///
/// An arena must outlive the objects with arrays in it. The base and its arena may be destroyed before the copies.
class Arena {
 public:
  /// Each array in an arena starts at a multiple of this number of bytes.
  static constexpr std::size_t kAlignment = 64;

  /// Returns an empty arena with room for `size` bytes, or null if the system cannot share pages. Room that contains no
  /// array takes no physical memory.
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
    const std::less<const void*> is_before;
    return !is_before(address, start_) && is_before(address, start_ + size_);
  }
  /// Returns memory in this arena that contains a copy of the `size` bytes at `original`, or null if the caller must
  /// take other memory. If make() has made this arena, the function copies the bytes, and leaves room for `capacity`
  /// bytes. It returns null if there is no room or no memory. If share() has made this arena, the function copies
  /// nothing: it returns the address in this arena that corresponds to `original`, or null if `original` is not in the
  /// arena of the base. Requires: in this case, the base still exists.
  [[nodiscard]] void* copy(const void* original, std::size_t size, std::size_t capacity) noexcept;

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

 private:
  Arena* outer_;  ///< the arena of the scope around this one, or null
};

}  // namespace waywright::memory
