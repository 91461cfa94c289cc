#include "base/system.hpp"

#if defined(_WIN32)
#include <io.h>
#else
#include <cerrno>
#include <fcntl.h>
#include <unistd.h>
#endif
#if defined(__linux__)
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#endif

namespace waywright::base {

#if defined(__linux__) && defined(SYS_memfd_create)

namespace {

/// Some C libraries lack the function memfd_create(), so the code makes the system call itself. A new kernel wants to
/// be told that the file contains no program; an old one refuses the flag for this.
int make_descriptor() noexcept {
  constexpr unsigned kCloseOnExec = 1;
  constexpr unsigned kNoProgram = 8;
  const auto descriptor = ::syscall(SYS_memfd_create, "waywright", kCloseOnExec | kNoProgram);
  return static_cast<int>(descriptor >= 0 ? descriptor : ::syscall(SYS_memfd_create, "waywright", kCloseOnExec));
}

/// Whether files may be so large. If the program made a larger one, a signal would end it.
bool is_allowed(std::size_t size) noexcept {
  ::rlimit limit{};
  if (::getrlimit(RLIMIT_FSIZE, &limit) != 0) return false;
  return limit.rlim_cur == RLIM_INFINITY || size <= limit.rlim_cur;
}

std::byte* map_file(std::size_t size, int descriptor, int flags) noexcept {
  void* const address = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, flags, descriptor, 0);
  return address == MAP_FAILED ? nullptr : static_cast<std::byte*>(address);
}

}  // namespace

std::optional<PageFile> PageFile::make(std::size_t size) noexcept {
  if (!is_allowed(size)) return std::nullopt;
  const int descriptor = make_descriptor();
  if (descriptor < 0) return std::nullopt;
  PageFile file(size, descriptor);
  if (::ftruncate(descriptor, static_cast<::off_t>(size)) != 0) return std::nullopt;
  return file;
}

PageFile::~PageFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

bool PageFile::reserve(std::size_t start, std::size_t size) const noexcept {
  if (size == 0) return true;
  int result = 0;
  do {
    result = ::fallocate(descriptor_, 0, static_cast<::off_t>(start), static_cast<::off_t>(size));
  } while (result != 0 && errno == EINTR);
  return result == 0;
}

std::byte* PageFile::map() const noexcept { return map_file(size_, descriptor_, MAP_SHARED); }
std::byte* PageFile::map_copy() const noexcept { return map_file(size_, descriptor_, MAP_PRIVATE); }
void PageFile::unmap(std::byte* address, std::size_t size) noexcept { ::munmap(address, size); }

#else

std::optional<PageFile> PageFile::make(std::size_t /*size*/) noexcept { return std::nullopt; }
PageFile::~PageFile() = default;
bool PageFile::reserve(std::size_t /*start*/, std::size_t /*size*/) const noexcept { return false; }
std::byte* PageFile::map() const noexcept { return nullptr; }
std::byte* PageFile::map_copy() const noexcept { return nullptr; }
void PageFile::unmap(std::byte* /*address*/, std::size_t /*size*/) noexcept {}

#endif

#if defined(_WIN32)

bool bring_to_disk(std::FILE* file) { return ::_commit(::_fileno(file)) == 0; }

void bring_folder_to_disk(const char* /*folder*/) {}

#else

bool bring_to_disk(std::FILE* file) {
  return ::fsync(::fileno(file)) == 0 || errno == EINVAL || errno == ENOTSUP || errno == ENOSYS;
}

void bring_folder_to_disk(const char* folder) {
  const int descriptor = ::open(folder, O_RDONLY);
  if (descriptor < 0) return;
  static_cast<void>(::fsync(descriptor));
  ::close(descriptor);
}

#endif

}  // namespace waywright::base
