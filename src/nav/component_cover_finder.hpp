#pragma once

#include <cstdint>
#include <vector>

#include "constraint/cover_finder.hpp"
#include "nav/abstraction.hpp"

namespace waywright::nav {

/// Finds the polygons that cover a position. If the world keeps an abstraction, it reads them from the components.
/// Cost, with an abstraction: O(1) plus the size of the answer.
class ComponentCoverFinder final : public constraint::CoverFinder {
 public:
  /// Sets the abstraction from which this object reads; null for none. Requires: the abstraction exists as long as this
  /// object uses it.
  void use(const Abstraction* abstraction) {
    components_ = abstraction != nullptr ? &abstraction->components() : nullptr;
  }

  const std::vector<std::uint32_t>& of_face(const constraint::ExactTriangulation& triangulation,
                                            mesh::HalfEdge h) override {
    if (components_ == nullptr) return CoverFinder::of_face(triangulation, h);
    polygons_.clear();
    components_->for_each_cover(mesh::face(h), [&](std::uint32_t polygon) { polygons_.push_back(polygon); });
    return polygons_;
  }

  bool is_covered(const constraint::ExactTriangulation& triangulation, mesh::HalfEdge h) override {
    return components_ == nullptr ? CoverFinder::is_covered(triangulation, h) : components_->is_covered(mesh::face(h));
  }

 private:
  const Components* components_ = nullptr;
  std::vector<std::uint32_t> polygons_;
};

}  // namespace waywright::nav
