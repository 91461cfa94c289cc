#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/point.hpp"

namespace waywright::constraint {

// Batches of items for ConstrainedTriangulation::insert_all. They only refer to data of the caller.

/// A batch of elements with a member `shape`. Element i is the item with the id ids[i].
template <class Element>
struct ShapeBatch {
  std::span<const Element> elements;
  std::span<const ItemId> ids;

  [[nodiscard]] std::size_t size() const { return elements.size(); }
  [[nodiscard]] ItemId id(std::size_t i) const { return ids[i]; }
  [[nodiscard]] ItemKind kind(std::size_t i) const { return elements[i].shape.kind; }
  [[nodiscard]] FillRule fill(std::size_t i) const { return elements[i].shape.fill; }
  [[nodiscard]] const Rings& rings(std::size_t i) const { return elements[i].shape.rings; }
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

}  // namespace waywright::constraint
