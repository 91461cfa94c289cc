#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Computes the correct answers by brute force with exact arithmetic. Shares neither code nor types with the library
/// that it checks; support/oracle_adapter.hpp converts the library's types.
namespace waywright::oracle {

struct OraclePoint {
  double x = 0.0;
  double y = 0.0;

  friend bool operator==(const OraclePoint&, const OraclePoint&) = default;
};

enum class OracleKind : std::uint8_t { point, segment, polyline, polygon };

struct OracleItem {
  std::uint64_t id = 0;
  OracleKind kind = OracleKind::point;
  /// One ring: of one point for a point, of two for a segment, of N for a polyline. A polygon has one or more rings; an
  /// implied side closes each.
  std::vector<std::vector<OraclePoint>> rings;
  bool is_nonzero = false;  ///< for a polygon: the fill rule is nonzero, not even-odd
};

struct OracleBox {
  OraclePoint min;
  OraclePoint max;
};

struct OracleScene {
  OracleBox domain;
  std::vector<OracleItem> items;
};

/// A constrained edge between two vertices, the smaller index first, and the items with a side on it, ascending; 0 is
/// the domain.
struct OracleConstraint {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::vector<std::uint64_t> ids;

  friend bool operator==(const OracleConstraint&, const OracleConstraint&) = default;
};

/// The vertices and the constrained edges of a scene's mesh, which do not depend on its free edges.
struct ExpectedMesh {
  /// `XNUM XDEN YNUM YDEN` of each vertex, in lowest terms, with positive denominators; in (x, y) order.
  std::vector<std::string> vertices;
  std::vector<OracleConstraint> constraints;  ///< sorted by their vertices
};

/// The location of a point in a triangulation.
struct OracleLocation {
  enum class Kind : std::uint8_t { vertex, edge, face };

  Kind kind = Kind::face;
  /// The vertices of the location, each coordinate rounded to the nearest double. The first in (x, y) order comes
  /// first; those of a face are counter-clockwise.
  std::vector<OraclePoint> vertices;
};

/// Computes the answers for one scene.
class Oracle {
 public:
  /// Requires: finite coordinates within ±2^100 and not nearer to 0 than 2^-100, all inside the domain.
  explicit Oracle(OracleScene scene);
  ~Oracle();
  Oracle(Oracle&&) noexcept;
  Oracle& operator=(Oracle&&) noexcept;

  [[nodiscard]] ExpectedMesh expected() const;
  [[nodiscard]] std::size_t vertex_count() const;
  /// Returns the vertices as correctly rounded doubles, in their exact (x, y) order.
  [[nodiscard]] const std::vector<OraclePoint>& nearest_vertices() const;
  /// Returns how many vertices are only crossings, not the corner or point of an item.
  [[nodiscard]] std::size_t crossing_count() const;
  [[nodiscard]] std::size_t constraint_count() const;

  /// Returns the first fault of a dump, or nothing if it is the one correct mesh of the scene. That mesh has the
  /// correct vertices and constrained edges; it is a triangulation of the domain with all these edges; and all its
  /// other edges are locally Delaunay, with ties broken by the rule. There is exactly one such mesh.
  [[nodiscard]] std::optional<std::string> check_dump(std::string_view dump) const;

  /// Returns the locations of points of the domain in the mesh of a dump. Requires: check_dump(dump) finds no fault.
  [[nodiscard]] std::vector<OracleLocation> locate(std::string_view dump, const std::vector<OraclePoint>& points) const;

  /// Returns whether a point agent can move from one point to another. The agent may cross the faces that no polygon
  /// covers and the edges that are not constrained, from a face that touches `from` to a face that touches `to`. Two
  /// equal points are always connected. Requires: check_dump(dump) finds no fault.
  [[nodiscard]] bool connected(std::string_view dump, OraclePoint from, OraclePoint to) const;

  /// Returns the ids, ascending, of the polygons that contain a point: inside, by their fill rules, or on a side or
  /// corner.
  [[nodiscard]] std::vector<std::uint64_t> covering_polygons(OraclePoint point) const;
  /// Returns whether a polygon contains the point inside and not on any of its sides.
  [[nodiscard]] bool strictly_inside(OraclePoint point) const;

  /// Returns the first fault of a point agent's path, or nothing if the agent can walk it. No piece may pass through a
  /// wall or the inside of a polygon. The path may not pass a point where walls meet from one wedge between them to
  /// another. It may touch walls and run along them. The check is exact: a corner between start and goal that is the
  /// nearest double of a crossing which is not itself a pair of doubles stands for that crossing.
  [[nodiscard]] std::optional<std::string> check_path(const std::vector<OraclePoint>& points) const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

[[nodiscard]] ExpectedMesh expected_vertices_and_constraints(const OracleScene& scene);
[[nodiscard]] std::optional<std::string> check_dump(const OracleScene& scene, std::string_view dump);
[[nodiscard]] std::vector<std::uint64_t> covering_polygons(const OracleScene& scene, OraclePoint point);
[[nodiscard]] bool strictly_inside(const OracleScene& scene, OraclePoint point);
[[nodiscard]] std::optional<std::string> check_path(const OracleScene& scene, const std::vector<OraclePoint>& points);

}  // namespace waywright::oracle
