#include "base/disk.hpp"

#if defined(_WIN32)
#include <io.h>
#else
#include <cerrno>
#include <fcntl.h>
#include <unistd.h>
#endif

namespace waywright::base {

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
