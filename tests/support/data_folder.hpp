#pragma once

#include <cstdlib>
#include <filesystem>

#ifndef WAYWRIGHT_SOURCE_DIR
#error "a test that reads files needs WAYWRIGHT_SOURCE_DIR, the project's root"
#endif

namespace waywright::test {

/// Returns the folder of the optional real inputs: the environment variable WAYWRIGHT_DATA, else `../shared/data`
/// beside the project. The folder may not exist.
inline std::filesystem::path data_folder() {
  const char* const named = std::getenv("WAYWRIGHT_DATA");
  if (named != nullptr && *named != '\0') return named;
  return std::filesystem::path(WAYWRIGHT_SOURCE_DIR) / ".." / "shared" / "data";
}

}  // namespace waywright::test
