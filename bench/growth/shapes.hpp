#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "waywright/item.hpp"
#include "waywright/world.hpp"

#include "random.hpp"

// Small helpers of the inputs.

namespace waywright::bench {

inline constexpr Box kGrowthDomain = {{-1000, -1000}, {1000, 1000}};

/// Returns the corners of a regular polygon around (0, 0), counter-clockwise.
[[nodiscard]] inline std::vector<Point> circle(double radius, std::size_t corners) {
  const Shape shape = Shape::regular_polygon({0, 0}, radius, corners);
  return {shape.rings.points().begin(), shape.rings.points().end()};
}

[[nodiscard]] inline Shape square(const Point& centre, double half) {
  return Shape::rectangle({{centre.x - half, centre.y - half}, {centre.x + half, centre.y + half}});
}

/// Returns the ids 1 to `count`.
[[nodiscard]] inline std::vector<ItemId> ids_up_to(std::size_t count) {
  std::vector<ItemId> ids(count);
  for (std::size_t i = 0; i < count; ++i) ids[i] = ItemId{i + 1};
  return ids;
}

/// Brings a list into random order, always the same.
template <class Element>
void shuffle(std::vector<Element>& elements) {
  Random random(1);
  for (std::size_t i = elements.size(); i > 1; --i) std::swap(elements[i - 1], elements[random.below(i)]);
}

/// Removes the items in the order of the list, and measures it.
template <class Meter>
void measure_removal(World& world, const std::vector<ItemId>& ids, Meter& meter) {
  meter.start();
  for (const ItemId id : ids) world.remove(id).value();
  meter.stop();
}

/// Inserts the shapes one by one, and measures it.
template <class Meter>
void measure_insertion(World& world, const std::vector<Shape>& shapes, Meter& meter) {
  meter.start();
  for (const Shape& shape : shapes) static_cast<void>(world.insert(shape).value());
  meter.stop();
}

}  // namespace waywright::bench
