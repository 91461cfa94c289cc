#include "io/replace_file.hpp"

#include <cerrno>
#include <system_error>
#include <utility>

#include "base/disk.hpp"
#include "text/text.hpp"

namespace waywright::io {

namespace fs = std::filesystem;

FileReplacement::FileReplacement(const std::string& file_name) : name_(file_name), target_(file_name) {
  if (!follow_links()) return;
  std::error_code ignored;
  const fs::file_status old = fs::status(target_, ignored);
  if (fs::is_directory(old)) {
    static_cast<void>(keep(EISDIR));
    return;
  }
  if (fs::exists(old) && !fs::is_regular_file(old)) {
    is_special_ = true;
    return;
  }
  constexpr std::size_t kLongestStem = 200;  // file systems allow names of 255 bytes
  const std::string stem = target_.filename().string().substr(0, kLongestStem);
  for (std::uint64_t attempt = 0; file_ == nullptr; ++attempt) {
    temporary_ = (target_.parent_path() / text::with_number(stem + ".tmp", attempt, "")).string();
    errno = 0;
    file_ = std::fopen(temporary_.c_str(), "wbx");
    if (file_ != nullptr || errno == EEXIST) continue;
    static_cast<void>(keep(errno));
    temporary_.clear();
    return;
  }
}

/// If the target is a symbolic link, replaces it by the file to which it leads. This file need not exist. Returns
/// whether the links come to an end.
bool FileReplacement::follow_links() {
  constexpr int kMostLinks = 40;  // as many as Linux follows
  std::error_code fault;
  for (int i = 0; fs::is_symlink(fs::symlink_status(target_, fault)); ++i) {
    if (i == kMostLinks) return keep(ELOOP);
    const fs::path next = fs::read_symlink(target_, fault);
    if (fault) return keep(fault.value());
    target_ = target_.parent_path() / next;  // if `next` is absolute, it replaces the whole name
  }
  return true;
}

FileReplacement::~FileReplacement() {
  static_cast<void>(close());
  if (!temporary_.empty()) std::remove(temporary_.c_str());  // allocates nothing
}

bool FileReplacement::commit() {
  errno = 0;
  if (std::fflush(file_) != 0 || !base::bring_to_disk(file_)) return keep(errno);
  if (!close()) return keep(errno);
  const std::string folder = target_.has_parent_path() ? target_.parent_path().string() : ".";
  std::error_code fault;
  const fs::file_status old = fs::status(target_, fault);
  if (fs::exists(old)) {
    fs::permissions(temporary_, old.permissions() & fs::perms::all, fault);
    if (fault) return keep(fault.value());
  }
  fs::rename(temporary_, target_, fault);
  if (fault) return keep(fault.value());
  temporary_.clear();
  base::bring_folder_to_disk(folder.c_str());
  return true;
}

Error FileReplacement::error() const {
  std::string message = name_ + ": cannot be written";
  if (is_special_) message += ": it is a device or a pipe, and no regular file";
  if (fault_ != 0) message += ": " + std::generic_category().message(fault_);
  return {ErrorCode::unwritable, std::move(message), {}, 0};
}

bool FileReplacement::close() {
  std::FILE* const file = std::exchange(file_, nullptr);
  return file == nullptr || std::fclose(file) == 0;
}

/// Keeps the reason for error(). Returns false.
bool FileReplacement::keep(int fault) {
  fault_ = fault;
  return false;
}

}  // namespace waywright::io
