#include "formats/write_geojson.hpp"

#include <cstddef>
#include <utility>
#include <vector>

#include "base/number_text.hpp"
#include "formats/geojson.hpp"

namespace waywright::formats {

namespace {

void append_position(std::string& out, const Point& point) {
  out += '[';
  base::append_number(out, point.x);
  out += ',';
  base::append_number(out, point.y);
  out += ']';
}

/// Appends the positions of a line. Repeats the last one until there are at least `least`: GeoJSON has no shorter lines
/// and rings, and points that repeat their predecessor count once.
void append_positions(std::string& out, PointSpan points, std::size_t least) {
  out += '[';
  for (std::size_t i = 0; i < points.size() || i < least; ++i) {
    if (i > 0) out += ',';
    append_position(out, i < points.size() ? points[i] : points[points.size() - 1]);
  }
  out += ']';
}

/// Appends a ring, with its first point once more at its end.
void append_ring(std::string& out, PointSpan ring) {
  constexpr std::size_t kLeast = 4;
  append_positions(out, ring, kLeast - 1);
  out.back() = ',';
  append_position(out, ring[0]);
  out += ']';
}

void append_coordinates(std::string& out, const Shape& shape) {
  if (shape.kind == ItemKind::point) return append_position(out, shape.rings[0][0]);
  if (shape.kind != ItemKind::polygon) return append_positions(out, shape.rings[0], 2);
  out += '[';
  for (std::size_t i = 0; i < shape.rings.size(); ++i) {
    if (i > 0) out += ',';
    append_ring(out, shape.rings[i]);
  }
  out += ']';
}

std::string_view type_of(ItemKind kind) {
  if (kind == ItemKind::point) return "Point";
  return kind == ItemKind::polygon ? "Polygon" : "LineString";
}

/// Returns the property `waywright` with a value that contains no character to escape.
std::string own_property(std::string_view value) {
  std::string property = "\"";
  property += kOwnMember;
  property += "\":\"";
  property += value;
  return property += '"';
}

void append_member(std::string& out, std::string_view name, double value) {
  out += ",\"";
  out += name;
  out += "\":";
  base::append_number(out, value);
}

}  // namespace

GeoJsonWriter::GeoJsonWriter(const Box& domain, bool y_down) {
  text_ = "{\"type\":\"FeatureCollection\",\"";
  text_ += kOwnMember;
  text_ += "\":{\"domain\":[";
  for (const double bound : {domain.min.x, domain.min.y, domain.max.x, domain.max.y}) {
    base::append_number(text_, bound);
    text_ += ',';
  }
  text_.back() = ']';
  if (y_down) text_ += ",\"y_down\":true";
  text_ += "},\"features\":[";
}

void GeoJsonWriter::begin_feature(std::string_view id, std::string_view properties, std::string_view type) {
  text_ += is_first_ ? "\n" : ",\n";
  is_first_ = false;
  text_ += "{\"type\":\"Feature\",";
  if (!id.empty()) {
    text_ += "\"id\":";
    text_ += id;
    text_ += ',';
  }
  text_ += "\"properties\":{";
  text_ += properties;
  text_ += "},\"geometry\":{\"type\":\"";
  text_ += type;
  text_ += "\",\"coordinates\":";
}

void GeoJsonWriter::add_item(const Item& item) {
  std::string kind(to_string(item.shape.kind));
  if (item.shape.kind == ItemKind::polygon && item.shape.fill == FillRule::nonzero) kind += " nonzero";
  begin_feature(std::to_string(item.id.value), own_property(kind), type_of(item.shape.kind));
  append_coordinates(text_, item.shape);
  end_feature();
}

void GeoJsonWriter::add_mesh(const MeshSnapshot& mesh) {
  for (const auto& [a, b, c] : mesh.triangles) {
    begin_feature({}, own_property("triangle"), "Polygon");
    text_ += '[';
    append_ring(text_, std::vector<Point>{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
    text_ += ']';
    end_feature();
  }
  for (const MeshSnapshot::ConstrainedEdge& edge : mesh.constraints) {
    std::string properties = own_property("edge") + ",\"items\":[";
    for (std::uint32_t i = 0; i < edge.id_count; ++i) {
      if (i > 0) properties += ',';
      base::append_unsigned(properties, mesh.ids[edge.first_id + i].value);
    }
    properties += ']';
    begin_feature({}, properties, "LineString");
    append_positions(text_, std::vector<Point>{mesh.vertices[edge.vertices[0]], mesh.vertices[edge.vertices[1]]}, 2);
    end_feature();
  }
}

void GeoJsonWriter::add_path(const Point& start, const Point& goal, const Path& path) {
  std::string properties = own_property("path");
  const bool is_found = path.status == PathStatus::found;
  properties += is_found ? ",\"found\":true" : ",\"found\":false,\"reason\":\"";
  if (!is_found) {
    properties += to_string(path.status);
    properties += '"';
  }
  append_member(properties, "radius", path.agent.radius);
  if (is_found) append_member(properties, "length", path.length);
  begin_feature({}, properties, is_found ? "LineString" : "MultiPoint");
  if (is_found) {
    append_positions(text_, path.polyline(path.agent.radius / 256.0).value(), 2);
  } else {
    append_positions(text_, std::vector<Point>{start, goal}, 2);
  }
  end_feature();
}

std::string GeoJsonWriter::take() {
  text_ += "\n]}\n";
  return std::move(text_);
}

std::string to_geojson(const Scene& scene) {
  GeoJsonWriter writer(scene.domain, scene.y_down);
  for (const Item& item : scene.items) writer.add_item(item);
  return writer.take();
}

}  // namespace waywright::formats
