#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

/// What the command needs of the operating system beyond the standard library. A port to another system changes
/// platform.cpp alone.
namespace waywright::command {

enum class StandardStream : unsigned char { input, output, error };

/// Tells regular files apart, whatever names lead to them.
struct FileIdentity {
  std::uint64_t device = 0;
  std::uint64_t number = 0;

  friend bool operator==(const FileIdentity&, const FileIdentity&) = default;
};

/// Makes every failure of a standard stream an error of the call that reads or writes: a stream that is closed, a
/// reader that goes away, a file that grows beyond the user's limit. Call it first: a file opened while a standard
/// stream is closed would take that stream's place.
void prepare_standard_streams();

[[nodiscard]] bool error_is_terminal();

/// The identity of the regular file that a name leads to, links followed; null where there is no such file.
[[nodiscard]] std::optional<FileIdentity> identity_of(const std::filesystem::path& file);

/// The identity of the regular file that a standard stream reads or writes; null where it is a terminal, a pipe, ...
[[nodiscard]] std::optional<FileIdentity> identity_of(StandardStream stream);

/// Whether the user may write to an existing file; sets errno where not.
[[nodiscard]] bool is_writable(const std::filesystem::path& file);

/// Gives `to` the owner and the group of `from`. Returns false where the user may not do so.
[[nodiscard]] bool copy_owner(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace waywright::command
