#include "base/page_file.hpp"

#if defined(__linux__)
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace waywright::base {

#if defined(__linux__)

namespace {

std::byte* map_file(std::size_t size, int descriptor, int kind) noexcept {
  void* const address = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, kind, descriptor, 0);
  return address == MAP_FAILED ? nullptr : static_cast<std::byte*>(address);
}

}  // namespace

// Some C libraries lack the function memfd_create(), so the code makes the system call itself.
std::optional<PageFile> PageFile::make(std::size_t size) noexcept {
  constexpr unsigned kCloseOnExec = 1;
  const int descriptor = static_cast<int>(::syscall(SYS_memfd_create, "waywright", kCloseOnExec));
  if (descriptor < 0) return std::nullopt;
  PageFile file(size, descriptor);
  if (::ftruncate(descriptor, static_cast<::off_t>(size)) != 0) return std::nullopt;
  return file;
}

PageFile::~PageFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::byte* PageFile::map() const noexcept { return map_file(size_, descriptor_, MAP_SHARED); }
std::byte* PageFile::map_copy() const noexcept { return map_file(size_, descriptor_, MAP_PRIVATE); }
void PageFile::unmap(std::byte* address, std::size_t size) noexcept { ::munmap(address, size); }

#else

std::optional<PageFile> PageFile::make(std::size_t /*size*/) noexcept { return std::nullopt; }
PageFile::~PageFile() = default;
std::byte* PageFile::map() const noexcept { return nullptr; }
std::byte* PageFile::map_copy() const noexcept { return nullptr; }
void PageFile::unmap(std::byte* /*address*/, std::size_t /*size*/) noexcept {}

#endif

}  // namespace waywright::base
