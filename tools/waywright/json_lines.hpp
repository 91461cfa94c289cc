#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "waywright/error.hpp"
#include "waywright/memory_use.hpp"
#include "waywright/path.hpp"
#include "waywright/predicate_counts.hpp"
#include "waywright/ray.hpp"
#include "waywright/world.hpp"

namespace waywright::command {

/// What a line of output answers: an operation, and the script's line that asked for it where a script did.
struct Request {
  std::string_view op;
  std::optional<std::uint32_t> line;
};

/// The answers, each one JSON object without a line end. Numbers are in the shortest form that reads back the same.
[[nodiscard]] std::string json_line(const Request& request, const Location& location);
[[nodiscard]] std::string json_line(const Request& request, const Path& path);
[[nodiscard]] std::string json_line(const Request& request, const RayHit& hit);
[[nodiscard]] std::string json_line(const Request& request, bool is_clear);
[[nodiscard]] std::string json_line(const Request& request, const Validation& validation);
[[nodiscard]] std::string json_line(const Request& request, const ItemsHash& items, const MeshHash& mesh);
[[nodiscard]] std::string json_line(const Request& request, const Error& error);

/// The counts of a whole run, and what the world at its end takes.
[[nodiscard]] std::string json_line(const PredicateCounts& counts, const MemoryUse& memory);

}  // namespace waywright::command
