#pragma once

namespace waywright::command {

/// The exit status of the command.
enum ExitStatus : int {
  kDone = 0,
  kRefused = 1,   ///< a check failed, logs differ or, with --strict, an operation was refused
  kUnusable = 2,  ///< bad arguments, a file that cannot be read or written, malformed text
};

}  // namespace waywright::command
