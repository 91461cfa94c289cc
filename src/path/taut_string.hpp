#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "waywright/point.hpp"

#include "constraint/exact_triangulation.hpp"

namespace waywright::path {

/// The taut string through one channel. An object to keep for its memory.
///
/// From the last corner that is certain, the funnel's apex, the strings to the two ends of the portal at hand part and
/// turn each towards its own side. They are kept in a row, the left end first, the apex between them. Cost: O(1) a
/// portal, amortised. Source: Lee and Preparata, *Euclidean shortest paths in the presence of rectilinear barriers*,
/// 1984. TautTree is the same for all channels of a search.
class TautString {
 public:
  using Geometry = exact::Geometry;

  /// Starts anew from a point that sees the first portal, of a channel of so many.
  void begin(const Geometry& geometry, const Point& start, mesh::Vertex left, mesh::Vertex right,
             std::size_t portal_count);
  /// The portal's left, or right, end moves on to `v`.
  void move_left(mesh::Vertex v);
  void move_right(mesh::Vertex v);
  /// The string ends at `goal`, just beyond the last portal.
  void end_at(const Point& goal);

  /// Where the string turns, as rounded, from its start on; the goal is left out.
  [[nodiscard]] std::span<const Point> corners() const { return corners_; }
  /// That of the string.
  [[nodiscard]] double length() const { return length_; }

 private:
  using View = Geometry::View;

  [[nodiscard]] bool is_at_start(mesh::Vertex v) const;
  void turn_at(const View& corner) { corners_.push_back({corner.x, corner.y}); }

  const Geometry* geometry_ = nullptr;
  std::vector<View> row_;
  std::size_t left_ = 0;  ///< where in the row the left end is; then the apex and the right end
  std::size_t apex_ = 0;
  std::size_t right_ = 0;
  std::vector<Point> corners_;  ///< before the apex; once the string has ended, all
  double length_ = 0.0;
};

}  // namespace waywright::path
