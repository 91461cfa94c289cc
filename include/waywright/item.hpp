#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "waywright/assert.hpp"
#include "waywright/export.hpp"
#include "waywright/id.hpp"
#include "waywright/point.hpp"

namespace waywright {

/// @addtogroup items
/// @{

/// The rings of a shape: lists of points, all in one array, so a shape with a single ring needs only one allocation.
///
/// @code{.cpp}
/// const Rings one = {{0, 0}, {4, 0}, {4, 4}};  // one ring, from braces
/// const std::vector<Point> outside = {{0, 0}, {8, 0}, {8, 8}, {0, 8}};
/// const std::vector<Point> hole = {{2, 2}, {4, 2}, {4, 4}};
/// Rings both = {outside, hole};  // two rings, from lists of points
/// both.push_back({{5, 5}, {6, 5}, {6, 6}});
/// std::size_t count = 0;
/// for (const PointSpan ring : both) count += ring.size();
/// const std::size_t corners = count;  // == 10
/// @endcode
///
/// You can make a Rings from other types that hold rings: several rings in braces `{{{0, 0}, {1, 0}, {1, 1}}}`, one
/// ring in braces `{{0, 0}, {1, 0}, {1, 1}}`, a list of points, or a list of lists of points. You can compare it with
/// another Rings, with a list of points, and with a list of lists of points. A loop over a Rings gives a PointSpan for
/// each ring. These views are valid until you add rings or points.
class Rings {
 public:
  /// An iterator over rings. The view that it returns is a member of the iterator, so a reference to the view is valid
  /// until the iterator moves or is destroyed.
  template <class P>
  class Iterator;
  using iterator = Iterator<Point>;
  using const_iterator = Iterator<const Point>;
  using value_type = PointSpan;

  /// Makes an object without rings.
  Rings() = default;
  Rings(const Rings&) = default;
  Rings& operator=(const Rings&) = default;
  /// Moves the rings. `other` has no rings afterwards.
  Rings(Rings&& other) noexcept
      : ring_count_(std::exchange(other.ring_count_, 0)),
        points_(std::move(other.points_)),
        later_begins_(std::move(other.later_begins_)) {
    other.clear();
  }
  Rings& operator=(Rings&& other) noexcept {
    if (this == &other) return *this;
    ring_count_ = std::exchange(other.ring_count_, 0);
    points_ = std::move(other.points_);
    later_begins_ = std::move(other.later_begins_);
    other.clear();
    return *this;
  }
  ~Rings() = default;
  /// Makes several rings.
  Rings(std::initializer_list<PointSpan> rings) { append_all(rings); }
  template <class List>
  requires std::convertible_to<const List&, std::span<const std::vector<Point>>> Rings(const List& rings) {
    append_all(std::span<const std::vector<Point>>(rings));
  }
  /// Makes one ring. This constructor is a template so that `{{}}` has one meaning: one ring without points.
  template <std::same_as<Point> P = Point>
  Rings(std::initializer_list<P> ring) : ring_count_(1), points_(ring) {}
  Rings(std::vector<Point> ring) : ring_count_(1), points_(std::move(ring)) {}
  template <class List>
  requires std::convertible_to<const List&, std::span<const Point>> Rings(const List& ring)
      : Rings(std::vector<Point>(PointSpan(ring))) {}

  /// Returns a copy as a list of lists.
  operator std::vector<std::vector<Point>>() const;

  [[nodiscard]] std::size_t size() const { return ring_count_; }
  [[nodiscard]] bool empty() const { return ring_count_ == 0; }

  /// Returns the i-th ring, from 0.
  /// Requires: i < size().
  [[nodiscard]] PointSpan operator[](std::size_t i) const { return ring_of(i, points()); }
  [[nodiscard]] MutablePointSpan operator[](std::size_t i) { return ring_of(i, points()); }
  /// Returns the first ring.
  /// Requires: there is a ring.
  [[nodiscard]] PointSpan front() const { return (*this)[0]; }
  [[nodiscard]] MutablePointSpan front() { return (*this)[0]; }
  /// Returns the last ring.
  /// Requires: there is a ring.
  [[nodiscard]] PointSpan back() const { return (*this)[ring_count_ - 1]; }
  [[nodiscard]] MutablePointSpan back() { return (*this)[ring_count_ - 1]; }

  [[nodiscard]] const_iterator begin() const;
  [[nodiscard]] const_iterator end() const;
  [[nodiscard]] iterator begin();
  [[nodiscard]] iterator end();

  /// Returns the points of all rings, ring after ring.
  [[nodiscard]] std::span<const Point> points() const { return points_; }
  [[nodiscard]] std::span<Point> points() { return points_; }

  /// Adds a ring of these points. They may be points of this object.
  void push_back(PointSpan ring) {
    const std::less<const Point*> before;
    const Point* const own = points_.data();
    const bool is_own = !before(ring.data(), own) && before(ring.data(), own + points_.size());
    const std::size_t offset = is_own ? static_cast<std::size_t>(ring.data() - own) : 0;
    start_ring();
    for (std::size_t i = 0; i < ring.size(); ++i) points_.push_back(is_own ? points_[offset + i] : ring[i]);
  }
  /// Adds a ring without points. Add points to it with add_point().
  void start_ring() {
    if (ring_count_ > 0) later_begins_.push_back(points_.size());
    ++ring_count_;
  }
  /// Adds a point to the last ring.
  /// Requires: there is a ring.
  void add_point(const Point& point) {
    WAYWRIGHT_ASSERT(ring_count_ > 0, "Rings::add_point: there is no ring yet");
    points_.push_back(point);
  }
  /// Reserves memory for `points` points, counted over all rings.
  void reserve(std::size_t points) { points_.reserve(points); }
  /// Returns the number of points for which there is memory, counted over all rings.
  [[nodiscard]] std::size_t capacity() const { return points_.capacity(); }
  /// Removes all rings, and keeps the memory.
  void clear() {
    ring_count_ = 0;
    points_.clear();
    later_begins_.clear();
  }

  friend bool operator==(const Rings&, const Rings&) = default;

 private:
  template <class List>
  void append_all(const List& rings) {
    std::size_t count = 0;
    for (const PointSpan ring : rings) count += ring.size();
    points_.reserve(count);
    for (const PointSpan ring : rings) push_back(ring);
  }
  /// Returns the points of the i-th ring. `points` are the points of all rings.
  template <class P>
  [[nodiscard]] std::span<P> ring_of(std::size_t i, std::span<P> points) const {
    WAYWRIGHT_ASSERT(i < ring_count_, "Rings: there is no ring with this index");
    const std::size_t begin = i == 0 ? 0 : later_begins_[i - 1];
    const std::size_t end = i + 1 == ring_count_ ? points.size() : later_begins_[i];
    return points.subspan(begin, end - begin);
  }

  std::size_t ring_count_ = 0;
  std::vector<Point> points_;
  std::vector<std::size_t> later_begins_;  ///< the index in `points_` at which each ring but the first begins
};

/// @}

template <class P>
class Rings::Iterator {
 public:
  using value_type = BasicPointSpan<P>;
  using reference = BasicPointSpan<P>&;
  using pointer = BasicPointSpan<P>*;
  using difference_type = std::ptrdiff_t;
  using iterator_category = std::input_iterator_tag;

  Iterator() = default;

  [[nodiscard]] BasicPointSpan<P>& operator*() const { return ring_; }
  [[nodiscard]] BasicPointSpan<P>* operator->() const { return &ring_; }
  Iterator& operator++() {
    ++index_;
    read();
    return *this;
  }
  Iterator operator++(int) {
    Iterator old = *this;
    ++*this;
    return old;
  }
  friend bool operator==(const Iterator& a, const Iterator& b) { return a.index_ == b.index_; }

 private:
  friend class Rings;
  using Owner = std::conditional_t<std::is_const_v<P>, const Rings, Rings>;

  Iterator(Owner& rings, std::size_t index) : rings_(&rings), index_(index) { read(); }
  void read() {
    if (index_ < rings_->size()) ring_ = (*rings_)[index_];
  }

  Owner* rings_ = nullptr;
  std::size_t index_ = 0;
  mutable BasicPointSpan<P> ring_;
};

inline Rings::operator std::vector<std::vector<Point>>() const { return {begin(), end()}; }
inline Rings::const_iterator Rings::begin() const { return {*this, 0}; }
inline Rings::const_iterator Rings::end() const { return {*this, ring_count_}; }
inline Rings::iterator Rings::begin() { return {*this, 0}; }
inline Rings::iterator Rings::end() { return {*this, ring_count_}; }

/// @addtogroup items
/// @{

/// The kind of an item.
enum class ItemKind : std::uint8_t {
  point,     ///< a vertex; it is not a wall
  segment,   ///< a straight line that no agent can cross; a segment of length zero acts as a point
  polyline,  ///< an open chain of straight lines that no agent can cross
  polygon,   ///< a solid obstacle of one or more closed rings; its FillRule says what lies inside
};

/// Returns the name of a kind in world scripts: `point`, `segment`, `polyline`, `polygon`.
[[nodiscard]] WAYWRIGHT_API std::string_view to_string(ItemKind kind);

/// The rule that says which positions lie inside a polygon. It uses the winding number of the position: how often the
/// rings go around it counter-clockwise, minus how often they go around it clockwise. The property `fill-rule` of SVG
/// has the same two values.
enum class FillRule : std::uint8_t {
  even_odd,  ///< inside if the winding number is odd: a ring in a ring bounds a hole, whatever its direction
  nonzero,   ///< inside if the winding number is not 0: a ring in a ring bounds a hole only if their directions differ
};

/// Returns whether a polygon with this rule covers the positions that have this winding number.
[[nodiscard]] constexpr bool is_filled(FillRule rule, std::int32_t winding_number) {
  return rule == FillRule::even_odd ? winding_number % 2 != 0 : winding_number != 0;
}

/// Returns the name of a fill rule: `even-odd`, `nonzero`.
[[nodiscard]] WAYWRIGHT_API std::string_view to_string(FillRule rule);

/// The form of an item, independent of any world. A point has one ring of one point, a segment one ring of two
/// points, a polyline one ring of one or more points. A polygon has one or more rings. In a polygon, the side from the
/// last point of a ring to its first point belongs to the ring, so you need not repeat the first point.
///
/// @code{.cpp}
/// const Shape house = Shape::rectangle({{2, 2}, {6, 5}});
/// const Shape tower = Shape::regular_polygon({8, 8}, 1.5, 12);
/// const Shape court = Shape::polygon({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {6, 3}, {6, 6}, {3, 6}}});  // a hole
/// world.insert(translated(house, 10, 10)).value();
/// @endcode
struct Shape {
  ItemKind kind = ItemKind::point;
  Rings rings;
  FillRule fill = FillRule::even_odd;  ///< for a polygon; a world ignores it for other kinds

  friend bool operator==(const Shape&, const Shape&) = default;

  /// Returns a point.
  [[nodiscard]] static Shape point(const Point& point) { return {ItemKind::point, {{point}}}; }
  /// Returns the segment from `a` to `b`.
  [[nodiscard]] static Shape segment(const Point& a, const Point& b) { return {ItemKind::segment, {{a, b}}}; }
  /// Returns the polyline through `points`.
  [[nodiscard]] static Shape polyline(PointSpan points) { return {ItemKind::polyline, points}; }
  /// Returns a polygon of one or more rings: `Shape::polygon({{0, 0}, {4, 0}, {4, 4}})`, `Shape::polygon({outside,
  /// hole})`.
  [[nodiscard]] static Shape polygon(Rings rings, FillRule fill = FillRule::even_odd) {
    return {ItemKind::polygon, std::move(rings), fill};
  }
  /// Returns the polygon of a box, counter-clockwise from the lower left corner.
  [[nodiscard]] static Shape rectangle(const Box& box) {
    return {ItemKind::polygon, {{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}}};
  }
  /// Returns the polygon of `corner_count` corners on a circle, counter-clockwise. The first corner lies to the right
  /// of the centre. The function rounds each corner to doubles. The result is the same on every machine. The radius is
  /// in the unit of the coordinates.
  /// A polygon has 3 corners or more: for a smaller `corner_count`, the shape has no rings, and a world refuses it
  /// (bad_shape).
  /// Cost: linear in the corners.
  [[nodiscard]] WAYWRIGHT_API static Shape regular_polygon(const Point& centre, double radius,
                                                           std::size_t corner_count);
};

/// @name Functions of shapes
///
/// @code{.cpp}
/// const Shape house = Shape::rectangle({{2, 2}, {6, 4}});
/// const Point centre = centroid(translated(house, 10, 0));  // == Point{14, 3}
/// @endcode
/// @{

/// Returns a copy of the shape, moved by (`dx`, `dy`). The coordinates are sums of doubles, rounded to nearest.
/// Cost: linear in the points of the shape.
[[nodiscard]] WAYWRIGHT_API Shape translated(const Shape& shape, double dx, double dy);

/// Returns the centroid of a shape, computed in plain doubles. For a polygon, this is the centroid of the area inside
/// it by its fill rule. For a polygon without area and for the other kinds, it is the mean of the points. If rings
/// cross each other or themselves, the result is an approximation.
/// Requires: the shape has a point.
/// Cost: linear in the points of the shape; for a polygon, the number of rings times the number of points.
/// Source: Bourke, *Calculating the area and centroid of a polygon*, 1988.
[[nodiscard]] WAYWRIGHT_API Point centroid(const Shape& shape);

/// @}

/// An item whose sides a segment meets: an element of the answer of World::items_crossed.
///
/// @code{.cpp}
/// for (const CrossedItem& crossed : world.items_crossed(start, goal).value()) {
///   std::printf("item %ju at (%g, %g)\n", std::uintmax_t{crossed.id.value}, crossed.at.x, crossed.at.y);
/// }
/// @endcode
struct CrossedItem {
  ItemId id;
  Point at;  ///< where the segment meets a side of the item, each coordinate rounded to the nearest double

  friend bool operator==(const CrossedItem&, const CrossedItem&) = default;
};

/// A shape and its id.
///
/// @code{.cpp}
/// const std::vector<Item> items = {{11, Shape::segment({5, 5}, {9, 5})}, {12, Shape::rectangle({{2, 2}, {4, 4}})}};
/// world.insert_all(items).value();
/// for (const ItemId id : world.item_ids()) {
///   const Shape shape = world.shape(id).value();
///   std::printf("item %ju is a %s\n", std::uintmax_t{id.value}, to_string(shape.kind).data());
/// }
/// const ItemId wall = world.insert_segment({10, 2}, {10, 9}).value();  // == 13
/// world.replace(wall, Shape::segment({11, 2}, {11, 9})).value();
/// world.remove(12).value();
/// const bool has_item = world.contains(12);  // == false
/// @endcode
struct Item {
  ItemId id;
  Shape shape;

  friend bool operator==(const Item&, const Item&) = default;
};

/// @}

}  // namespace waywright
