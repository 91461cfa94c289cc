#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What the right answers are, found by brute force over everything with exact arithmetic. Shares no code with the
/// library that it judges, nor any type: see adapter.hpp for the way here from the library's own.
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
  /// One ring of one point for a point, of two for a segment, of N for a polyline; a polygon has one or more, each
  /// closed by an implied side.
  std::vector<std::vector<OraclePoint>> rings;
  bool is_nonzero = false;  ///< of a polygon: by the fill rule nonzero, not even-odd
};

struct OracleBox {
  OraclePoint min;
  OraclePoint max;
};

struct OracleScene {
  OracleBox domain;
  std::vector<OracleItem> items;
};

/// A constrained edge between two vertices, the smaller first, and the items that cover it, ascending; 0 is the domain.
struct OracleConstraint {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::vector<std::uint64_t> ids;

  friend bool operator==(const OracleConstraint&, const OracleConstraint&) = default;
};

/// What a scene's mesh must have, whatever its free edges.
struct ExpectedMesh {
  /// `XNUM XDEN YNUM YDEN` of each vertex, reduced, denominators positive; in (x, y) order.
  std::vector<std::string> vertices;
  std::vector<OracleConstraint> constraints;  ///< sorted by their vertices
};

/// Where a point lies in a triangulation.
struct OraclePlace {
  enum class At : std::uint8_t { vertex, edge, face };

  At at = At::face;
  /// The vertex's, edge's or face's corners as nearest doubles, the first in (x, y) order first, a face
  /// counter-clockwise.
  std::vector<OraclePoint> corners;
};

/// The answers for one scene.
class Oracle {
 public:
  /// Requires: finite coordinates within ±2^100 and not nearer to 0 than 2^-100, all inside the domain.
  explicit Oracle(OracleScene scene);
  ~Oracle();
  Oracle(Oracle&&) noexcept;
  Oracle& operator=(Oracle&&) noexcept;

  [[nodiscard]] ExpectedMesh expected() const;
  [[nodiscard]] std::size_t vertex_count() const;
  /// The vertices as correctly rounded doubles, in their exact (x, y) order.
  [[nodiscard]] const std::vector<OraclePoint>& nearest_vertices() const;
  /// How many vertices are crossings only, the corner or point of no item.
  [[nodiscard]] std::size_t crossing_count() const;
  [[nodiscard]] std::size_t constraint_count() const;

  /// The first fault of a dump, none if it is the scene's one right mesh. The right vertices, the right constrained
  /// edges, a triangulation of the domain that has them all and whose other edges are all locally Delaunay, ties
  /// broken by the rule: there is exactly one such.
  [[nodiscard]] std::optional<std::string> check_dump(std::string_view dump) const;

  /// Where points of the domain lie in the mesh of a dump. Requires: check_dump(dump) finds no fault.
  [[nodiscard]] std::vector<OraclePlace> places(std::string_view dump, const std::vector<OraclePoint>& points) const;

  /// Whether a point agent can get from one place to another: over faces that lie in no polygon and through edges that
  /// are not constrained, from a face that touches the one to a face that touches the other. The same places are
  /// always connected. Requires: check_dump(dump) finds no fault.
  [[nodiscard]] bool connected(std::string_view dump, OraclePoint from, OraclePoint to) const;

  /// The ids, ascending, of the polygons that cover a point: those with it inside, by their fill rules, and those
  /// with it on a side or corner.
  [[nodiscard]] std::vector<std::uint64_t> covering_polygons(OraclePoint point) const;
  /// Whether a polygon has the point inside and not on any of its sides.
  [[nodiscard]] bool strictly_inside(OraclePoint point) const;

  /// The first fault of a point agent's path, none if the agent can go this way: no piece passes through a wall or the
  /// inside of a solid, nor does the path pass a point where walls meet from one wedge between them to another;
  /// touching and sliding along is allowed. Nothing is approximate: a corner between start and goal that is the
  /// nearest double of a crossing point which no double can name stands for that crossing point itself.
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
