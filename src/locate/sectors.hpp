#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "waywright/point.hpp"

#include "mesh/index.hpp"

namespace waywright::locate {

/// Where to start a walk from: a uniform grid over the domain, each sector of which remembers the vertex last made in
/// it. Queries only read it. What it remembers may have gone since; a hint is no more than that. The grid grows with
/// the number of vertices, so that on even data a walk is short however large the world.
///
/// Source: Chen 2009, section 3.2.1 (sector-based location). Departure: updates feed the sectors, queries don't, and
/// their number isn't fixed.
class Sectors {
 public:
  explicit Sectors(const Box& domain) : domain_(domain), vertices_(kSmallestSide * kSmallestSide, mesh::kNoVertex) {}

  /// The vertex that the sector of `point` remembers, or kNoVertex.
  [[nodiscard]] mesh::Vertex near(const Point& point) const { return vertices_[index(point)]; }

  /// Takes note of a vertex. Cost: O(1), amortised.
  void remember(const Point& point, mesh::Vertex v, std::size_t vertex_count) {
    if (vertex_count > kVerticesPerSector * vertices_.size()) grow();
    vertices_[index(point)] = v;
  }

 private:
  static constexpr std::size_t kSmallestSide = 4;
  static constexpr std::size_t kVerticesPerSector = 4;

  [[nodiscard]] std::size_t step(double at, double from, double to) const {
    const auto scaled = (at - from) / (to - from) * static_cast<double>(side_);
    return std::min(static_cast<std::size_t>(std::max(scaled, 0.0)), side_ - 1);
  }
  [[nodiscard]] std::size_t index(const Point& point) const {
    return step(point.y, domain_.min.y, domain_.max.y) * side_ + step(point.x, domain_.min.x, domain_.max.x);
  }

  /// Every sector becomes four that remember what it did.
  void grow() {
    std::vector<mesh::Vertex> finer(4 * vertices_.size());
    for (std::size_t y = 0; y < 2 * side_; ++y) {
      for (std::size_t x = 0; x < 2 * side_; ++x) finer[y * 2 * side_ + x] = vertices_[y / 2 * side_ + x / 2];
    }
    vertices_ = std::move(finer);
    side_ *= 2;
  }

  Box domain_;
  std::size_t side_ = kSmallestSide;
  std::vector<mesh::Vertex> vertices_;
};

}  // namespace waywright::locate
