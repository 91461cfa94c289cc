#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "waywright/memory_use.hpp"
#include "waywright/point.hpp"

#include "base/compiler.hpp"
#include "exact/position.hpp"
#include "memory/array.hpp"

namespace waywright::bench {

/// A reference to a Position, which is too large to copy: the Position of a vertex, or one that was made for a point
/// that is not a vertex.
template <class Position>
class PositionView {
 public:
  PositionView() = default;  // refers to nothing yet
  explicit PositionView(const Position* vertex) : position_(vertex) {}
  explicit PositionView(Position&& point)
      : owned_(std::make_shared<const Position>(std::move(point))), position_(owned_.get()) {}

  const Position* operator->() const { return position_; }

 private:
  std::shared_ptr<const Position> owned_;
  const Position* position_ = nullptr;
};

/// A geometry (exact::AnyGeometry) over arithmetic other than the library's. It stores, logs and prefetches the same
/// data at the same times as exact::Geometry, so that a comparison compares only arithmetic.
///
/// An Arithmetic has: a `Position`, the coordinates of a vertex, with a `rounded` Point; a `View` of one; `at(point)`
/// and `crossing(a, b, c, d)`, which make a Position; `view(position)` and `view(point)`; and the three predicates on
/// views.
template <class Arithmetic>
class RivalGeometry {
 public:
  using View = typename Arithmetic::View;

  explicit RivalGeometry(const Box& /*box*/) {}

  void set_position(std::uint32_t vertex, const Point& point) { put(vertex, Arithmetic::at(point)); }
  void set_positions(memory::Array<Point>&& points) {
    for (std::uint32_t v = 0; v < points.size(); ++v) set_position(v, points[v]);
  }
  void set_crossing(std::uint32_t vertex, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    put(vertex, Arithmetic::crossing(positions_[a], positions_[b], positions_[c], positions_[d]));
  }
  void clear(std::uint32_t) {}  // the next vertex with this slot overwrites it

  void begin() { log_.clear(); }
  void roll_back() {
    for (; !log_.empty(); log_.pop_back()) positions_[log_.back().vertex] = std::move(log_.back().position);
  }
  static void count_memory(MemoryUse&) {}
  static void shrink_to_fit() {}

  [[nodiscard]] View view(std::uint32_t vertex) const { return Arithmetic::view(positions_[vertex]); }
  void prefetch(std::uint32_t vertex) const { base::prefetch(&positions_[vertex]); }
  [[nodiscard]] static View view(const Point& point) { return Arithmetic::view(point); }
  [[nodiscard]] const Point& rounded(std::uint32_t vertex) const { return positions_[vertex].rounded; }

  [[nodiscard]] static exact::Sign orientation(const View& a, const View& b, const View& c) {
    return Arithmetic::orientation(a, b, c);
  }
  [[nodiscard]] static exact::Sign in_circle(const View& a, const View& b, const View& c, const View& d) {
    return Arithmetic::in_circle(a, b, c, d);
  }
  [[nodiscard]] static std::strong_ordering order(const View& p, const View& q) { return Arithmetic::order(p, q); }

 private:
  using Position = typename Arithmetic::Position;
  struct Undo {
    std::uint32_t vertex;
    Position position;  ///< the position before the change
  };

  void put(std::uint32_t vertex, Position position) {
    if (vertex >= positions_.size()) positions_.resize(vertex + std::size_t{1});
    log_.push_back({vertex, std::move(positions_[vertex])});
    positions_[vertex] = std::move(position);
  }

  std::vector<Position> positions_;
  std::vector<Undo> log_;
};

}  // namespace waywright::bench
