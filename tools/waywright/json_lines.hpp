#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "waywright/clearance.hpp"
#include "waywright/error.hpp"
#include "waywright/location.hpp"
#include "waywright/memory_use.hpp"
#include "waywright/path.hpp"
#include "waywright/predicate_counts.hpp"
#include "waywright/replay.hpp"
#include "waywright/world.hpp"

namespace waywright::command {

/// The request that a line of output answers: its name, and the number of its line if a script contains it.
struct Request {
  std::string_view op;
  std::optional<std::uint32_t> line;
};

/// What moves along a ray. Only the answer for a disc has a contact.
enum class RayOf : std::uint8_t { point, disc };

/// Each function returns an answer as one JSON object without a line end. Numbers have the shortest form that reads
/// back as the same number.
[[nodiscard]] std::string json_line(const Request& request, const Location& location);
[[nodiscard]] std::string json_line(const Request& request, const Path& path);
[[nodiscard]] std::string json_line(const Request& request, const RayHit& hit, RayOf of);
[[nodiscard]] std::string json_line(const Request& request, const DiscFit& fit);
[[nodiscard]] std::string json_line(const Request& request, const NearestFit& fit);
[[nodiscard]] std::string json_line(const Request& request, bool is_clear);
[[nodiscard]] std::string json_line(const Request& request, const Validation& validation);
[[nodiscard]] std::string json_line(const Request& request, const ItemsHash& items, const MeshHash& mesh);
[[nodiscard]] std::string json_line(const Request& request, const Error& error);
/// The hash of a tick that differs from the hash in the script.
[[nodiscard]] std::string json_line(const Request& request, std::uint64_t tick, const ItemsHash& expected,
                                    const ItemsHash& computed);
[[nodiscard]] std::string json_line(const ReplayResult& result);
/// The first difference between two logs; null if they do not differ.
[[nodiscard]] std::string json_line(const std::optional<ReplayDifference>& difference);

/// The counts of a whole run, and the memory of the world at its end.
[[nodiscard]] std::string json_line(const PredicateCounts& counts, const MemoryUse& memory);

}  // namespace waywright::command
