#include <deque>
#include <vector>

#include <gtest/gtest.h>

#include "exact/crossing.hpp"
#include "exact/predicates.hpp"
#include "memory/allocations.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

// Integers and decimals, explicit points and crossings: the predicates answer every question without the heap.
TEST(PredicateAllocations, OnALatticeThereAreNone) {
  for (const double unit : {1.0, 0.1, 0x1p-40}) {
    Random random(1);
    const auto coordinate = [&] { return static_cast<double>(random.between(-20, 20)) * unit; };
    std::deque<exact::Crossing> crossings;
    std::vector<exact::ExactPosition> points;
    while (points.size() < 60) {
      points.push_back({coordinate(), coordinate()});
      const exact::Crossing crossing{
          {coordinate(), -30 * unit}, {coordinate(), 30 * unit}, {-30 * unit, coordinate()}, {30 * unit, coordinate()}};
      const exact::RoundedCrossing rounded = exact::round_to_nearest(crossing);
      crossings.push_back(crossing);
      points.push_back({rounded.nearest.x, rounded.nearest.y, rounded.is_exact ? nullptr : &crossings.back()});
    }
    const std::size_t before = allocation_count();
    int sum = 0;
    for (int i = 0; i < 20000; ++i) {
      const exact::ExactPosition &a = points[random.below(60)], &b = points[random.below(60)];
      const exact::ExactPosition &c = points[random.below(60)], &d = points[random.below(60)];
      sum += static_cast<int>(exact::orientation(a, b, c)) + static_cast<int>(exact::in_circle(a, b, c, d));
      sum += static_cast<int>(exact::lattice::orientation(a, b, c).value()) - (exact::compare(a, b) < 0 ? 1 : 0);
      sum += static_cast<int>(exact::lattice::in_circle(a, b, c, d).value());
      sum += exact::round_to_nearest(crossings[random.below(crossings.size())]).is_exact ? 1 : 0;
    }
    EXPECT_EQ(allocation_count(), before) << "unit " << unit << ", sum " << sum;
  }
}

}  // namespace
}  // namespace waywright::test
