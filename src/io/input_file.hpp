#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <system_error>

#include "waywright/error.hpp"

namespace waywright::io {

struct FileCloser {
  void operator()(std::FILE* file) const { static_cast<void>(std::fclose(file)); }
};
using InputFile = std::unique_ptr<std::FILE, FileCloser>;

/// Opens a file to read its bytes. Returns null if this is not possible; errno then says why.
inline InputFile open_input_file(const std::string& file_name) {
  return InputFile(std::fopen(file_name.c_str(), "rb"));
}

/// The error for a file that the system does not read. `fault` is the system's reason, as errno gives it.
inline Error unreadable(const std::string& file_name, int fault) {
  return {ErrorCode::unreadable, file_name + ": cannot be read: " + std::generic_category().message(fault), {}, 0};
}

}  // namespace waywright::io
