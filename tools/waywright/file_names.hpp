#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "platform.hpp"

namespace waywright::command {

/// Whether the text written there goes to standard output: `-`, `/dev/stdout` and the like, or a link to one of these.
[[nodiscard]] bool is_standard_output(const std::string& name);

/// Whether a name stands for a descriptor that is open already: `/dev/stderr`, `/dev/fd/3`, `/proc/self/fd/3`.
[[nodiscard]] bool is_descriptor(const std::filesystem::path& name);

/// Where a chain of symbolic links ends, or leads to a descriptor; the place itself may be free. A link again where the
/// chain is too long.
[[nodiscard]] std::filesystem::path followed(std::filesystem::path name);

/// Where answers go beside files of these names: to standard output or, where a file goes there, to standard error.
[[nodiscard]] StandardStream stream_beside(const std::vector<std::string>& files);

/// A file that the command line names.
struct NamedFile {
  std::string_view argument;  ///< `SCRIPT`, `--dump`, ...
  std::string name;           ///< empty: no file; `-`: standard input or output
};

/// Throws Failure where an output is the same file as an input or another output, whatever the names, or as what a
/// standard stream writes to or reads from. Nothing is written before.
void refuse_shared_files(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

}  // namespace waywright::command
