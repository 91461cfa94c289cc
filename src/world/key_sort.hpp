#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace waywright {

/// Sorts keys, ascending. Many keys take one pass over the keys for each byte in which they differ: keys below 65,536
/// take two passes. `scratch` keeps its memory from one call to the next.
inline void sort_keys(std::vector<std::uint64_t>& keys, std::vector<std::uint64_t>& scratch) {
  constexpr std::size_t kFew = 64;
  if (keys.size() <= kFew) return std::sort(keys.begin(), keys.end());
  std::uint64_t varying = 0;
  for (const std::uint64_t key : keys) varying |= key ^ keys.front();
  scratch.resize(keys.size());
  std::span<std::uint64_t> from = keys;
  std::span<std::uint64_t> to = scratch;
  for (unsigned shift = 0; shift < 64; shift += 8) {
    const auto byte_of = [&](std::uint64_t key) { return static_cast<std::size_t>((key >> shift) & 0xff); };
    if (byte_of(varying) == 0) continue;
    std::array<std::size_t, 256> next{};
    for (const std::uint64_t key : from) ++next[byte_of(key)];
    std::size_t begin = 0;
    for (std::size_t& count : next) begin += std::exchange(count, begin);
    for (const std::uint64_t key : from) to[next[byte_of(key)]++] = key;
    std::swap(from, to);
  }
  // Copies instead of swapping the vectors, so that each keeps its memory.
  if (from.data() != keys.data()) std::copy(from.begin(), from.end(), keys.begin());
}

}  // namespace waywright
