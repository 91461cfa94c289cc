#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "exact/any_geometry.hpp"
#include "exact/crossing.hpp"
#include "exact/exact_point.hpp"
#include "exact/predicates.hpp"

namespace waywright::exact {

/// The places of a mesh's vertices, and the four questions that the combinatorial code asks about them: orientation,
/// in-circle, order, and where two segments cross. Other arithmetic can take its place: see AnyGeometry.
///
/// Places are logged as they change and can be taken back to the last begin().
///
/// A vertex is named by its index. `View` is how a place is handed to a question; it stays valid until a vertex is
/// added.
class Geometry {
 public:
  using View = ExactPoint;

  /// Makes room for the vertices below `count`.
  void reserve(std::size_t count) { places_.reserve(count); }
  /// Puts an explicit point, in range, at `vertex`, growing the table where needed.
  void place(std::uint32_t vertex, const Point& point);
  /// Puts the crossing of the lines through (a, b) and (c, d), explicit vertices all, at `vertex`.
  void place_crossing(std::uint32_t vertex, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);
  /// Forgets the place of `vertex`.
  void clear(std::uint32_t vertex);

  /// Starts the log anew.
  void begin();
  /// Takes back everything since begin(). Allocates nothing.
  void roll_back();

  [[nodiscard]] View view(std::uint32_t vertex) const {
    const Place& place = places_[vertex];
    return {place.nearest.x, place.nearest.y, place.crossing == kExplicit ? nullptr : &crossings_[place.crossing]};
  }
  [[nodiscard]] static View view(const Point& point) { return explicit_point(point); }

  /// The vertex's coordinates, each as the nearest double.
  [[nodiscard]] const Point& nearest(std::uint32_t vertex) const { return places_[vertex].nearest; }

  [[nodiscard]] static Sign orientation(const View& a, const View& b, const View& c) {
    return exact::orientation(a, b, c);
  }
  [[nodiscard]] static Sign in_circle(const View& a, const View& b, const View& c, const View& d) {
    return exact::in_circle(a, b, c, d);
  }
  [[nodiscard]] static std::strong_ordering order(const View& p, const View& q) { return compare(p, q); }

 private:
  static constexpr std::uint32_t kExplicit = 0xffffffff;

  /// Both together, since no question asks for one alone.
  struct Place {
    Point nearest;
    std::uint32_t crossing = kExplicit;
  };
  struct Undo {
    std::uint32_t vertex;
    Place place;  ///< the one before
  };

  void grow_to(std::uint32_t vertex);
  void log(std::uint32_t vertex);
  [[nodiscard]] std::uint32_t add_crossing(const Crossing& crossing);

  std::vector<Place> places_;
  std::vector<Crossing> crossings_;
  std::vector<std::uint32_t> free_crossings_;  ///< has room for all
  std::vector<std::uint32_t> left_crossings_;  ///< free from the next begin() on; until then they may be taken back
  std::vector<Undo> log_;
};

static_assert(AnyGeometry<Geometry>);

}  // namespace waywright::exact
