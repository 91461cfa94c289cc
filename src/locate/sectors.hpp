#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "waywright/point.hpp"

#include "locate/curve.hpp"
#include "mesh/index.hpp"

namespace waywright::locate {

/// Where to start a walk from: the domain's square cells, each of which remembers a vertex in it or near. Queries only
/// read them. What a sector remembers may have gone since; a hint is no more than that.
///
/// The number of sectors grows with the number of vertices, so that on even data a walk is short however large the
/// world; a sector that turns out to be crowded is divided in four, over and over, so that it is on uneven data as
/// well. What sectors there are depends on the history; what is found with their help does not.
///
/// Source: Chen 2009, section 3.2.1 (sector-based location). Departure: updates feed the sectors, queries don't, and
/// their number isn't fixed.
class Sectors {
 public:
  explicit Sectors(const Box& domain) : curve_(domain), sectors_(4, kNone) {}

  /// The vertex that the sector of `point` remembers, or kNoVertex.
  [[nodiscard]] mesh::Vertex near(const Point& point) const {
    const Cell cell = sectors_[find(curve_.key(point)).index];
    return cell == kNone ? mesh::kNoVertex : mesh::Vertex{cell};
  }
  /// Whether both points lie in one sector.
  [[nodiscard]] bool are_in_one(const Point& p, const Point& q) const;

  /// Starts anew, from vertices along the curve: vertex `first` has the first of the keys, and so on. Cost: linear.
  void fill(std::span<const Curve::Key> keys, std::uint32_t first);
  /// Takes note of a vertex in a world of so many. Cost: O(1), amortised.
  void remember(const Point& point, mesh::Vertex v, std::size_t vertex_count);
  /// Where `v`, which goes, is remembered, remembers `other`.
  void forget(const Point& point, mesh::Vertex v, mesh::Vertex other);
  /// Divides the sector of `point`, in a world of so many vertices. Cost: O(1), amortised.
  void divide(const Point& point, std::size_t vertex_count);

 private:
  /// What a sector remembers; with kDivided set, where its four quarters start, in the curve's order.
  using Cell = std::uint32_t;
  static constexpr Cell kDivided = 0x80000000;
  static constexpr Cell kNone = 0x7fffffff;
  static constexpr std::size_t kVerticesPerSector = 3;
  static constexpr std::size_t kCrowd = 8;
  static constexpr int kKeyBits = 64;

  struct Found {
    std::size_t index;
    int shift;  ///< keys that agree above this bit are in the same sector
  };
  [[nodiscard]] Found find(Curve::Key key) const {
    int shift = whole_shift_;
    std::size_t index = static_cast<std::size_t>(key >> shift);
    while ((sectors_[index] & kDivided) != 0) {
      shift -= 2;
      index = (sectors_[index] & ~kDivided) + static_cast<std::size_t>(key >> shift & 3);
    }
    return {index, shift};
  }
  [[nodiscard]] std::size_t whole_count() const { return std::size_t{1} << (kKeyBits - whole_shift_); }
  [[nodiscard]] Cell any_vertex(Cell cell) const;
  void grow();
  void fill_sector(std::size_t index, int shift, std::span<const Curve::Key> keys, std::uint32_t first);

  Curve curve_;
  int whole_shift_ = kKeyBits - 2;
  std::vector<Cell> sectors_;  ///< the whole ones along the curve, then quarters, four by four
};

}  // namespace waywright::locate
