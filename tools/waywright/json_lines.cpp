#include "json_lines.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "formats/json_text.hpp"

namespace waywright::command {

namespace {

// The JSON library only quotes texts, because it writes 0.0 for 0 and sorts its output.
using formats::json_string;

std::string opening(const Request& request) {
  if (!request.line) return fmt::format(R"({{"op":"{}")", request.op);
  return fmt::format(R"({{"line":{},"op":"{}")", *request.line, request.op);
}

/// Returns the value, with -0 replaced by 0: adding 0 changes no other number.
double without_sign_of_zero(double value) { return value + 0.0; }

void append_ids(std::string& out, const std::vector<ItemId>& ids) {
  for (std::size_t i = 0; i < ids.size(); ++i) {
    fmt::format_to(std::back_inserter(out), "{}{}", i == 0 ? "" : ",", ids[i].value);
  }
}

void append_point(std::string& out, const Point& point) {
  fmt::format_to(std::back_inserter(out), "{},{}", without_sign_of_zero(point.x), without_sign_of_zero(point.y));
}

void append_moved(std::string& out, std::string_view name, const std::optional<MovedEnd>& moved) {
  if (!moved) return;
  fmt::format_to(std::back_inserter(out), R"(,"{}":[[)", name);
  append_point(out, moved->from);
  out += "],[";
  append_point(out, moved->to);
  out += "]]";
}

}  // namespace

std::string json_line(const Request& request, const Location& location) {
  std::string out = opening(request) + fmt::format(R"(,"at":"{}","vertices":[)", to_string(location.kind));
  for (std::size_t i = 0; i < location.vertex_count; ++i) {
    out += i == 0 ? "[" : ",[";
    append_point(out, location.vertices.at(i));
    out += ']';
  }
  out += R"(],"inside":[)";
  append_ids(out, location.polygons);
  return out + "]}";
}

namespace {

/// Appends the lines and arcs of the path of a disc.
void append_pieces(std::string& out, std::span<const PathPiece> pieces) {
  const char* separator = "";
  for (const PathPiece& piece : pieces) {
    out += std::exchange(separator, ",");
    if (piece.kind == PathPiece::Kind::line) {
      out += R"({"line":[)";
      append_point(out, piece.from);
      out += ',';
      append_point(out, piece.to);
      out += "]}";
      continue;
    }
    out += R"({"arc":[)";
    append_point(out, piece.centre);
    out += fmt::format(",{},{},{}]}}", piece.radius, without_sign_of_zero(piece.start_angle),
                       without_sign_of_zero(piece.end_angle));
  }
}

void append_widest(std::string& out, const WidestPath& widest) {
  out += fmt::format(R"(,"widest":{{"radius":{},"gap":[[)", widest.radius);
  append_point(out, widest.from);
  out += "],[";
  append_point(out, widest.to);
  out += R"(]],"items":[)";
  std::vector<ItemId> items;
  std::set_union(widest.from_items.begin(), widest.from_items.end(), widest.to_items.begin(), widest.to_items.end(),
                 std::back_inserter(items));
  append_ids(out, items);
  out += "]}";
}

}  // namespace

std::string json_line(const Request& request, const Path& path) {
  if (path.status != PathStatus::found) {
    std::string out = opening(request) + fmt::format(R"(,"found":false,"reason":"{}")", to_string(path.status));
    if (path.status != PathStatus::no_path) {
      out += R"(,"items":[)";
      append_ids(out, path.blockers);
      out += ']';
    }
    if (path.widest && path.widest->is_limited) append_widest(out, *path.widest);
    return out + '}';
  }
  std::string out = opening(request) + fmt::format(R"(,"found":true,"length":{},"pieces":[)", path.length);
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    out += i == 1 ? R"({"line":[)" : R"(,{"line":[)";
    append_point(out, path.points[i - 1]);
    out += ',';
    append_point(out, path.points[i]);
    out += "]}";
  }
  if (path.length > 0.0) append_pieces(out, path.pieces);
  out += ']';
  append_moved(out, "moved_start", path.moved_start);
  append_moved(out, "moved_goal", path.moved_goal);
  return out + '}';
}

std::string json_line(const Request& request, const RayHit& hit, RayOf of) {
  if (!hit.hit) return opening(request) + R"(,"hit":false})";
  std::string out = opening(request) + R"(,"hit":true,"at":[)";
  append_point(out, hit.at);
  if (of == RayOf::disc) {
    out += R"(],"contact":[)";
    append_point(out, hit.contact);
  }
  out += R"(],"items":[)";
  append_ids(out, hit.items);
  return out + "]}";
}

std::string json_line(const Request& request, const DiscFit& fit) {
  std::string out = opening(request) + fmt::format(R"(,"free":{},"items":[)", fit.fits);
  append_ids(out, fit.items);
  return out + "]}";
}

std::string json_line(const Request& request, const NearestFit& fit) {
  if (!fit.is_found) return opening(request) + R"(,"found":false})";
  std::string out = opening(request) + R"(,"found":true,"at":[)";
  append_point(out, fit.at);
  return out + "]}";
}

std::string json_line(const Request& request, bool is_clear) {
  return opening(request) + fmt::format(R"(,"clear":{}}})", is_clear);
}

std::string json_line(const Request& request, const Validation& validation) {
  if (validation.ok) return opening(request) + R"(,"ok":true})";
  return opening(request) + fmt::format(R"(,"ok":false,"fault":{}}})", json_string(validation.fault));
}

std::string json_line(const Request& request, const ItemsHash& items, const MeshHash& mesh) {
  return opening(request) + fmt::format(R"(,"items":"{}","mesh":"{}"}})", to_string(items), to_string(mesh));
}

std::string json_line(const Request& request, const Error& error) {
  return opening(request) +
         fmt::format(R"(,"error":"{}","message":{}}})", to_string(error.code), json_string(error.message()));
}

std::string json_line(const Request& request, std::uint64_t tick, const ItemsHash& expected,
                      const ItemsHash& computed) {
  return opening(request) + fmt::format(R"(,"tick":{},"same":false,"expected":"{}","computed":"{}"}})", tick,
                                        to_string(expected), to_string(computed));
}

std::string json_line(const ReplayResult& result) {
  std::string out = R"({"op":"replay","same":)";
  if (result.is_same) return out + fmt::format(R"(true,"ticks":{}}})", result.ticks);
  out += fmt::format(R"(false,"tick":{},"line":{},"last_same":{})", result.tick, result.line, result.last_same);
  if (result.refusal) {
    out += fmt::format(R"(,"error":"{}","message":{})", to_string(result.refusal->code),
                       json_string(result.refusal->message()));
  } else {
    out += fmt::format(R"(,"expected":"{}","computed":"{}")", to_string(result.expected), to_string(result.computed));
  }
  out += R"(,"items":[)";
  append_ids(out, result.changed);
  return out + "]}";
}

namespace {

std::string_view name_of(ReplayDifference::Kind kind) {
  switch (kind) {
    case ReplayDifference::Kind::domain:
      return "domain";
    case ReplayDifference::Kind::change:
      return "change";
    case ReplayDifference::Kind::hash:
      return "hash";
    case ReplayDifference::Kind::length:
      break;
  }
  return "length";
}

}  // namespace

std::string json_line(const std::optional<ReplayDifference>& difference) {
  std::string out = R"({"op":"compare","same":)";
  if (!difference) return out + "true}";
  out += fmt::format(R"(false,"kind":"{}","tick":{},"line":{},"other_line":{})", name_of(difference->kind),
                     difference->tick, difference->line, difference->other_line);
  if (difference->kind == ReplayDifference::Kind::change) {
    out += fmt::format(R"(,"item":{},"other_item":{})", difference->item.value, difference->other_item.value);
  }
  if (difference->kind == ReplayDifference::Kind::hash) {
    out += R"(,"items":[)";
    append_ids(out, difference->changed);
    out += ']';
  }
  return out + '}';
}

std::string json_line(const PredicateCounts& counts, const MemoryUse& memory) {
  const auto stages = [](const StageCounts& stage) {
    return fmt::format(R"({{"doubles":{},"lattice":{},"integers":{}}})", stage.doubles, stage.lattice, stage.integers);
  };
  const std::string bytes = fmt::format(
      R"({{"vertices":{},"crossings":{},"faces":{},"walls":{},"items":{},"sectors":{},"abstraction":{},"bridges":{},"history":{},"spare":{}}})",
      memory.vertices, memory.crossings, memory.faces, memory.walls, memory.items, memory.sectors, memory.abstraction,
      memory.bridges, memory.history, memory.spare);
  return fmt::format(R"({{"op":"stats","orientation":{},"in_circle":{},"order":{},"crossing":{},"memory":{}}})",
                     stages(counts.orientation), stages(counts.in_circle), stages(counts.order),
                     stages(counts.crossing), bytes);
}

}  // namespace waywright::command
