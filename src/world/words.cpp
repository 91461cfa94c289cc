#include "waywright/item.hpp"
#include "waywright/path.hpp"
#include "waywright/world.hpp"

namespace waywright {

std::string_view to_string(ItemKind kind) {
  switch (kind) {
    case ItemKind::point:
      return "point";
    case ItemKind::segment:
      return "segment";
    case ItemKind::polyline:
      return "polyline";
    case ItemKind::polygon:
      return "polygon";
  }
  return "unknown";
}

std::string_view to_string(FillRule rule) {
  switch (rule) {
    case FillRule::even_odd:
      return "even-odd";
    case FillRule::nonzero:
      return "nonzero";
  }
  return "unknown";
}

std::string_view to_string(PathStatus status) {
  switch (status) {
    case PathStatus::found:
      return "found";
    case PathStatus::start_blocked:
      return "start-blocked";
    case PathStatus::goal_blocked:
      return "goal-blocked";
    case PathStatus::no_path:
      return "no-path";
  }
  return "unknown";
}

std::string_view to_string(PathAlgorithm algorithm) {
  switch (algorithm) {
    case PathAlgorithm::ta:
      return "ta";
    case PathAlgorithm::tra:
      return "tra";
    case PathAlgorithm::optimal:
      return "optimal";
  }
  return "unknown";
}

std::optional<PathAlgorithm> path_algorithm(std::string_view name) {
  for (const PathAlgorithm algorithm : {PathAlgorithm::ta, PathAlgorithm::tra, PathAlgorithm::optimal}) {
    if (to_string(algorithm) == name) return algorithm;
  }
  return std::nullopt;
}

std::string_view to_string(LocationKind kind) {
  switch (kind) {
    case LocationKind::vertex:
      return "vertex";
    case LocationKind::edge:
      return "edge";
    case LocationKind::face:
      return "face";
  }
  return "unknown";
}

namespace {

std::string hexadecimal(std::uint64_t value, int digits) {
  std::string text;
  for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) text += "0123456789abcdef"[value >> shift & 0xf];
  return text;
}

}  // namespace

std::string to_string(const ItemsHash& hash) { return hexadecimal(hash.words[0], 16) + hexadecimal(hash.words[1], 16); }

std::string to_string(const MeshHash& hash) {
  std::string text;
  for (const std::uint8_t byte : hash.bytes) text += hexadecimal(byte, 2);
  return text;
}

}  // namespace waywright
