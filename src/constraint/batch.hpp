#pragma once

#include <array>
#include <cstddef>
#include <iterator>
#include <span>

#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/point.hpp"

namespace waywright::constraint {

// Batches of items for ConstrainedTriangulation::insert_all. They only refer to data of the caller.

/// A batch of elements with a member `shape`. Element i is the item with the id ids[i].
class ShapeBatch {
 public:
  /// Requires: the elements and ids exist as long as this object.
  template <class Elements>
  ShapeBatch(const Elements& elements, std::span<const ItemId> ids) : elements_(std::data(elements)), ids_(ids) {
    shape_of_ = [](const void* all, std::size_t i) -> const Shape& {
      return static_cast<decltype(std::data(elements))>(all)[i].shape;
    };
  }

  [[nodiscard]] std::size_t size() const { return ids_.size(); }
  [[nodiscard]] ItemId id(std::size_t i) const { return ids_[i]; }
  [[nodiscard]] ItemKind kind(std::size_t i) const { return shape(i).kind; }
  [[nodiscard]] FillRule fill(std::size_t i) const { return shape(i).fill; }
  [[nodiscard]] const Rings& rings(std::size_t i) const { return shape(i).rings; }

 private:
  [[nodiscard]] const Shape& shape(std::size_t i) const { return shape_of_(elements_, i); }

  const void* elements_;
  std::span<const ItemId> ids_;
  const Shape& (*shape_of_)(const void* elements, std::size_t i);
};

/// A batch of points, each of them an item. Their ids count up from `first`, or are the elements of `ids` if this list
/// is not empty.
struct PointBatch {
  std::span<const Point> points;
  ItemId first;
  std::span<const ItemId> ids = {};

  [[nodiscard]] std::size_t size() const { return points.size(); }
  [[nodiscard]] ItemId id(std::size_t i) const { return ids.empty() ? ItemId{first.value + i} : ids[i]; }
  [[nodiscard]] static ItemKind kind(std::size_t /*i*/) { return ItemKind::point; }
  [[nodiscard]] static FillRule fill(std::size_t /*i*/) { return FillRule::even_odd; }
  [[nodiscard]] std::array<std::span<const Point>, 1> rings(std::size_t i) const { return {points.subspan(i, 1)}; }
};

/// Calls visit(point) for each corner of a ring. Consecutive points that are equal are one corner. In a closed ring,
/// the last points are one corner with the first point if they are equal to it. The function adds 0 to each coordinate,
/// which changes -0 into 0. So equal points have equal bits.
template <class Ring, class Visit>
void for_each_corner(const Ring& ring, bool is_closed, Visit&& visit) {
  std::size_t end = ring.size();
  while (is_closed && end > 1 && ring[end - 1] == ring[0]) --end;
  for (std::size_t i = 0; i < end; ++i) {
    if (i == 0 || ring[i] != ring[i - 1]) visit(Point{ring[i].x + 0.0, ring[i].y + 0.0});
  }
}

/// The number of corners that for_each_corner visits.
template <class Ring>
[[nodiscard]] std::size_t count_corners(const Ring& ring, bool is_closed) {
  std::size_t count = 0;
  for_each_corner(ring, is_closed, [&](const Point&) { ++count; });
  return count;
}

}  // namespace waywright::constraint
