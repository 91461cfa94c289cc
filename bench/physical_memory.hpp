#pragma once

#include <cstddef>
#include <fstream>
#include <string>

namespace waywright::bench {

/// Returns the physical memory of this process in bytes, or 0 if the system does not tell. A page that several mappings
/// share counts once.
[[nodiscard]] inline std::size_t physical_memory() {
  std::ifstream file("/proc/self/smaps_rollup");
  for (std::string word; file >> word;) {
    std::size_t kilobytes = 0;
    if (word == "Pss:" && file >> kilobytes) return kilobytes << 10;
  }
  return 0;
}

}  // namespace waywright::bench
