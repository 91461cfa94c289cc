#pragma once

#include <cstdio>

namespace waywright::base {

/// Waits until the contents of an open file are on the disk. Returns false and sets errno if this fails. Files for
/// which the system has no such function count as written. Requires: the file's buffer is empty (std::fflush).
[[nodiscard]] bool bring_to_disk(std::FILE* file);

/// Waits until the names in a folder are on the disk, if the system has a function for this. Ignores failures.
void bring_folder_to_disk(const char* folder);

}  // namespace waywright::base
