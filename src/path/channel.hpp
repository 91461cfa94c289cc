#pragma once

#include <algorithm>
#include <cstdint>

#include "waywright/point.hpp"

#include "mesh/triangle_mesh.hpp"
#include "path/distance.hpp"

namespace waywright::path {

/// An estimate of the length of a channel, by which a search chooses between channels. It consists of a point (the
/// root), the length of the string up to the root, and the cone in which the rest of the channel is visible from the
/// root.
///
/// A Sight is not a funnel: it decides in doubles and keeps only the cone. A vertex outside the cone does not change
/// the cone, but the funnel would contain it as a node. When the string turns, the Sight has no record of the vertices
/// between the new root and the next portal. So a length is right or a little too short.
class Sight {
 public:
  Sight() = default;
  /// Makes the cone from `from` through the first portal. `from` lies in the face that the channel leaves through this
  /// portal, or on its border.
  Sight(const Point& from, const Point& left, const Point& right) : root_(from), left_(left), right_(right) {}

  /// Moves the left (or right) end of the portal to `v`. The other end stays.
  void move_left(const Point& v, const Point& right_end) {
    if (cross(from_root(left_), from_root(v)) > 0.0) return;
    if (cross(from_root(right_), from_root(v)) < 0.0) {
      turn_at(right_);
      right_ = right_end;
    }
    left_ = v;
  }
  void move_right(const Point& v, const Point& left_end) {
    if (cross(from_root(right_), from_root(v)) < 0.0) return;
    if (cross(from_root(left_), from_root(v)) > 0.0) {
      turn_at(left_);
      left_ = left_end;
    }
    right_ = v;
  }

  /// Returns the length of the string to `goal` through the root. If `goal` lies in the cone, the string is straight
  /// from the root on. Otherwise it passes through an end of the last portal.
  [[nodiscard]] double length_to(const Point& goal) const {
    const bool is_left = cross(from_root(left_), from_root(goal)) > 0.0;
    const bool is_right = cross(from_root(right_), from_root(goal)) < 0.0;
    if (!is_left && !is_right) return length_ + distance(root_, goal);
    if (!is_right) return length_ + distance_via_point(root_, left_, goal);
    if (!is_left) return length_ + distance_via_point(root_, right_, goal);
    return length_ + std::min(distance_via_point(root_, left_, goal), distance_via_point(root_, right_, goal));
  }

 private:
  [[nodiscard]] Point from_root(const Point& p) const { return {p.x - root_.x, p.y - root_.y}; }
  void turn_at(const Point& at) {
    length_ += distance(root_, at);
    root_ = at;
  }

  Point root_;
  Point left_;
  Point right_;
  double length_ = 0.0;
};

/// A channel that a search has followed to the goal, or to a face where it has a choice.
struct ChannelNode {
  static constexpr std::uint32_t kNone = 0xffffffff;

  mesh::HalfEdge exit;   ///< the half-edge through which the channel left the face of the node before
  mesh::HalfEdge entry;  ///< the half-edge through which it entered this node's face
  std::uint32_t before;  ///< the index of the node before, or kNone: the channel comes from a start face
  Sight sight;
};

}  // namespace waywright::path
