#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "waywright/memory_use.hpp"

#include "base/compiler.hpp"
#include "exact/any_geometry.hpp"
#include "exact/counts.hpp"
#include "exact/crossing.hpp"
#include "exact/exact_point.hpp"
#include "exact/filter.hpp"
#include "exact/sign.hpp"
#include "memory/count.hpp"
#include "memory/journal.hpp"

namespace waywright::exact {

/// The places of a mesh's vertices, and the four questions that the combinatorial code asks about them: orientation,
/// in-circle, order, and where two segments cross. Other arithmetic can take its place: see AnyGeometry.
///
/// Places are logged as they change and can be taken back to the last begin().
///
/// A vertex is named by its index. A question is answered by rounded coordinates, where these are enough; only where
/// they aren't is it looked up whether a vertex is constructed, and of which lines.
class Geometry {
  static constexpr std::uint32_t kNoVertex = 0xffffffff;

 public:
  /// How a place is handed to a question: rounded, and whose it is.
  struct View {
    double x = 0.0;
    double y = 0.0;
    std::uint32_t vertex = kNoVertex;  ///< kNoVertex: an explicit point
  };

  /// The line from one place to another, for asking of many on which side of it they lie.
  struct Line {
    View from;
    View to;
    double dx = 0.0;
    double dy = 0.0;
    Line() = default;
    Line(const View& a, const View& b) : from(a), to(b), dx(b.x - a.x), dy(b.y - a.y) {}
  };

  /// Requires: all vertices, and all points asked about, lie in the box.
  explicit Geometry(const Box& box)
      : orientation_error_(filter::largest_orientation_error(box)),
        in_circle_place_(filter::coarse::in_circle_place(box)) {}

  /// Puts an explicit point, in range, at `vertex`, growing the table where needed.
  void place(std::uint32_t vertex, const Point& point);
  /// Puts explicit points, in range, at the vertices from 0 on, for good. Requires: there are no places yet.
  void place_all(std::vector<Point>&& points) { places_ = std::move(points); }
  /// Puts the crossing of the lines through (a, b) and (c, d), explicit vertices all, at `vertex`.
  void place_crossing(std::uint32_t vertex, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);
  /// Forgets the place of `vertex`.
  void clear(std::uint32_t vertex);

  /// Starts the log anew.
  void begin();
  /// Takes back everything since begin(). Allocates nothing.
  void roll_back();

  [[nodiscard]] View view(std::uint32_t vertex) const {
    const Point& place = places_[vertex];
    return {place.x, place.y, vertex};
  }
  /// Has the memory fetched that view(vertex) reads.
  void prefetch(std::uint32_t vertex) const { base::prefetch(&places_[vertex]); }
  [[nodiscard]] static View view(const Point& point) { return {point.x, point.y, kNoVertex}; }

  /// The vertex's coordinates, each as the nearest double.
  [[nodiscard]] const Point& nearest(std::uint32_t vertex) const { return places_[vertex]; }
  [[nodiscard]] bool is_explicit(std::uint32_t vertex) const { return crossing_of(vertex) == kExplicit; }
  /// Whether there may be a constructed vertex. If not, there is none.
  [[nodiscard]] bool has_constructed() const { return !crossing_of_.empty(); }
  /// The place itself. It stays valid until a vertex is added.
  [[nodiscard]] ExactPoint exact(std::uint32_t vertex) const { return exact(view(vertex)); }

  [[nodiscard]] Sign orientation(const View& a, const View& b, const View& c) const {
    const Sign sign = filter::sign_beyond(filter::orientation_determinant(a, b, c), orientation_error_);
    if (sign != Sign::zero) {
      ++counts.orientation.doubles;
      return sign;
    }
    return finer_orientation(copy(a), copy(b), copy(c));
  }
  /// The orientation of the line's two places and `c`.
  [[nodiscard]] Sign side(const Line& line, const View& c) const {
    // The filter's determinant of the second place, c and the first, of which two differences are known.
    const double determinant = line.dx * (c.y - line.from.y) - line.dy * (c.x - line.from.x);
    const Sign sign = filter::sign_beyond(determinant, orientation_error_);
    if (sign != Sign::zero) {
      ++counts.orientation.doubles;
      return sign;
    }
    return finer_orientation(copy(line.from), copy(line.to), copy(c));
  }
  [[nodiscard]] Sign in_circle(const View& a, const View& b, const View& c, const View& d) const {
    if (const Sign sign = filter::coarse::in_circle(a, b, c, d, in_circle_place_); sign != Sign::zero) {
      ++counts.in_circle.doubles;
      return sign;
    }
    return finer_in_circle(copy(a), copy(b), copy(c), copy(d));
  }
  [[nodiscard]] std::strong_ordering order(const View& p, const View& q) const {
    if (p.x == q.x && !crossing_of_.empty()) return finer_order(copy(p), copy(q));
    ++counts.order.doubles;
    return filter::order(p, q);
  }

  void count_memory(MemoryUse& use) const {
    memory::count(use, &MemoryUse::vertices, places_);
    memory::count(use, &MemoryUse::crossings, crossing_of_);
    memory::count(use, &MemoryUse::crossings, crossings_);
    memory::count_spare(use, free_crossings_, left_crossings_);
    journal_.count_memory(use);
  }
  /// Gives back spare memory, but not that of `free_crossings_`, which roll_back() needs. Requires: nothing has changed
  /// since begin().
  void shrink_to_fit() {
    memory::shrink(places_, crossing_of_, crossings_);
    memory::release(left_crossings_);
    journal_.release();
  }

 private:
  static constexpr std::uint32_t kExplicit = 0xffffffff;

  struct Undo {
    Point place;  ///< the one before
    std::uint32_t vertex;
    std::uint32_t crossing;  ///< the one before
  };

  // These take copies made for them, so that compilers keep the views of a question in registers until then.
  [[nodiscard]] static View copy(const View& view) { return {view.x, view.y, view.vertex}; }
  [[nodiscard]] Sign finer_orientation(const View& a, const View& b, const View& c) const;
  [[nodiscard]] Sign finer_in_circle(const View& a, const View& b, const View& c, const View& d) const;
  [[nodiscard]] std::strong_ordering finer_order(const View& p, const View& q) const;

  [[nodiscard]] std::uint32_t crossing_of(std::uint32_t vertex) const {
    return vertex < crossing_of_.size() ? crossing_of_[vertex] : kExplicit;
  }
  [[nodiscard]] bool is_explicit(const View& view) const { return is_explicit(view.vertex); }
  void log(std::uint32_t vertex) { journal_.add({places_[vertex], vertex, crossing_of(vertex)}); }
  [[nodiscard]] ExactPoint exact(const View& view) const;
  [[nodiscard]] std::uint32_t add_crossing(const Crossing& crossing);

  double orientation_error_;
  double in_circle_place_;
  std::vector<Point> places_;
  std::vector<std::uint32_t> crossing_of_;  ///< of the vertices up to the last constructed one
  std::vector<Crossing> crossings_;
  std::vector<std::uint32_t> free_crossings_;  ///< has room for all
  std::vector<std::uint32_t> left_crossings_;  ///< free from the next begin() on; until then they may be taken back
  memory::Journal<Undo> journal_;
};

static_assert(AnyGeometry<Geometry>);

}  // namespace waywright::exact
