#include "io/write_script.hpp"

#include <string>
#include <string_view>
#include <vector>

#include "waywright/scene.hpp"

#include "base/float_environment.hpp"
#include "text/text.hpp"

namespace waywright {
namespace {

void append_coordinates(std::string& out, Point point) {
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
  for (const Point point : ring) append_coordinates(out, point);
}

}  // namespace

void io::append_item(std::string& out, ItemId id, const Shape& shape) {
  const ItemKind kind = shape.kind;
  const bool with_count = kind == ItemKind::polyline || kind == ItemKind::polygon;
  out += to_string(kind);
  out += ' ';
  text::append_unsigned(out, id.value);
  if (kind == ItemKind::polygon && shape.fill == FillRule::nonzero) {
    out += ' ';
    out += to_string(FillRule::nonzero);
  }
  std::string_view separator;
  for (const PointSpan& ring : shape.rings) {
    out += separator;
    append_ring(out, ring, with_count);
    separator = " /";
  }
  out += '\n';
}

void io::append_header(std::string& out, const Box& domain) {
  out += "waywright 1\ndomain";
  append_coordinates(out, domain.min);
  append_coordinates(out, domain.max);
  out += '\n';
}

std::string to_script(const Scene& scene) {
  const base::FloatEnvironment environment;
  std::string out;
  io::append_header(out, scene.domain);
  for (const Item& item : scene.items) io::append_item(out, item.id, item.shape);
  return out;
}

}  // namespace waywright
