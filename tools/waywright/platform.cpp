#include "platform.hpp"

#if defined(_WIN32)
#include <cstdio>
#include <fcntl.h>
#include <initializer_list>
#include <io.h>
#include <windows.h>
#else
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace waywright::command {

#if defined(_WIN32)

namespace {

HANDLE handle_of(std::FILE* stream) {
  return reinterpret_cast<HANDLE>(_get_osfhandle(_fileno(stream)));  // NOLINT(performance-no-int-to-ptr)
}

std::optional<FileIdentity> identity_of(HANDLE handle) {
  BY_HANDLE_FILE_INFORMATION about{};
  if (GetFileType(handle) != FILE_TYPE_DISK || GetFileInformationByHandle(handle, &about) == 0) return std::nullopt;
  if ((about.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0) return std::nullopt;
  return FileIdentity{about.dwVolumeSerialNumber,
                      static_cast<std::uint64_t>(about.nFileIndexHigh) << 32U | about.nFileIndexLow};
}

}  // namespace

// Windows has no signal for a broken pipe. Binary mode stops Windows from changing line ends.
void prepare_standard_streams() {
  for (std::FILE* stream : {stdin, stdout, stderr}) _setmode(_fileno(stream), _O_BINARY);
}

// A terminal that does not understand escape sequences does not count as a terminal.
bool error_is_terminal() {
  const HANDLE console = handle_of(stderr);
  DWORD mode = 0;
  return _isatty(_fileno(stderr)) != 0 && GetConsoleMode(console, &mode) != 0 &&
         SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

std::optional<FileIdentity> identity_of(const std::filesystem::path& file) {
  const HANDLE handle = CreateFileW(file.c_str(), 0, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr,
                                    OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
  if (handle == INVALID_HANDLE_VALUE) return std::nullopt;
  const std::optional<FileIdentity> identity = identity_of(handle);
  CloseHandle(handle);
  return identity;
}

std::optional<FileIdentity> identity_of(StandardStream stream) {
  return identity_of(handle_of(stream == StandardStream::input    ? stdin
                               : stream == StandardStream::output ? stdout
                                                                  : stderr));
}

bool is_writable(const std::filesystem::path& file) { return _waccess(file.c_str(), 2) == 0; }

// On Windows a new file gets its owner and its permissions from its folder.
bool copy_owner(const std::filesystem::path& /*from*/, const std::filesystem::path& /*to*/) { return true; }

#else

namespace {

int descriptor_of(StandardStream stream) {
  switch (stream) {
    case StandardStream::input:
      return STDIN_FILENO;
    case StandardStream::output:
      return STDOUT_FILENO;
    case StandardStream::error:
      break;
  }
  return STDERR_FILENO;
}

std::optional<FileIdentity> identity_of(const struct stat& status) {
  if (!S_ISREG(status.st_mode)) return std::nullopt;
  return FileIdentity{static_cast<std::uint64_t>(status.st_dev), static_cast<std::uint64_t>(status.st_ino)};
}

}  // namespace

void prepare_standard_streams() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  // Opens /dev/null in place of a closed descriptor, in the wrong direction: so each read or write on it still fails.
  // open() takes the lowest unused descriptor, which is this one.
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(descriptor, F_GETFD) != -1 || errno != EBADF) continue;
    static_cast<void>(::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY));
  }
}

bool error_is_terminal() { return ::isatty(STDERR_FILENO) == 1; }

std::optional<FileIdentity> identity_of(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return std::nullopt;
  return identity_of(status);
}

std::optional<FileIdentity> identity_of(StandardStream stream) {
  struct stat status {};
  if (::fstat(descriptor_of(stream), &status) != 0) return std::nullopt;
  return identity_of(status);
}

bool is_writable(const std::filesystem::path& file) { return ::access(file.c_str(), W_OK) == 0; }

bool copy_owner(const std::filesystem::path& from, const std::filesystem::path& to) {
  struct stat wanted {};
  struct stat actual {};
  if (::stat(from.c_str(), &wanted) != 0 || ::stat(to.c_str(), &actual) != 0) return false;
  if (wanted.st_uid == actual.st_uid && wanted.st_gid == actual.st_gid) return true;
  return ::chown(to.c_str(), wanted.st_uid, wanted.st_gid) == 0;
}

#endif

}  // namespace waywright::command
