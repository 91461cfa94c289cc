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

std::string_view to_string(Place place) {
  switch (place) {
    case Place::vertex:
      return "vertex";
    case Place::edge:
      return "edge";
    case Place::face:
      return "face";
  }
  return "unknown";
}

}  // namespace waywright
