#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "waywright/point.hpp"

#include "constraint/constrained_triangulation.hpp"

namespace waywright::path {

/// The taut string through one channel. Use one object for many channels, because it keeps its memory.
///
/// The class keeps the funnel of the channel at the current portal (see `funnel.hpp`). The apex is the last turn that
/// is certain. The array `row_` contains both strings of the funnel from the apex on: first the left one from its end
/// to the apex, then the right one from the apex to its end. Cost: O(1) per portal, amortised.
class TautString {
 public:
  using Geometry = exact::Geometry;

  /// Starts a new string from the point `start`, which sees the first portal of a channel of `portal_count` portals.
  void begin(const Geometry& geometry, const Point& start, mesh::Vertex left, mesh::Vertex right,
             std::size_t portal_count);
  /// Moves the left (or right) end of the portal to `v`.
  void move_left(mesh::Vertex v);
  void move_right(mesh::Vertex v);
  /// Ends the string at `goal`. Requires: `goal` lies in the face beyond the last portal.
  void end_at(const Point& goal);

  /// The start of the string and the points at which it turns, each coordinate rounded to the nearest double. The goal
  /// is not among them.
  [[nodiscard]] std::span<const Point> points() const { return points_; }
  /// The length of the string. Requires: the string has ended.
  [[nodiscard]] double length() const { return length_; }

 private:
  using View = Geometry::View;

  struct Strings;

  /// Moves the apex along the string to the right (or left) end, to the node at the index `apex`.
  void move_apex_right(std::size_t apex) {
    while (apex_ < apex) turn_at(row_[apex_++]);
  }
  void move_apex_left(std::size_t apex) {
    while (apex_ > apex) turn_at(row_[apex_--]);
  }
  void turn_at(const View& node) { points_.push_back({node.x, node.y}); }

  const Geometry* geometry_ = nullptr;
  std::vector<View> row_;
  std::size_t left_ = 0;  ///< indices in `row_`: of the left end, of the apex, of the right end
  std::size_t apex_ = 0;
  std::size_t right_ = 0;
  std::vector<Point> points_;  ///< the nodes before the apex; after end_at(), all nodes except the goal
  double length_ = 0.0;
};

}  // namespace waywright::path
