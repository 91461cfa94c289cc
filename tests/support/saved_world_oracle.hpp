#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/point.hpp"

#include "support/item_hash_oracle.hpp"

/// The bytes of a saved world as docs/formats.md defines them. Shares no code with the library.
namespace waywright::test::saved_world {

/// What a saved world contains.
struct Contents {
  Box domain;
  std::uint64_t options = 1;
  std::uint64_t largest_id = 0;
  std::map<ItemId, Shape> items;
};

/// Returns the CRC-32C of the bytes, computed bit by bit.
inline std::uint32_t checksum(std::string_view bytes) {
  std::uint32_t state = 0xffffffff;
  for (const char c : bytes) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      const bool is_odd = ((state ^ (static_cast<unsigned char>(c) >> bit)) & 1) != 0;
      state = is_odd ? (state >> 1) ^ 0x82f63b78 : state >> 1;
    }
  }
  return ~state;
}

/// Returns a number in `size` bytes, little-endian.
inline std::string fixed(std::uint64_t value, int size) {
  std::string bytes;
  for (; size > 0; --size, value /= 256) bytes.push_back(static_cast<char>(value % 256));
  return bytes;
}

inline std::string varint(std::uint64_t value) {
  if (value < 128) return std::string(1, static_cast<char>(value));
  return static_cast<char>(value % 128 + 128) + varint(value / 128);
}

/// Returns the bytes with their checksum after them.
inline std::string sealed(const std::string& bytes) { return bytes + fixed(checksum(bytes), 4); }

/// Returns the first 76 bytes.
inline std::string header(const Contents& contents) {
  const auto& [low, high] = contents.domain;
  std::string bytes = "WWORLD" + fixed(1, 2);
  for (const double bound : {low.x, low.y, high.x, high.y}) bytes += fixed(item_hash::bits(bound), 8);
  bytes += fixed(contents.options, 4) + fixed(contents.largest_id, 8) + fixed(contents.items.size(), 8);
  for (const std::uint64_t lane : item_hash::hash_of(contents.domain, contents.items)) bytes += fixed(lane, 8);
  return bytes;
}

/// Returns a whole saved world. The bytes of each item come from the words of its hash, which are its id, its kind, the
/// number of its rings, and for each ring the number of its points and the bits of their coordinates.
inline std::string bytes_of(const Contents& contents) {
  struct Run {
    std::uint64_t first = 0;
    std::uint64_t size = 0;
    std::uint64_t kind = 0;
    std::string counts;
    std::string points;
  };
  std::vector<Run> runs;
  for (const auto& [id, shape] : contents.items) {
    const std::vector<std::uint64_t> words = item_hash::words_of(id, shape);
    const bool continues = !runs.empty() && runs.back().kind == words[1] && runs.back().size < 4096 &&
                           runs.back().first + runs.back().size == id.value;
    if (!continues) runs.push_back({id.value, 0, words[1], {}, {}});
    Run& run = runs.back();
    ++run.size;
    if (words[1] >= 3) run.counts += varint(words[2]);
    for (std::size_t i = 3; i < words.size();) {
      const auto count = static_cast<std::size_t>(words[i++]);
      if (words[1] >= 2) run.counts += varint(count);
      std::string ring;
      for (const std::size_t end = i + 2 * count; i < end; ++i) ring += fixed(words[i], 8);
      if (words[1] == 1 && count == 1) ring += ring;
      run.points += ring;
    }
  }
  std::string bytes = header(contents);
  std::uint64_t last = 0;
  for (const Run& run : runs) {
    bytes += varint(run.first - last) + varint(run.size * 8 + run.kind) + run.counts + run.points;
    last = run.first + run.size - 1;
  }
  return sealed(bytes);
}

}  // namespace waywright::test::saved_world
