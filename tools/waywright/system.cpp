#include "system.hpp"

#if defined(_WIN32)
#include <fcntl.h>
#include <initializer_list>
#include <io.h>
#include <windows.h>
#else
#include <csignal>
#include <unistd.h>
#endif

namespace waywright::command {

#if defined(_WIN32)

void prepare_streams() {
  // Windows has no signal for a broken pipe.
  for (std::FILE* stream : {stdin, stdout, stderr}) _setmode(_fileno(stream), _O_BINARY);
}

bool is_terminal(std::FILE* stream) {
  const int file = _fileno(stream);
  if (_isatty(file) == 0) return false;
  const auto console = reinterpret_cast<HANDLE>(_get_osfhandle(file));
  DWORD mode = 0;
  return GetConsoleMode(console, &mode) != 0 && SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

#else

void prepare_streams() { std::signal(SIGPIPE, SIG_IGN); }

bool is_terminal(std::FILE* stream) { return isatty(fileno(stream)) == 1; }

#endif

}  // namespace waywright::command
