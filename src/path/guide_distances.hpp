#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "memory/scratch.hpp"
#include "path/dead_ends.hpp"
#include "path/disc_map.hpp"

namespace waywright::path {

/// The results of a guide (DiscGuide) for the search for the path of a disc: which vertices and edges a path may use if
/// it is not longer than a limit, and lower bounds of the length from a vertex to the goal.
class GuideDistances {
 public:
  /// Forgets the distances of the last search. `start` is the point at which the disc starts, relative to the origin of
  /// the map. `start_faces` are the faces that contain this point.
  void begin(const DiscMap& map, const Point& start, std::span<const mesh::Face> start_faces) {
    map_ = &map;
    dead_ends_.begin(map.mesh(), map.core, start_faces);
    start_ = start;
    limit_ = std::numeric_limits<double>::infinity();
    stamp_.next(kFirstStampBit, lengths_, crossed_);
    lengths_.grow_to(map.mesh().vertex_slots());
    crossed_.grow_to(map.mesh().face_slots());
  }

  /// Returns whether the guide may cross the edge: it is not closed (DiscMap::is_closed()), and it does not lead into a
  /// dead end without the start.
  [[nodiscard]] bool can_cross(mesh::HalfEdge exit) const {
    return dead_ends_.may_lead_to_goal(mesh::face(exit), exit) && !map_->is_closed(exit);
  }
  /// Records that a path of length `length` leads from the goal to a root, and that the root sees the vertex at a
  /// distance whose square is `squared`. The function computes no square root if it knows a shorter path to the vertex.
  void see(mesh::Vertex v, double length, double squared) {
    Length& known = lengths_[number(v)];
    if (known.query == stamp_.value()) {
      const double rest = known.length - length;
      if (rest <= 0.0 || squared >= rest * rest) return;
    }
    known = {length + std::sqrt(squared), stamp_.value()};
  }
  /// Records that the guide has entered the face `f` without crossing an edge: it starts there.
  void enter(mesh::Face f) { crossed_[number(f)] = std::max(crossed_[number(f)], stamp_.value()); }
  /// Records that the guide has crossed the edge `entry` and has entered the face `f`.
  void cross(mesh::Face f, mesh::HalfEdge entry) {
    std::uint32_t& crossed = crossed_[number(f)];
    if (crossed < stamp_.value()) crossed = stamp_.value();
    crossed |= bit_of(f, entry);
  }
  /// Sets the limit. The distances are complete when the guide has followed all windows whose bound is below it.
  void set_limit(double limit) { limit_ = limit; }

  /// Returns whether the guide has crossed the edge, or the goal of the disc, where the guide starts, lies on it.
  [[nodiscard]] bool is_crossed(mesh::HalfEdge h) const { return is_entered(h) || is_entered(map_->mesh().twin(h)); }
  /// Returns whether one of the two faces of the edge is a tree face (DeadEnds) that the guide has not entered. If so,
  /// the distances and marks say nothing about the edge, because a disc can touch a vertex of this face from outside of
  /// the face. `h` may also be the corner of a face from which the search has reached a pivot. If the function then
  /// returns true, the distance of the origin of `h` is no lower bound for a path that turns at this pivot.
  [[nodiscard]] bool is_unknown(mesh::HalfEdge h) const {
    return is_unknown(mesh::face(h)) || is_unknown(mesh::face(map_->mesh().twin(h)));
  }
  /// Returns whether a path of the guide that is shorter than the limit may lead through the vertex, whose position is
  /// `at`.
  [[nodiscard]] bool is_useful(mesh::Vertex v, const Point& at) const {
    const Length& known = lengths_[number(v)];
    return known.query == stamp_.value() && known.length + distance(start_, at) < limit_;
  }
  /// Returns a lower bound of the length of a path of the guide from the vertex, whose position is `at`, to the goal.
  [[nodiscard]] double least_length(mesh::Vertex v, const Point& at) const {
    const double least = limit_ - distance(start_, at);
    const Length& known = lengths_[number(v)];
    return known.query == stamp_.value() ? std::min(known.length, least) : least;
  }

 private:
  /// The length of the shortest path from the goal to a vertex that the guide has found. It is valid only in query
  /// number `query`.
  struct Length {
    double length;
    std::uint32_t query;
  };

  static constexpr std::uint32_t kFirstStampBit = 8;

  [[nodiscard]] static std::uint32_t bit_of(mesh::Face f, mesh::HalfEdge h) { return 1U << mesh::index_in(f, h); }
  [[nodiscard]] bool is_unknown(mesh::Face f) const {
    return map_->core != nullptr && !map_->core->is_core(f) && crossed_[number(f)] < stamp_.value();
  }
  /// Returns whether the guide has entered the face of `h` across its edge `h`.
  [[nodiscard]] bool is_entered(mesh::HalfEdge h) const {
    const mesh::Face f = mesh::face(h);
    const std::uint32_t crossed = crossed_[number(f)];
    return crossed >= stamp_.value() && (crossed & bit_of(f, h)) != 0;
  }

  const DiscMap* map_ = nullptr;
  Point start_;
  double limit_ = 0.0;
  DeadEnds dead_ends_;  ///< the guide searches from the disc's goal to its start, so the start is the goal here
  memory::ZeroedArray<Length> lengths_;  ///< by vertex
  /// By face: 0, or the number of the last query that entered the face, plus a bit for each half-edge across which the
  /// guide has entered it.
  memory::ZeroedArray<std::uint32_t> crossed_;
  memory::Stamp stamp_;
};

}  // namespace waywright::path
