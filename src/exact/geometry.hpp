#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <vector>

#include "waywright/memory_use.hpp"
#include "waywright/point.hpp"

#include "base/compiler.hpp"
#include "exact/crossing.hpp"
#include "exact/filter.hpp"
#include "exact/line_table.hpp"
#include "exact/position.hpp"
#include "memory/array.hpp"
#include "memory/count.hpp"
#include "memory/journal.hpp"
#include "memory/pages.hpp"

namespace waywright::exact {

/// The interface through which the triangulations use a geometry. A geometry stores the positions of vertices by index.
/// It has three predicates (orientation, in-circle and order), and it computes the crossing of two lines. The
/// constructor takes a box that contains all points. `exact::Geometry` is the library's implementation; the comments on
/// its members describe each function. Any class that gives the same answers can replace it. If a class rounds and
/// therefore gives wrong answers, the meshes are wrong.
///
/// A `View` is a position in the form that the predicates take. The view of a vertex stays valid until a vertex is
/// added. The view of a point stays valid as long as the caller keeps it.
template <class G>
concept AnyGeometry = std::constructible_from<G, const Box&> && std::semiregular<typename G::View> &&
    requires(G& changed, const G& asked, std::uint32_t vertex, const Point& point, const typename G::View& view) {
  // These functions set and clear positions. roll_back() takes all changes since the last begin() back.
  changed.set_position(vertex, point);
  changed.set_crossing(vertex, vertex, vertex, vertex, vertex);
  changed.clear(vertex);
  changed.begin();
  changed.roll_back();

  { asked.view(vertex) } -> std::convertible_to<typename G::View>;
  { asked.view(point) } -> std::convertible_to<typename G::View>;
  // The position, rounded to doubles: for output and for hints where to start a search.
  { asked.rounded(vertex) } -> std::convertible_to<Point>;

  // The three predicates: left or right of a line, inside or outside a circle, first or second in (x, y) order.
  { asked.orientation(view, view, view) } -> std::same_as<Sign>;
  { asked.in_circle(view, view, view, view) } -> std::same_as<Sign>;
  { asked.order(view, view) } -> std::same_as<std::strong_ordering>;
};

/// The positions of a mesh's vertices, and the functions on positions that the triangulations need: the predicates
/// orientation, in-circle and order, and the crossing of two lines. A class with other arithmetic can replace this
/// class: see AnyGeometry.
///
/// An undo log records the changes of positions, and roll_back() takes them back to the last begin().
///
/// The caller names a vertex by its index. The predicates first use rounded coordinates. Only if these do not decide,
/// the predicates look up whether a vertex is constructed, and from which lines.
class Geometry {
  static constexpr std::uint32_t kNoVertex = 0xffffffff;

 public:
  /// A position in the form that the predicates take: the rounded coordinates, and the vertex at that position.
  struct View {
    double x = 0.0;
    double y = 0.0;
    std::uint32_t vertex = kNoVertex;  ///< kNoVertex: an explicit position
  };

  /// The line from one position to another, for tests of many positions against one line.
  struct Line {
    View from;
    View to;
    double dx = 0.0;
    double dy = 0.0;
    Line() = default;
    Line(const View& a, const View& b) : from(a), to(b), dx(b.x - a.x), dy(b.y - a.y) {}
  };

  /// Requires: all vertices, and all points that are passed to view(), lie in the box.
  explicit Geometry(const Box& box)
      : orientation_error_(filter::largest_orientation_error(box)),
        in_circle_position_term_(filter::coarse::in_circle_position_term(box)) {}

  /// Sets the position of `vertex` to an explicit position. Makes the table longer if needed. Requires: the point is in
  /// range, and the vertex is not constructed.
  void set_position(std::uint32_t vertex, const Point& point);
  /// Sets the positions of the vertices from 0 on to explicit positions. The undo log does not record this. Requires:
  /// there are no positions yet, and the points are in range.
  void set_positions(memory::Array<Point>&& points) { positions_ = std::move(points); }
  /// Sets the position of `vertex` to the crossing of the lines through (a, b) and (c, d). Requires: these four
  /// vertices are explicit, and `vertex` is not constructed.
  void set_crossing(std::uint32_t vertex, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);
  /// Makes a constructed vertex explicit, before the mesh frees it: its two lines then have one use less. Does nothing
  /// if the vertex is explicit.
  void clear(std::uint32_t vertex);

  /// Empties the undo log.
  void begin();
  /// Takes back everything since begin(). Allocates nothing.
  void roll_back();

  [[nodiscard]] View view(std::uint32_t vertex) const {
    const Point& position = positions_[vertex];
    return {position.x, position.y, vertex};
  }
  /// Prefetches the memory that view(vertex) reads.
  void prefetch(std::uint32_t vertex) const { base::prefetch(&positions_[vertex]); }
  [[nodiscard]] static View view(const Point& point) { return {point.x, point.y, kNoVertex}; }

  /// The coordinates of the vertex, each rounded to the nearest double.
  [[nodiscard]] const Point& rounded(std::uint32_t vertex) const { return positions_[vertex]; }
  [[nodiscard]] bool is_explicit(std::uint32_t vertex) const { return lines_of(vertex).one == LineTable::kNone; }
  /// Whether there is a constructed vertex.
  [[nodiscard]] bool has_constructed() const { return constructed_count_ != 0; }
  /// The exact position of a vertex. The result stays valid until a vertex is added.
  [[nodiscard]] ExactPosition exact(std::uint32_t vertex) const { return exact(view(vertex)); }

  [[nodiscard]] Sign orientation(const View& a, const View& b, const View& c) const {
    const Sign sign = filter::sign_beyond(filter::orientation_determinant(a, b, c), orientation_error_);
    if (sign != Sign::zero) {
      ++counts.orientation.doubles;
      return sign;
    }
    return finer_orientation(copy(a), copy(b), copy(c));
  }
  /// The orientation of the line's two positions and `c`: positive if `c` lies left of the line.
  [[nodiscard]] Sign orientation(const Line& line, const View& c) const {
    // This is orientation_determinant(line.to, c, line.from). The line stores two of the four differences.
    const double determinant = line.dx * (c.y - line.from.y) - line.dy * (c.x - line.from.x);
    const Sign sign = filter::sign_beyond(determinant, orientation_error_);
    if (sign != Sign::zero) {
      ++counts.orientation.doubles;
      return sign;
    }
    return finer_orientation(copy(line.from), copy(line.to), copy(c));
  }
  [[nodiscard]] Sign in_circle(const View& a, const View& b, const View& c, const View& d) const {
    if (const Sign sign = filter::coarse::in_circle(a, b, c, d, in_circle_position_term_); sign != Sign::zero) {
      ++counts.in_circle.doubles;
      return sign;
    }
    return finer_in_circle(copy(a), copy(b), copy(c), copy(d));
  }
  [[nodiscard]] std::strong_ordering order(const View& p, const View& q) const {
    if (p.x == q.x && has_constructed()) return finer_order(copy(p), copy(q));
    ++counts.order.doubles;
    return filter::order(p, q);
  }

  void count_memory(MemoryUse& use) const {
    memory::count(use, &MemoryUse::vertices, positions_);
    lines_of_.count_memory(use, &MemoryUse::crossings);
    lines_.count_memory(use, &MemoryUse::crossings);
    position_journal_.count_memory(use);
    lines_journal_.count_memory(use);
  }
  /// Frees spare memory. Requires: nothing has changed since begin().
  void shrink_to_fit() {
    memory::shrink(positions_);
    lines_of_.shrink_to_fit();
    lines_.shrink_to_fit();
    position_journal_.release();
    lines_journal_.release();
  }

 private:
  static constexpr std::size_t kVerticesPerPage = 64;

  /// The two lines that cross at a vertex. An explicit vertex has none.
  struct Lines {
    LineTable::Slot one = LineTable::kNone;
    LineTable::Slot other = LineTable::kNone;
  };
  /// The position of a vertex before a change, or its lines.
  struct PositionUndo {
    Point position;
    std::uint32_t vertex;
  };
  struct LinesUndo {
    Lines lines;
    std::uint32_t vertex;
  };

  // The callers pass copies of their views to these functions. So the compiler can keep the views themselves in
  // registers until the call.
  [[nodiscard]] static View copy(const View& view) { return {view.x, view.y, view.vertex}; }
  [[nodiscard]] Sign finer_orientation(const View& a, const View& b, const View& c) const;
  [[nodiscard]] Sign finer_in_circle(const View& a, const View& b, const View& c, const View& d) const;
  [[nodiscard]] std::strong_ordering finer_order(const View& p, const View& q) const;

  [[nodiscard]] Lines lines_of(std::uint32_t vertex) const {
    const Lines* const lines = lines_of_.find(vertex);
    return lines == nullptr ? Lines{} : *lines;
  }
  [[nodiscard]] bool is_explicit(const View& view) const { return is_explicit(view.vertex); }
  [[nodiscard]] ExactPosition exact(const View& view) const;

  double orientation_error_;
  double in_circle_position_term_;
  memory::Array<Point> positions_;
  memory::Pages<Lines, kVerticesPerPage> lines_of_;  ///< by vertex; has room for every constructed vertex
  std::uint32_t constructed_count_ = 0;
  LineTable lines_;
  LineTable::Slot recent_line_ = LineTable::kNone;  ///< the first line of the last new crossing
  memory::Journal<PositionUndo> position_journal_;
  memory::Journal<LinesUndo> lines_journal_;
};

static_assert(AnyGeometry<Geometry>);

}  // namespace waywright::exact
