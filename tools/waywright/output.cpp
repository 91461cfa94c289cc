#include "output.hpp"

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "failure.hpp"

namespace waywright::command {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPiece = std::size_t{1} << 16;

}  // namespace

void StandardOutput::write_line(std::string_view line) {
  pending_ += line;
  pending_ += '\n';
  if (pending_.size() >= kPiece) flush();
}

void StandardOutput::flush() {
  errno = 0;
  const bool written = std::fwrite(pending_.data(), 1, pending_.size(), stdout) == pending_.size();
  pending_.clear();
  if (!written || std::fflush(stdout) != 0) {
    throw Failure(fmt::format("waywright: cannot write to standard output: {}", std::strerror(errno)));
  }
}

OutputFile::OutputFile(const std::string& target) : name_(target), target_(target) {
  if (target.empty()) return;
  std::error_code fault;
  const fs::file_status status = fs::status(target, fault);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    file_ = std::fopen(target.c_str(), "wb");
    if (file_ == nullptr) fail(errno);
    return;
  }
  if (fs::is_symlink(target, fault)) target_ = fs::weakly_canonical(target, fault).string();
  open_temporary();
}

OutputFile::~OutputFile() {
  if (file_ != nullptr) std::fclose(file_);
  if (!temporary_.empty()) std::remove(temporary_.c_str());
}

void OutputFile::open_temporary() {
  for (int attempt = 0; file_ == nullptr; ++attempt) {
    temporary_ = fmt::format("{}.tmp{}", target_, attempt);
    file_ = std::fopen(temporary_.c_str(), "wbx");
    if (file_ != nullptr || errno == EEXIST) continue;
    const int fault = errno;
    temporary_.clear();
    fail(fault);
  }
}

void OutputFile::write(std::string_view text) {
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
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
}

void OutputFile::fail(int fault) const {
  throw Failure(fmt::format("{}: cannot be written: {}", name_, std::strerror(fault)));
}

bool same_file(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  std::error_code fault;
  return fs::weakly_canonical(a, fault) == fs::weakly_canonical(b, fault);
}

}  // namespace waywright::command
