#pragma once

#include <cstdint>

#include "waywright/point.hpp"

namespace waywright {

/// @addtogroup world
/// @{

/// A region that an operation has changed: an element of the answer of World::changes_since.
///
/// @code{.cpp}
/// const std::uint64_t before = world.version();
/// world.insert(house).value();
/// const ChangedBox changed = world.changes_since(before)->front();
/// const Box region = changed.box;               // == Box{{70, 45}, {75, 55}}
/// const bool is_only_new = !changed.is_removal;  // == true
/// @endcode
struct ChangedBox {
  std::uint64_t version = 0;  ///< the version of the world after the operation
  /// The bounding box of an item that the operation inserted or removed. If the operation has more than 256 items, the
  /// last box is the bounding box of several items.
  Box box;
  bool is_insertion = false;  ///< whether the operation inserted an item in the box
  bool is_removal = false;    ///< whether the operation removed an item in the box
};

/// @}

}  // namespace waywright
