#pragma once

#include <cstddef>
#include <cstdio>
#include <optional>
#include <utility>

// What the library asks of the operating system beyond the standard library.

namespace waywright::base {

/// Whether the code for page files exists for this system. PageFile::make() may still fail, for example in a sandbox.
#if defined(__linux__)
inline constexpr bool kHasPageFiles = true;
#else
inline constexpr bool kHasPageFiles = false;
#endif

/// A file in memory, without a name. A program maps the file into its address space: once, to write its contents, and
/// then as often as it wants, as private copies. A page of the file takes physical memory once, and once more for each
/// copy that has changed the page.
class PageFile {
 public:
  /// Makes a file of `size` zero bytes. A page takes memory when the program reserves or writes it. Returns nothing if
  /// the system refuses.
  [[nodiscard]] static std::optional<PageFile> make(std::size_t size) noexcept;
  PageFile(PageFile&& other) noexcept : size_(other.size_), descriptor_(std::exchange(other.descriptor_, -1)) {}
  PageFile& operator=(PageFile&& other) noexcept {
    std::swap(size_, other.size_);
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  /// Closes the file. The mappings stay valid.
  ~PageFile();

  /// Takes the memory for `size` bytes at `start`. Returns false if there is not enough memory. Without this call, the
  /// system would end the program if it has no memory for a page to which the program writes.
  [[nodiscard]] bool reserve(std::size_t start, std::size_t size) const noexcept;

  // The next two functions return null if the system refuses. The caller must call unmap().

  /// Maps the file. What the program writes to this memory, it writes to the file.
  [[nodiscard]] std::byte* map() const noexcept;
  /// Maps a private copy of the file. The system copies a page when the program first writes to it. Requires: from now
  /// on, nobody writes to the file.
  [[nodiscard]] std::byte* map_copy() const noexcept;
  static void unmap(std::byte* address, std::size_t size) noexcept;

 private:
  PageFile(std::size_t size, int descriptor) : size_(size), descriptor_(descriptor) {}

  std::size_t size_;
  int descriptor_;
};

/// Waits until the contents of an open file are on the disk. Returns false and sets errno if this fails. Files for
/// which the system has no such function count as written. Requires: the file's buffer is empty (std::fflush).
[[nodiscard]] bool bring_to_disk(std::FILE* file);

/// Waits until the names in a folder are on the disk, if the system has a function for this. Ignores failures.
void bring_folder_to_disk(const char* folder);

}  // namespace waywright::base
