#include <string>
#include <string_view>
#include <vector>

#include "waywright/scene.hpp"

#include "base/float_environment.hpp"
#include "text/text.hpp"

namespace waywright {
namespace {

void append_point(std::string& out, Point point) {
  out += ' ';
  text::append_number(out, point.x);
  out += ' ';
  text::append_number(out, point.y);
}

/// Appends the points of a ring. Writes their number before them if `with_count` is true.
void append_ring(std::string& out, PointSpan ring, bool with_count) {
  if (with_count) {
    out += ' ';
    text::append_unsigned(out, ring.size());
  }
  for (const Point point : ring) append_point(out, point);
}

void append_item(std::string& out, const Item& item) {
  const ItemKind kind = item.shape.kind;
  const bool with_count = kind == ItemKind::polyline || kind == ItemKind::polygon;
  out += to_string(kind);
  out += ' ';
  text::append_unsigned(out, item.id.value);
  if (kind == ItemKind::polygon && item.shape.fill == FillRule::nonzero) {
    out += ' ';
    out += to_string(FillRule::nonzero);
  }
  std::string_view separator;
  for (const PointSpan& ring : item.shape.rings) {
    out += separator;
    append_ring(out, ring, with_count);
    separator = " /";
  }
  out += '\n';
}

}  // namespace

std::string to_script(const Scene& scene) {
  const base::FloatEnvironment environment;
  std::string out = "waywright 1\ndomain";
  append_point(out, scene.domain.min);
  append_point(out, scene.domain.max);
  out += '\n';
  for (const Item& item : scene.items) append_item(out, item);
  return out;
}

}  // namespace waywright
