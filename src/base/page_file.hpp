#pragma once

#include <cstddef>
#include <optional>
#include <utility>

namespace waywright::base {

/// Whether this system has page files. Elsewhere, PageFile::make() returns nothing.
#if defined(__linux__)
inline constexpr bool kHasPageFiles = true;
#else
inline constexpr bool kHasPageFiles = false;
#endif

/// A file in memory, without a name. A program maps its pages into its address space as often as it wants. The
/// mappings take physical memory only once for each page that no copy has changed.
class PageFile {
 public:
  /// Makes a file of `size` zero bytes. A page takes memory when the program writes to it. Returns nothing if the
  /// system has no page files or refuses.
  [[nodiscard]] static std::optional<PageFile> make(std::size_t size) noexcept;
  PageFile(PageFile&& other) noexcept : size_(other.size_), descriptor_(std::exchange(other.descriptor_, -1)) {}
  PageFile& operator=(PageFile&& other) noexcept {
    std::swap(size_, other.size_);
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  /// Closes the file. The mappings stay valid.
  ~PageFile();

  [[nodiscard]] std::size_t size() const { return size_; }

  // The next two functions return null if the system refuses. The caller must call unmap().

  /// Maps the file. What the program writes to this memory, it writes to the file.
  [[nodiscard]] std::byte* map() const noexcept;
  /// Maps a copy of the file. The system copies a page when the program writes to it, and writes never go to the file.
  /// Requires: from now on, nobody writes to the file.
  [[nodiscard]] std::byte* map_copy() const noexcept;
  static void unmap(std::byte* address, std::size_t size) noexcept;

 private:
  PageFile(std::size_t size, int descriptor) : size_(size), descriptor_(descriptor) {}

  std::size_t size_;
  int descriptor_;
};

}  // namespace waywright::base
