#pragma once

#include <string>
#include <string_view>

#include "waywright/item.hpp"
#include "waywright/mesh_snapshot.hpp"
#include "waywright/path.hpp"
#include "waywright/point.hpp"
#include "waywright/scene.hpp"

namespace waywright::formats {

/// Writes a FeatureCollection of GeoJSON (RFC 7946), one feature on each line. Numbers have the shortest form that
/// reads back as the same double. docs/formats.md describes the features.
class GeoJsonWriter {
 public:
  /// `y_down` is Scene::y_down.
  GeoJsonWriter(const Box& domain, bool y_down);

  /// Adds an item. parse_geojson() reads it back as the same item.
  /// Requires: each ring has a point.
  void add_item(const Item& item);
  /// Adds the triangles of a mesh as polygons, and its constrained edges as lines.
  void add_mesh(const MeshSnapshot& mesh);
  /// Adds the answer of a path query: a line, or two points if there is no path. Arcs become chains of points on the
  /// arc. No position on the line is farther from the path than the radius divided by 256.
  void add_path(const Point& start, const Point& goal, const Path& path);

  /// Returns the text.
  [[nodiscard]] std::string take();

 private:
  /// Begins a feature, up to its coordinates.
  void begin_feature(std::string_view id, std::string_view properties, std::string_view type);
  void end_feature() { text_ += "}}"; }

  std::string text_;
  bool is_first_ = true;
};

/// Returns the items of a scene as GeoJSON.
[[nodiscard]] std::string to_geojson(const Scene& scene);

}  // namespace waywright::formats
