#include "output.hpp"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "failure.hpp"
#include "file_names.hpp"

namespace waywright::command {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPiece = std::size_t{1} << 16;

std::FILE* file_of(StandardStream stream) { return stream == StandardStream::output ? stdout : stderr; }

}  // namespace

void print_message(std::string_view line) noexcept {
  std::array<char, 512> buffer{};  // a buffer of its own: standard error has none, and memory may have run out
  std::size_t length = 0;
  for (const char c : line) {
    const bool is_control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    buffer.at(length++) = is_control ? (c == '\n' ? ' ' : '?') : c;
    if (length + 1 < buffer.size()) continue;
    std::fwrite(buffer.data(), 1, length, stderr);
    length = 0;
  }
  buffer.at(length++) = '\n';
  std::fwrite(buffer.data(), 1, length, stderr);
}

void StreamWriter::write_line(std::string_view line) {
  write(line);
  write("\n");
}

void StreamWriter::write(std::string_view text) {
  pending_ += text;
  if (pending_.size() >= kPiece) flush();
}

void StreamWriter::flush() {
  errno = 0;
  std::FILE* const file = file_of(stream_);
  const bool written = std::fwrite(pending_.data(), 1, pending_.size(), file) == pending_.size();
  pending_.clear();
  if (written && std::fflush(file) == 0) return;
  throw Failure(fmt::format("waywright: cannot write to standard {}: {}",
                            stream_ == StandardStream::output ? "output" : "error", std::strerror(errno)));
}

OutputFile::OutputFile(const std::string& target) : name_(target) {
  if (target.empty()) return;
  if (is_standard_output(target)) {
    method_ = Method::standard_output;
    return;
  }
  target_ = followed(target);
  std::error_code fault;
  if (fs::is_symlink(fs::symlink_status(target_, fault)) && !is_descriptor(target_)) fail(ELOOP);
  const fs::file_status status = fs::status(target_, fault);
  if (is_descriptor(target_) || (fs::exists(status) && !fs::is_regular_file(status))) {
    method_ = Method::special;
    file_ = std::fopen(target_.string().c_str(), is_descriptor(target_) ? "ab" : "wb");
    if (file_ == nullptr) fail(errno);
    return;
  }
  choose_method_for_regular_file(fs::exists(status));
}

OutputFile::~OutputFile() {
  if (file_ != nullptr) std::fclose(file_);
  remove_temporary();
}

void OutputFile::choose_method_for_regular_file(bool exists) {
  if (exists && !is_writable(target_)) fail(errno);
  method_ = Method::temporary;
  std::FILE* const file = create_temporary();
  if (file == nullptr) {
    if (!exists) fail(errno);
    method_ = Method::in_place;
    return;
  }
  std::fclose(file);
  if (exists && !adopt_attributes()) method_ = Method::in_place;
  // The run may take long, and someone may stop it. So no empty file exists during the run.
  remove_temporary();
}

std::FILE* OutputFile::create_temporary() {
  constexpr std::size_t kLongestStem = 200;  // file systems allow names of 255 bytes
  const std::string stem = target_.filename().string().substr(0, kLongestStem);
  for (int attempt = 0;; ++attempt) {
    fs::path name = target_.parent_path() / fmt::format("{}.tmp{}", stem, attempt);
    std::FILE* const file = std::fopen(name.string().c_str(), "wbx");
    if (file != nullptr) temporary_ = std::move(name);
    if (file != nullptr || errno != EEXIST) return file;
  }
}

bool OutputFile::adopt_attributes() const {
  std::error_code fault;
  const fs::file_status status = fs::status(target_, fault);
  if (!fs::exists(status)) return true;
  // Sets the owner first, because the system removes some permissions when the owner changes.
  if (!copy_owner(target_, temporary_)) return false;
  fs::permissions(temporary_, status.permissions() & fs::perms::all, fault);
  return !fault;
}

void OutputFile::remove_temporary() {
  if (!temporary_.empty()) std::remove(temporary_.string().c_str());
  temporary_.clear();
}

void OutputFile::write(std::string_view text) {
  if (method_ == Method::standard_output) {
    StreamWriter output(StandardStream::output);
    output.write(text);
    output.flush();
    return;
  }
  if (method_ == Method::temporary) file_ = create_temporary();
  if (method_ == Method::in_place) file_ = std::fopen(target_.string().c_str(), "wb");
  if (file_ == nullptr) fail(errno);
  if (method_ == Method::temporary && !adopt_attributes()) fail(EPERM);
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), file_) == text.size();
  const int write_fault = errno;
  const bool closed = std::fclose(file_) == 0;
  const int close_fault = errno;
  file_ = nullptr;
  if (!written || !closed) fail(written ? close_fault : write_fault);
}

void OutputFile::commit() {
  if (temporary_.empty()) return;
  std::error_code fault;
  fs::rename(temporary_, target_, fault);
  if (fault) fail(fault.value());
  temporary_.clear();
}

void OutputFile::fail(int fault) const {
  std::error_code ignored;
  const fs::path folder = target_.parent_path();
  if (fault == ENOENT && !folder.empty() && !fs::exists(folder, ignored)) {
    throw Failure(fmt::format("{}: cannot be written: there is no folder '{}'", name_, folder.string()));
  }
  throw Failure(fmt::format("{}: cannot be written: {}", name_, std::strerror(fault)));
}

}  // namespace waywright::command
