#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "platform.hpp"

namespace waywright::command {

/// Returns whether a text written to that name goes to standard output: `-`, `/dev/stdout` or another name of this
/// stream, or a link to one of these.
[[nodiscard]] bool is_standard_output(const std::string& name);

/// Returns whether a name stands for an open descriptor: `/dev/stderr`, `/dev/fd/3`, `/proc/self/fd/3`.
[[nodiscard]] bool is_descriptor(const std::filesystem::path& name);

/// Follows a chain of symbolic links to its end or to a descriptor, and returns that name. No file need exist there.
/// Returns a link if the chain is too long.
[[nodiscard]] std::filesystem::path followed(std::filesystem::path name);

/// Returns where the command's answers go if it also writes the given files: to standard output or, if one of the files
/// goes there, to standard error.
[[nodiscard]] StandardStream stream_beside(const std::vector<std::string>& files);

/// A file that the command line names.
struct NamedFile {
  std::string_view argument;  ///< `SCRIPT`, `--dump`, ...
  std::string name;           ///< empty for no file, `-` for standard input or output
};

/// Throws Failure if an output is the same file as an input, as another output, or as the file of a standard stream,
/// under whatever name. Call it before anything is written.
void refuse_shared_files(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

}  // namespace waywright::command
