#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "waywright/point.hpp"

#include "base/ieee.hpp"
#include "world/float_table.hpp"

namespace waywright {

/// The positions from which the sum of the distances to two foci is at most `length`, and all positions that are at
/// most `reach` away from one of these positions.
struct Ellipse {
  Point start;
  Point goal;
  double length = std::numeric_limits<double>::infinity();
  double reach = 0.0;
};

/// An ellipse of a path.
struct EllipseOfPath {
  Ellipse ellipse;
  std::uint32_t slot;  ///< of the path
};

/// The entries of a node of BoxTree: ellipses of paths. for_each_overlapping() calls visit(slot) for each ellipse that
/// a box may meet.
///
/// An update tests thousands of ellipses, and their data is rarely in the cache. So the class first tests floats: they
/// say for almost all ellipses that the centre of the box lies in the ellipse, or that the box is beyond the ellipse.
/// Only the other ellipses need a test of doubles.
class EllipseBucket {
 public:
  using Value = EllipseOfPath;
  using Handle = std::uint32_t;

  explicit EllipseBucket(const Box& domain) : frame_(domain) {}

  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] Handle handle(std::size_t i) const { return entries_[i].handle; }

  /// Adds an ellipse with its bounding box. If memory runs out, nothing changes.
  void add(const Box& bounds, const EllipseOfPath& path, Handle handle) {
    floats_.make_room();
    if (slots_.size() == slots_.capacity()) slots_.reserve(2 * slots_.size() + 4);
    entries_.push_back({bounds, path.ellipse, handle});
    slots_.push_back(path.slot);
    floats_.add(row_of(path.ellipse));
  }
  /// Removes the entry `i`. The last entry takes its place.
  void remove(std::size_t i) {
    floats_.remove(i);
    entries_[i] = entries_.back();
    entries_.pop_back();
    slots_[i] = slots_.back();
    slots_.pop_back();
  }

  /// Calls visit(slot) for each ellipse that the box meets, and for a few that the box misses. Requires: the caller of
  /// add() has multiplied the length of each ellipse by at least 1 + 2^-40. This factor covers the rounding errors of
  /// the test.
  template <class Visit>
  void for_each_overlapping(const Box& box, const Visit& visit) const {
    const Box relative = frame_.relative(box);
    const Point middle = 0.5 * (relative.min + relative.max);
    const auto x = static_cast<float>(middle.x);
    const auto y = static_cast<float>(middle.y);
    // Let p be a position of the box. The sum of the distances to the foci is less at p than at the centre of the box
    // by at most this number.
    const auto nearer = static_cast<float>(distance(relative.min, relative.max) + FloatFrame::kError);
    // The loop collects the bits of several blocks before it visits their lanes, because the processor rarely predicts
    // the end of a loop over the set bits.
    for (std::size_t first = 0; first < size(); first += kBits) {
      std::uint64_t inside = 0;
      std::uint64_t unsure = 0;
      const std::size_t count =
          std::min((size() - first + Floats::kLanes - 1) / Floats::kLanes, kBits / Floats::kLanes);
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = first / Floats::kLanes + i;
        const Floats::Block& block = floats_.block(at);
        Floats::LaneSet outside = 0;
        Floats::LaneSet beyond = 0;
        for (std::size_t lane = 0; lane < Floats::kLanes; ++lane) {
          const float sum = distance(block[kStartX][lane] - x, block[kStartY][lane] - y) +
                            distance(block[kGoalX][lane] - x, block[kGoalY][lane] - y);
          outside |= Floats::lane_if_negative(lane, block[kInside][lane] - sum);
          beyond |= Floats::lane_if_negative(lane, block[kBeyond][lane] + nearer - sum);
        }
        const Floats::LaneSet near = floats_.used_lanes(at) & ~beyond;
        inside |= std::uint64_t{near & ~outside} << i * Floats::kLanes;
        unsure |= std::uint64_t{near & outside} << i * Floats::kLanes;
      }
      Floats::for_each_lane(unsure, [&](std::size_t lane) {
        if (may_meet(entries_[first + lane], box)) inside |= std::uint64_t{1} << lane;
      });
      Floats::for_each_lane(inside, [&](std::size_t lane) { visit(slots_[first + lane]); });
    }
  }

 private:
  /// The floats of an ellipse: its foci, and two bounds of the sum of the distances from a position to the foci. If the
  /// sum is at most `kInside`, the position is in the ellipse. If the sum is larger than `kBeyond`, the position is not
  /// in the ellipse.
  enum Field : std::uint8_t { kStartX, kStartY, kGoalX, kGoalY, kInside, kBeyond, kFieldCount };
  using Floats = FloatTable<kFieldCount>;

  struct Entry {
    Box bounds;
    Ellipse ellipse;
    Handle handle;
  };

  static float distance(float dx, float dy) { return std::sqrt(dx * dx + dy * dy); }
  static double distance(const Point& a, const Point& b) { return waywright::distance(a, b); }

  /// Returns the floats of an ellipse. The errors of the coordinates make the sum of the distances wrong by at most
  /// FloatFrame::kError, because a box lies in the domain.
  [[nodiscard]] Floats::Row row_of(const Ellipse& ellipse) const {
    const Point start = frame_.relative(ellipse.start);
    const Point goal = frame_.relative(ellipse.goal);
    const double length = frame_.relative(ellipse.length);
    const double reach = frame_.relative(ellipse.reach);
    double inside = length * (1.0 - FloatFrame::kError) - FloatFrame::kError;
    double beyond = length * (1.0 + FloatFrame::kError) + 3.0 * reach + FloatFrame::kError;
    if (FloatFrame::is_far(start) || FloatFrame::is_far(goal)) {
      inside = -kLarge;
      beyond = kLarge;
    }
    const auto to_float = [](double v) { return static_cast<float>(std::clamp(v, -kLarge, kLarge)); };
    return {to_float(start.x), to_float(start.y), to_float(goal.x),
            to_float(goal.y),  to_float(inside),  to_float(beyond)};
  }

  static double squared_distance(const Box& box, double reach, const Point& p) {
    const auto beyond = [&](double least, double most, double at) {
      return std::max(std::max(least - at, at - most) - reach, 0.0);
    };
    const double dx = beyond(box.min.x, box.max.x, p.x);
    const double dy = beyond(box.min.y, box.max.y, p.y);
    return dx * dx + dy * dy;
  }
  /// Returns whether the box, larger by the reach in each of the four directions, may contain a position of the
  /// ellipse. Let a and b be the distances of the larger box from the foci. Let the rest be length^2 - a^2 - b^2. Then
  /// a + b <= length if and only if the rest is not negative and the square of 2 a b is at most the square of the rest.
  /// The products of four coordinates neither overflow nor underflow.
  static bool may_meet(const Entry& entry, const Box& box) {
    const Ellipse& ellipse = entry.ellipse;
    const double a2 = squared_distance(box, ellipse.reach, ellipse.start);
    const double b2 = squared_distance(box, ellipse.reach, ellipse.goal);
    const double rest = ellipse.length * ellipse.length - a2 - b2;
    return rest * std::abs(rest) >= 4.0 * a2 * b2 && entry.bounds.overlaps(box);
  }

  static constexpr std::size_t kBits = 64;
  static constexpr double kLarge = 0x1p100;

  FloatFrame frame_;
  Floats floats_;
  std::vector<std::uint32_t> slots_;  ///< of the paths
  std::vector<Entry> entries_;
};

}  // namespace waywright
