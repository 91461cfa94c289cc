#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "waywright/point.hpp"

#include "base/ieee.hpp"
#include "world/lane_table.hpp"

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
/// An update tests thousands of ellipses, and their data is rarely in the cache. So the class first tests numbers of 16
/// bits: they say for almost all ellipses that the centre of the box lies in the ellipse, or that the box is beyond the
/// ellipse. Only the other ellipses need a test of doubles.
class EllipseBucket {
 public:
  using Value = EllipseOfPath;
  using Handle = std::uint32_t;

  explicit EllipseBucket(const Box& domain) : frame_(domain) {}

  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] Handle handle(std::size_t i) const { return entries_[i].handle; }

  /// Adds an ellipse with its bounding box. If memory runs out, nothing changes.
  void add(const Box& bounds, const EllipseOfPath& path, Handle handle) {
    numbers_.make_room();
    if (slots_.size() == slots_.capacity()) slots_.reserve(2 * slots_.size() + 4);
    entries_.push_back({bounds, path.ellipse, handle});
    slots_.push_back(path.slot);
    numbers_.add(row_of(path.ellipse));
  }
  /// Removes the entry `i`. The last entry takes its place.
  void remove(std::size_t i) {
    numbers_.remove(i);
    entries_[i] = entries_.back();
    entries_.pop_back();
    slots_[i] = slots_.back();
    slots_.pop_back();
  }

  /// Calls visit(slot) for each ellipse that the box meets, and for a few that the box misses. Requires: the caller of
  /// add() has multiplied the length of each ellipse by at least 1 + 2^-40. This factor covers the rounding errors of
  /// the test. The box lies in the domain.
  template <class Visit>
  void for_each_overlapping(const Box& box, const Visit& visit) const {
    const Box relative = frame_.relative(box);
    const Point middle = 0.5 * kUnits * (relative.min + relative.max);
    const auto x = static_cast<float>(middle.x);
    const auto y = static_cast<float>(middle.y);
    // Let p be a position of the box. The sum of the distances to the foci is less at p than at the centre of the box
    // by at most this number.
    const auto nearer = static_cast<float>(kUnits * (distance(relative.min, relative.max) + FloatFrame::kError));
    // The loop collects the bits of several blocks before it visits their lanes, because the processor rarely predicts
    // the end of a loop over the set bits.
    for (std::size_t first = 0; first < size(); first += kBits) {
      std::uint64_t inside = 0;
      std::uint64_t unsure = 0;
      const std::size_t count =
          std::min((size() - first + Numbers::kLanes - 1) / Numbers::kLanes, kBits / Numbers::kLanes);
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = first / Numbers::kLanes + i;
        const Numbers::Block& block = numbers_.block(at);
        Numbers::LaneSet outside = 0;
        Numbers::LaneSet beyond = 0;
        for (std::size_t lane = 0; lane < Numbers::kLanes; ++lane) {
          const auto value = [&](Field field) { return static_cast<float>(block[field][lane]); };
          const float sum =
              distance(value(kStartX) - x, value(kStartY) - y) + distance(value(kGoalX) - x, value(kGoalY) - y);
          outside |= Numbers::lane_if_negative(lane, value(kInside) - 1.0F - sum);
          beyond |= Numbers::lane_if_negative(lane, value(kBeyond) + nearer - sum);
        }
        const Numbers::LaneSet near = numbers_.used_lanes(at) & ~beyond;
        inside |= std::uint64_t{near & ~outside} << i * Numbers::kLanes;
        unsure |= std::uint64_t{near & outside} << i * Numbers::kLanes;
      }
      Numbers::for_each_lane(unsure, [&](std::size_t lane) {
        if (may_meet(entries_[first + lane], box)) inside |= std::uint64_t{1} << lane;
      });
      Numbers::for_each_lane(inside, [&](std::size_t lane) { visit(slots_[first + lane]); });
    }
  }

 private:
  /// The numbers of an ellipse: its foci, and two bounds of the sum of the distances from a position to the foci. If
  /// the sum is at most `kInside` - 1, the position is in the ellipse. If the sum is larger than `kBeyond`, the
  /// position is not in the ellipse. The unit of these lengths is the longer side of the domain divided by kUnits. So
  /// the sum of the distances from a position in the domain to two foci in the domain is less than kLargestNumber.
  enum Field : std::uint8_t { kStartX, kStartY, kGoalX, kGoalY, kInside, kBeyond, kFieldCount };
  using Numbers = LaneTable<std::uint16_t, kFieldCount>;

  struct Entry {
    Box bounds;
    Ellipse ellipse;
    Handle handle;
  };

  static float distance(float dx, float dy) { return std::sqrt(dx * dx + dy * dy); }
  static double distance(const Point& a, const Point& b) { return waywright::distance(a, b); }

  /// Returns the numbers of an ellipse. The rounding of a coordinate of a focus has an error of at most 1/2. So the
  /// error of a distance is at most the square root of 1/2, and the error of the sum is less than kSumError, with the
  /// errors of the floats.
  [[nodiscard]] Numbers::Row row_of(const Ellipse& ellipse) const {
    constexpr double kSumError = 1.5;
    const auto to_number = [](double v) { return static_cast<std::uint16_t>(std::clamp(v, 0.0, kLargestNumber)); };
    const auto is_in_domain = [](const Point& p) {
      return std::min(p.x, p.y) >= -FloatFrame::kError && std::max(p.x, p.y) <= 1.0 + FloatFrame::kError;
    };
    const Point start = frame_.relative(ellipse.start);
    const Point goal = frame_.relative(ellipse.goal);
    double inside = kUnits * frame_.relative(ellipse.length) - kSumError + 1.0;
    double beyond = kUnits * frame_.relative(ellipse.length + 3.0 * ellipse.reach) + kSumError;
    if (!is_in_domain(start) || !is_in_domain(goal)) {
      inside = 0.0;
      beyond = kLargestNumber;
    }
    const auto rounded = [&](double v) { return to_number(std::floor(kUnits * v + 0.5)); };
    return {rounded(start.x),
            rounded(start.y),
            rounded(goal.x),
            rounded(goal.y),
            to_number(std::floor(inside)),
            to_number(std::ceil(beyond))};
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
  static constexpr double kUnits = 0x1p14;
  static constexpr double kLargestNumber = 0xffff;

  FloatFrame frame_;
  Numbers numbers_;
  std::vector<std::uint32_t> slots_;  ///< of the paths
  std::vector<Entry> entries_;
};

}  // namespace waywright
