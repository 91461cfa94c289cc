#pragma once

#include "path/optimal.hpp"

namespace waywright::path {

/// The cone of a window: the area between two rays from the root, its left and its right bound. (The function bound()
/// has another meaning: it returns a lower bound of a length.) The class decides whether a position lies left or right
/// of each of the two rays.
class Optimal::Cone {
 public:
  Cone(const Optimal& search, const Node& window)
      : geometry_(*search.geometry_),
        left_(ray(search, window.left_root, window.left)),
        right_(ray(search, window.right_root, window.right)) {}

  /// The orientation of `p`: positive if it lies left of the cone's left ray, negative if right of it.
  [[nodiscard]] exact::Sign orientation_to_left(const Geometry::View& p) const {
    return geometry_.orientation(left_, p);
  }
  /// The orientation of `p`: positive if it lies left of the cone's right ray, negative if right of it.
  [[nodiscard]] exact::Sign orientation_to_right(const Geometry::View& p) const {
    return geometry_.orientation(right_, p);
  }

  void set_left(const Geometry::Line& line) { left_ = line; }
  void set_right(const Geometry::Line& line) { right_ = line; }

  /// The directions from the roots along the bounds.
  [[nodiscard]] Point left_direction() const { return {left_.dx, left_.dy}; }
  [[nodiscard]] Point right_direction() const { return {right_.dx, right_.dy}; }

  /// Returns the line from a root through a vertex, or along the continuation.
  [[nodiscard]] static Geometry::Line ray(const Optimal& search, std::uint32_t root, mesh::Vertex v) {
    const Root& from = search.roots_[root];
    return v == kContinuation ? Geometry::Line(search.view(search.roots_[from.before]), search.view(from))
                              : Geometry::Line(search.view(from), search.geometry_->view(number(v)));
  }

 private:
  const Geometry& geometry_;
  // The lines on which the bounds lie. Each runs through its root, in the direction of a path along the bound.
  Geometry::Line left_;
  Geometry::Line right_;
};

}  // namespace waywright::path
