#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

/// The functions of the operating system that the command needs beyond the standard library. A port to another system
/// changes only platform.cpp.
namespace waywright::command {

enum class StandardStream : unsigned char { input, output, error };

/// Identifies a regular file, whatever names lead to it.
struct FileIdentity {
  std::uint64_t device = 0;
  std::uint64_t number = 0;

  friend bool operator==(const FileIdentity&, const FileIdentity&) = default;
};

/// Makes the read or write call report every failure of a standard stream: a closed stream, a reader that has ended, a
/// file that grows beyond the user's limit. Call it first: otherwise a file that is opened while a standard stream is
/// closed would take that stream's descriptor.
void prepare_standard_streams();

[[nodiscard]] bool error_is_terminal();

/// Returns the identity of the regular file that a name leads to, after following links, or null if there is no such
/// file.
[[nodiscard]] std::optional<FileIdentity> identity_of(const std::filesystem::path& file);

/// Returns the identity of the regular file that a standard stream reads or writes, or null for a terminal, a pipe, ...
[[nodiscard]] std::optional<FileIdentity> identity_of(StandardStream stream);

/// Returns whether the user may write to an existing file. Sets errno if not.
[[nodiscard]] bool is_writable(const std::filesystem::path& file);

/// Gives `to` the owner and the group of `from`. Returns false if the user may not do so.
[[nodiscard]] bool copy_owner(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace waywright::command
