#include "exact/sweep.hpp"

#include <compare>
#include <optional>
#include <utility>

#include <gtest/gtest.h>

#include "exact/gap_checks.hpp"
#include "support/disc_sweep_oracle.hpp"

namespace waywright::test {
namespace {

using exact::Sweep;
using exact::Touch;

disc::Motion motion_of(const Sweep& sweep) { return {sweep.from, sweep.to, sweep.radius}; }

/// Random sweeps and pairs of walls. The oracle says when the disc first touches each wall.
class Sweeps : public Gaps {
 protected:
  std::pair<Point, Point> wall() {
    for (;;) {
      const std::pair<Point, Point> result{point(), point()};
      if (!(result.first == result.second)) return result;
    }
  }
  Sweep sweep(const std::pair<Point, Point>& wall) {
    Sweep result{point(), point(), 0.0};
    const Point& end = source_.random().chance(50) ? result.from : result.to;
    const double near = waywright::distance(end, wall.first);
    while (result.radius == 0.0) result.radius = source_.radius(source_.random().chance(50) ? near : near / 4);
    if (source_.random().chance(20)) result.radius = near;
    return result.radius == 0.0 ? sweep(wall) : result;
  }
  /// Checks all stages, and returns the touch.
  std::optional<Touch> check_touch(const Sweep& sweep, const std::pair<Point, Point>& wall, bool is_touched) {
    const std::optional<Touch> touch = exact::first_touch(sweep, wall.first, wall.second);
    EXPECT_EQ(touch.has_value(), is_touched);
    EXPECT_EQ(exact::first_touch(sweep, wall.second, wall.first).has_value(), is_touched);
    EXPECT_TRUE(exact::stages::first_touch_in_integers(sweep, wall.first, wall.second) == touch);
    const auto in_doubles = exact::stages::first_touch_in_doubles(sweep, wall.first, wall.second);
    if (in_doubles.is_sure) {
      EXPECT_TRUE(in_doubles.touch == touch);
      ++sure_;
    }
    return touch;
  }
  int sure_ = 0;
};
INSTANTIATE_TEST_SUITE_P(Kinds, Sweeps, testing::ValuesIn(kKinds), kind_of_test);

TEST_P(Sweeps, AgreeWithTheOracle) {
  int touches = 0;
  int later = 0;
  for (int i = 0; i < kCalls && !HasFailure(); ++i) {
    const auto first = wall();
    const auto second = wall();
    const Sweep sweep = this->sweep(first);
    SCOPED_TRACE(testing::Message() << std::hexfloat << "from (" << sweep.from.x << ", " << sweep.from.y << ") to ("
                                    << sweep.to.x << ", " << sweep.to.y << ") radius " << sweep.radius << " wall ("
                                    << first.first.x << ", " << first.first.y << ") (" << first.second.x << ", "
                                    << first.second.y << ") other (" << second.first.x << ", " << second.first.y
                                    << ") (" << second.second.x << ", " << second.second.y << ")");
    const auto moment = disc::first_moment(motion_of(sweep), first);
    const auto other_moment = disc::first_moment(motion_of(sweep), second);
    const auto touch = check_touch(sweep, first, moment.has_value());
    const auto other = check_touch(sweep, second, other_moment.has_value());
    if (HasFailure() || !touch) continue;
    ++touches;
    later += touch->kind != Touch::Kind::start ? 1 : 0;
    EXPECT_EQ(touch->kind == Touch::Kind::start, moment->whole == 0 && moment->square == 0);
    if (!other) continue;
    const std::strong_ordering expected = disc::compare(*moment, *other_moment) <=> 0;
    EXPECT_EQ(exact::compare_touches(sweep, *touch, *other), expected);
    EXPECT_EQ(exact::compare_touches(sweep, *other, *touch), 0 <=> expected);
    EXPECT_EQ(exact::order_of(exact::stages::compare_touches_in_integers(sweep, *touch, *other)), expected);
    const auto in_doubles = exact::stages::compare_touches_in_doubles(sweep, *touch, *other);
    if (in_doubles) {
      EXPECT_EQ(exact::order_of(*in_doubles), expected);
    }
  }
  EXPECT_GT(touches, kCalls / 4);
  EXPECT_GT(later, kCalls / 40);
  EXPECT_GT(sure_, kCalls / 2);
  RecordProperty("sure", sure_);
}

// The disc passes the ends (x, y) and (-x, y) of walls at its radius, and touches walls at a distance of 5.
TEST(Sweep, DecidesConstructedTies) {
  for (const Frame& frame : kFrames) {
    for (const auto& [x, y, r] : kTriples) {
      SCOPED_TRACE(testing::Message() << frame.scale << ": " << x << ", " << y);
      if (x == 0) continue;
      // The centre is at the middle when it touches both ends of walls, which lie ahead or beside it.
      const Point along{std::abs(y) * 3, 0};
      const Sweep sweep{frame.at(0, -4 * r), frame.at(0, 0), frame.scale * r};
      const Point left = frame.at(-std::abs(x), std::abs(y));
      const Point right = frame.at(std::abs(x), std::abs(y));
      const auto first = exact::first_touch(sweep, left, frame.at(-std::abs(x) - along.x, std::abs(y) + 1));
      const auto second = exact::first_touch(sweep, right, frame.at(std::abs(x), std::abs(y) + 8));
      ASSERT_TRUE(first && second);
      EXPECT_EQ(first->kind, Touch::Kind::vertex);
      EXPECT_EQ(exact::compare_touches(sweep, *first, *second), std::strong_ordering::equal);
      const Sweep smaller{sweep.from, sweep.to, below(sweep.radius)};
      EXPECT_FALSE(exact::first_touch(smaller, left, frame.at(-std::abs(x) - along.x, std::abs(y) + 1)));
      // A wall straight ahead, touched at the same time.
      const auto line = exact::first_touch(sweep, frame.at(-1, r), frame.at(1, r));
      ASSERT_TRUE(line);
      EXPECT_EQ(line->kind, Touch::Kind::line);
      EXPECT_EQ(exact::compare_touches(sweep, *first, *line), std::strong_ordering::equal);
      EXPECT_EQ(exact::centre_at(sweep, *line), sweep.to);
      EXPECT_EQ(exact::centre_at(sweep, *first), sweep.to);
    }
  }
}

}  // namespace
}  // namespace waywright::test
