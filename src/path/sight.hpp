#pragma once

#include <algorithm>

#include "waywright/point.hpp"

#include "path/distance.hpp"

namespace waywright::path {

/// A channel's funnel, as far as a search needs to know it to choose: the last corner that the taut string surely turns
/// at, the string's length up to there, and the cone in which the corner sees the way on. All in doubles, and where the
/// string turns the corners on the way to the next portal are forgotten; so lengths come out right or a little short.
class Sight {
 public:
  Sight() = default;
  /// From a point on the border of, or inside, a face that is left by the portal.
  Sight(const Point& from, const Point& left, const Point& right) : root_(from), left_(left), right_(right) {}

  /// The portal's left, or right, end moves on to `v`; the other stays.
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

  /// The length of the string to here and straight on to the goal, or by one of the cone's ends.
  [[nodiscard]] double length_to(const Point& goal) const {
    const bool is_left = cross(from_root(left_), from_root(goal)) > 0.0;
    const bool is_right = cross(from_root(right_), from_root(goal)) < 0.0;
    if (!is_left && !is_right) return length_ + distance(root_, goal);
    if (!is_right) return length_ + length_by_way_of(root_, left_, goal);
    if (!is_left) return length_ + length_by_way_of(root_, right_, goal);
    return length_ + std::min(length_by_way_of(root_, left_, goal), length_by_way_of(root_, right_, goal));
  }

 private:
  [[nodiscard]] Point from_root(const Point& p) const { return {p.x - root_.x, p.y - root_.y}; }
  void turn_at(const Point& corner) {
    length_ += distance(root_, corner);
    root_ = corner;
  }

  Point root_;
  Point left_;
  Point right_;
  double length_ = 0.0;
};

}  // namespace waywright::path
