#pragma once

#include <cstdio>

/// What the C++ standard library does not know about the operating system. No other file of the command asks for it.
namespace waywright::command {

/// Prepares the standard streams, before anything is read or written: a reader of standard output that goes away
/// causes a write error, not the end of the process; and no byte is changed on the way, as Windows would change line
/// ends.
void prepare_streams();

/// Whether the stream is a terminal that understands escape sequences.
[[nodiscard]] bool is_terminal(std::FILE* stream);

}  // namespace waywright::command
