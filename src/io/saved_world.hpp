#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

// The format of a saved world, which docs/formats.md describes.

namespace waywright::io {

inline constexpr std::string_view kSavedWorldMagic = "WWORLD";
inline constexpr std::uint64_t kSavedWorldVersion = 1;

// The bits of the options.
inline constexpr std::uint64_t kKeepsAbstraction = 1;
inline constexpr std::uint64_t kKeepsBridges = 2;

/// The largest number of items of one run: a group of items of one kind whose ids count up by 1.
inline constexpr std::uint64_t kLargestRun = 4096;

/// The largest number of points of one ring, and of rings of one item: a world accepts no more.
inline constexpr std::uint64_t kLargestCount = std::uint64_t{1} << 27;

/// The kinds have the same numbers as in the hash of the items: see docs/hashes.md.
enum class SavedKind : std::uint8_t { point, segment, polyline, even_odd_polygon, nonzero_polygon };
inline constexpr std::uint64_t kSavedKindCount = 5;
/// The kind of a run is in these low bits, the number of its items is above them.
inline constexpr unsigned kKindBits = 3;

static_assert(sizeof(double) == 8 && std::numeric_limits<double>::is_iec559);

}  // namespace waywright::io
