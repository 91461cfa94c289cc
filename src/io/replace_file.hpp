#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>

#include "waywright/error.hpp"

namespace waywright::io {

/// A file that gets its new contents in one step, or not at all: the caller writes the contents to a temporary file in
/// the same folder, and commit() renames this file. The destructor removes the temporary file unless commit() has
/// succeeded.
class FileReplacement {
 public:
  /// Opens the temporary file. If this is not possible, stream() is null, and error() says why.
  explicit FileReplacement(const std::string& file_name);
  ~FileReplacement();
  FileReplacement(const FileReplacement&) = delete;
  FileReplacement& operator=(const FileReplacement&) = delete;

  /// The temporary file, or null.
  [[nodiscard]] std::FILE* stream() const { return file_; }
  /// Waits until the temporary file is on the disk, and gives it the name of the file. Returns whether this has
  /// succeeded. If not, the file has not changed.
  [[nodiscard]] bool commit();
  /// Records the system's reason for a failure to write to stream(), as errno gives it; 0 if it is not known.
  void note_fault(int fault) { static_cast<void>(keep(fault)); }
  /// The error for the last failure.
  [[nodiscard]] Error error() const;

 private:
  [[nodiscard]] bool follow_links();
  [[nodiscard]] bool close();
  [[nodiscard]] bool keep(int fault);

  std::string name_;  ///< as the caller gave it
  std::filesystem::path target_;
  std::string temporary_;  ///< the name of the temporary file; empty if there is none
  std::FILE* file_ = nullptr;
  int fault_ = 0;
  /// Whether the name belongs to neither a regular file nor a folder, for example to a device.
  bool is_special_ = false;
};

}  // namespace waywright::io
