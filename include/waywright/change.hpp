#pragma once

#include <cstdint>
#include <utility>

#include "waywright/id.hpp"
#include "waywright/item.hpp"

namespace waywright {

/// @addtogroup world
/// @{

/// One of several changes that World::apply makes together.
///
/// @code{.cpp}
/// const Shape barrier = Shape::segment({30, 40}, {40, 40});
/// const std::vector<Change> changes = {Change::insert(barrier, 12), Change::remove(2)};
/// const Path new_path = world.attempt(changes, [&](const World& changed) {
///   return changed.find_path({.start = start, .goal = goal});
/// }).value();
/// const std::size_t count = world.attempt(changes, [](const World& w) { return w.item_count(); }).value();  // == 2
/// const std::vector<Point> doors = {{10, 50}, {90, 50}};
/// const bool by_house = world.would_disconnect(house, doors).value();                               // == false
/// const bool by_wall = world.would_disconnect(Shape::segment({50, 0}, {50, 100}), doors).value();  // == true
/// world.apply(changes).value();
/// @endcode
struct Change {
  /// The kind of a change.
  enum class Kind : std::uint8_t { insert, remove, replace };

  Kind kind = Kind::insert;
  ItemId id;    ///< the id of the item; if it is null in an insertion, the world chooses the id
  Shape shape;  ///< the new shape, in an insertion or a replacement

  /// Returns the insertion of a shape under `id`, or under an id that the world chooses.
  [[nodiscard]] static Change insert(Shape shape, ItemId id = {}) { return {Kind::insert, id, std::move(shape)}; }
  /// Returns the removal of an item.
  [[nodiscard]] static Change remove(ItemId id) { return {Kind::remove, id, {}}; }
  /// Returns the replacement of the shape of an item.
  [[nodiscard]] static Change replace(ItemId id, Shape shape) { return {Kind::replace, id, std::move(shape)}; }
};

/// @}

}  // namespace waywright
