#include "file_names.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "failure.hpp"

namespace waywright::command {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const NamedFile& output, std::string_view why) {
  throw Failure(
      fmt::format("waywright: {} would write to '{}', {}; nothing was written", output.argument, output.name, why));
}

bool is_device(const fs::path& name) {
  std::error_code fault;
  return fs::is_character_file(name, fault);
}

/// Returns whether two outputs are the same file, which need not exist. Two outputs may name the same device, such as
/// /dev/null.
bool same_output(const std::string& a, const std::string& b) {
  const bool a_is_standard = is_standard_output(a);
  if (a_is_standard || is_standard_output(b)) return a_is_standard && is_standard_output(b);
  const fs::path first = followed(a);
  const fs::path second = followed(b);
  if (is_device(first)) return false;
  const std::optional<FileIdentity> identity = identity_of(first);
  if (identity) return identity == identity_of(second);
  std::error_code fault;
  return fs::weakly_canonical(first, fault) == fs::weakly_canonical(second, fault);
}

void refuse_shared_input(const NamedFile& input, const NamedFile& output) {
  const bool is_standard = input.name == "-";
  const auto read = is_standard ? identity_of(StandardStream::input) : identity_of(fs::path(input.name));
  if (!read) return;
  const auto written = is_standard_output(output.name) ? std::nullopt : identity_of(fs::path(output.name));
  if (read == written) refuse(output, fmt::format("the file that {} reads", input.argument));
}

/// Throws Failure if the stream writes to the file of an input or another output. The shell may have redirected
/// standard output and standard error to a file.
void refuse_shared_stream(StandardStream stream, std::string_view stream_name, const std::vector<NamedFile>& inputs,
                          const std::vector<NamedFile>& outputs) {
  const auto written = identity_of(stream);
  if (!written) return;
  for (const NamedFile& output : outputs) {
    if (output.name.empty() || is_standard_output(output.name) || is_descriptor(followed(output.name))) continue;
    if (identity_of(fs::path(output.name)) == written) refuse(output, fmt::format("where {} goes", stream_name));
  }
  for (const NamedFile& input : inputs) {
    const auto read = input.name == "-" ? identity_of(StandardStream::input) : identity_of(fs::path(input.name));
    if (read != written) continue;
    throw Failure(fmt::format("waywright: {} goes to the file that {} reads", stream_name, input.argument));
  }
}

}  // namespace

bool is_descriptor(const fs::path& name) {
  const std::string text = name.lexically_normal().string();
  return text == "/dev/stdin" || text == "/dev/stdout" || text == "/dev/stderr" || text.starts_with("/dev/fd/") ||
         text.starts_with("/proc/");
}

bool is_standard_output(const std::string& name) {
  if (name == "-") return true;
  const std::string text = followed(name).lexically_normal().string();
  return text == "/dev/stdout" || text == "/dev/fd/1" || text == "/proc/self/fd/1";
}

fs::path followed(fs::path name) {
  constexpr int kMostLinks = 40;
  std::error_code fault;
  for (int i = 0; i < kMostLinks && !is_descriptor(name); ++i) {
    if (!fs::is_symlink(fs::symlink_status(name, fault))) break;
    const fs::path next = fs::read_symlink(name, fault);
    if (fault) break;
    name = name.parent_path() / next;  // if `next` is absolute, it replaces the whole name
  }
  return name;
}

StandardStream stream_beside(const std::vector<std::string>& files) {
  return std::any_of(files.begin(), files.end(), is_standard_output) ? StandardStream::error : StandardStream::output;
}

void refuse_shared_files(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outputs[i].name.empty()) continue;
    for (const NamedFile& input : inputs) refuse_shared_input(input, outputs[i]);
    for (std::size_t j = 0; j < i; ++j) {
      if (outputs[j].name.empty() || !same_output(outputs[i].name, outputs[j].name)) continue;
      refuse(outputs[i], fmt::format("where {} writes too", outputs[j].argument));
    }
  }
  refuse_shared_stream(StandardStream::output, "standard output", inputs, outputs);
  refuse_shared_stream(StandardStream::error, "standard error", inputs, outputs);
}

}  // namespace waywright::command
