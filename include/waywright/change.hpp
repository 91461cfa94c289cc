#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

#include "waywright/error.hpp"
#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/point.hpp"

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

/// A region that an operation has changed: an element of the answer of World::changes_since.
///
/// @code{.cpp}
/// const std::uint64_t before = world.version();
/// world.insert(house).value();
/// const ChangedBox changed = world.changes_since(before)->front();
/// const Box region = changed.box;               // == Box{{70, 45}, {75, 55}}
/// const bool is_only_new = !changed.is_removal;  // == true
/// for (Unit& unit : units) {
///   if (!world.is_affected(unit.path, before)) continue;
///   if (!world.is_clear(unit.path.points, {}, context).value()) unit.path = world.find_path(unit.query).value();
/// }
/// @endcode
///
/// Each segment, polyline or polygon that an operation inserts or removes has a box. A replacement is a removal and an
/// insertion. A rewind counts as a removal, an insertion or both for each item that it changes. Items of the kind point
/// are not walls, and have no box. The world keeps at least the last 2,048 boxes. An operation has at most 256 boxes:
/// if it inserts and removes more than 256 items, the remaining items share the last box.
///
/// These boxes are enough to find out what a change means for paths, although the triangles of the mesh change outside
/// of them, too. Changes of the triangles alone do not matter for paths. A path stays clear unless an operation has
/// inserted an item there, or has removed a crossing at which the path turns (Path::points). In both cases the path
/// meets a box.
///
/// World::is_affected() and PathWatch compare paths with the boxes. For a path of a disc, is_affected() can also return
/// true if a box is a little farther from the path than the radius of Path::agent: by up to a 32nd of the radius near
/// an arc, and by rounding errors elsewhere. Only the distance between path and boxes counts. So if an operation
/// narrows a gap far from the path, the path is not affected.
///
/// @code{.cpp}
/// World yard = World::create({{0, 0}, {100, 100}}, {.keep_bridges = true}).value();
/// Path path = yard.find_path({.start = {20, 50}, .goal = {80, 50}, .agent = {.radius = 5}}).value();
/// const std::uint64_t before = yard.version();
/// yard.insert_segment({40, 56}, {60, 56}).value();
/// const bool is_affected_by_far = yard.is_affected(path, before);  // == false
/// yard.insert_segment({40, 54}, {60, 54}).value();
/// const bool is_affected_by_near = yard.is_affected(path, before);  // == true
/// @endcode
struct ChangedBox {
  std::uint64_t version = 0;  ///< the version of the world after the operation
  /// The bounding box of an item that the operation inserted or removed. If the operation inserted and removed more
  /// than 256 items, the last box is the bounding box of several items.
  Box box;
  bool is_insertion = false;  ///< whether the operation inserted an item in the box
  bool is_removal = false;    ///< whether the operation removed an item in the box
};

/// @}

class World;

namespace detail {

/// The result of World::attempt() for a question that returns a T.
template <class T>
struct ResultOf {
  using Type = Result<T>;
};
template <class T>
struct ResultOf<Result<T>> {
  using Type = Result<T>;
};

/// The result of World::attempt() for a question of this type.
template <class Question>
using ResultOfAttempt = typename ResultOf<std::remove_cvref_t<std::invoke_result_t<Question&, const World&>>>::Type;

/// Asks a question about a world. Returns the answer, or success if the question returns nothing.
template <class Question>
ResultOfAttempt<Question> ask(Question& question, const World& world) {
  if constexpr (std::is_void_v<std::invoke_result_t<Question&, const World&>>) {
    question(world);
    return {};
  } else {
    return question(world);
  }
}

/// The destructor of this class ends the attempt in a world, unless release() was called. `W` is World, which is
/// complete where this template is instantiated.
template <class W>
class AttemptGuard {
 public:
  explicit AttemptGuard(W& world) : world_(&world) {}
  ~AttemptGuard() {
    if (world_ != nullptr) world_->end_attempt();
  }
  AttemptGuard(const AttemptGuard&) = delete;
  AttemptGuard& operator=(const AttemptGuard&) = delete;

  void release() { world_ = nullptr; }

 private:
  W* world_;
};

}  // namespace detail

}  // namespace waywright
