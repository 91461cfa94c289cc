#include <gtest/gtest.h>

#include "waywright/predicate_counts.hpp"

#include "exact/crossing.hpp"
#include "exact/geometry.hpp"
#include "exact/predicates.hpp"
#include "exact/stage_agreement.hpp"
#include "support/case_count.hpp"

namespace waywright::test {
namespace {

using exact::Crossing;
using exact::ExactPosition;

/// Returns how many decisions of each stage `call` adds to the counts of one question.
template <class Call>
StageCounts added(StageCounts PredicateCounts::*question, Call&& call) {
  const StageCounts before = predicate_counts().*question;
  call();
  const StageCounts after = predicate_counts().*question;
  return {after.doubles - before.doubles, after.lattice - before.lattice, after.integers - before.integers};
}

constexpr StageCounts kDoubles{1, 0, 0};
constexpr StageCounts kLattice{0, 1, 0};
constexpr StageCounts kIntegers{0, 0, 1};

// The lines y = x / 3 and y = 2 - 2 x / 7 meet at (42/13, 14/13).
const Crossing kPlain{{0, 0}, {9, 3}, {0, 2}, {7, 0}};
// As `kPlain`, but one end does not lie on a common lattice with the others within 2^62.
const Crossing kFine{{0x1p-60, 0}, {9, 3}, {0, 2}, {7, 0}};

ExactPosition at(const Crossing& crossing) {
  const Point nearest = exact::integers::round_to_nearest(crossing).nearest;
  return {nearest.x, nearest.y, &crossing};
}

TEST(Stages, OfOrientations) {
  const auto asks = [](const ExactPosition& a, const ExactPosition& b, const ExactPosition& c) {
    return added(&PredicateCounts::orientation, [&] { static_cast<void>(exact::orientation(a, b, c)); });
  };
  EXPECT_EQ(asks({0, 0}, {4, 0}, {0, 4}), kDoubles);
  EXPECT_EQ(asks({0, 0}, {4, 0}, {9, 0}), kDoubles);  // on an axis: nothing is rounded
  EXPECT_EQ(asks({0, 0}, {4, 4}, {9, 9}), kLattice);
  EXPECT_EQ(asks({0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}), kLattice);
  EXPECT_EQ(asks({0, 0}, {0x1p-60, 0x1p-60}, {9, 9}), kIntegers);
  EXPECT_EQ(asks({0, 0}, {9, 3}, at(kPlain)), kLattice);
  EXPECT_EQ(asks({0, 0}, {9, 4}, at(kPlain)), kDoubles);
  EXPECT_EQ(asks({0x1p-60, 0}, {9, 3}, at(kFine)), kIntegers);
}

TEST(Stages, OfInCircles) {
  const auto asks = [](const ExactPosition& a, const ExactPosition& b, const ExactPosition& c, const ExactPosition& d) {
    return added(&PredicateCounts::in_circle, [&] { static_cast<void>(exact::in_circle(a, b, c, d)); });
  };
  EXPECT_EQ(asks({0, 0}, {4, 0}, {0, 4}, {1, 1}), kDoubles);
  EXPECT_EQ(asks({2, 0}, {4, 2}, {2, 4}, {0, 2}), kLattice);
  EXPECT_EQ(asks({0.2, 0.1}, {0.3, 0.1}, {0.4, 0.2}, {0.1, 0.2}), kLattice);
  EXPECT_EQ(asks({0x1p-60, 0}, {3 - 0x1p-60, 0}, {4, 4}, {-1, 4}), kIntegers);
  EXPECT_EQ(asks({0, 0}, {9, 3}, {9, 9}, at(kPlain)), kDoubles);
}

TEST(Stages, OfInCirclesAboutRectangles) {
  const exact::Geometry geometry(Box{{0, 0}, {4, 4}});
  const auto asks = [&](const Point& a, const Point& b, const Point& c, const Point& d) {
    const auto view = [&](const Point& point) { return geometry.view(point); };
    return added(&PredicateCounts::in_circle,
                 [&] { static_cast<void>(geometry.in_circle(view(a), view(b), view(c), view(d))); });
  };
  EXPECT_EQ(asks({0, 0}, {4, 0}, {4, 4}, {0, 4}), kDoubles);
  EXPECT_EQ(asks({0.1, 0.4}, {0.4, 0.1}, {0.4, 0.4}, {0.1, 0.1}), kDoubles);
  EXPECT_EQ(asks({2, 0}, {4, 2}, {2, 4}, {0, 2}), kLattice);
}

TEST(Stages, OfOrders) {
  const auto asks = [](const ExactPosition& p, const ExactPosition& q) {
    return added(&PredicateCounts::order, [&] { static_cast<void>(exact::compare(p, q)); });
  };
  const ExactPosition p = at(kPlain);
  EXPECT_EQ(asks({0, 0}, {0, 4}), kDoubles);
  EXPECT_EQ(asks({1, 0}, p), kDoubles);
  EXPECT_EQ(asks({p.x, 0}, p), kLattice);  // the nearest doubles agree, so the exact order of x is open
  EXPECT_EQ(asks(p, p), kLattice);
  EXPECT_EQ(asks(at(kFine), at(kFine)), kIntegers);
}

TEST(Stages, OfCrossings) {
  const auto asks = [](const Crossing& crossing) {
    return added(&PredicateCounts::crossing, [&] { static_cast<void>(exact::round_to_nearest(crossing)); });
  };
  EXPECT_EQ(asks({{0.1, 0}, {0.1, 3}, {0, 0x1p-60}, {7, 0x1p-60}}), kDoubles);
  EXPECT_EQ(asks({{0, 0.3}, {1, 0.3}, {0.7, 0}, {0.7, 1}}), kDoubles);
  EXPECT_EQ(asks(kPlain), kDoubles);  // whole numbers; only the quotient is rounded
  EXPECT_EQ(asks({{0, 0}, {9, 3.5}, {0, 2}, {7, 0}}), kLattice);
  EXPECT_EQ(asks({{0, 0}, {0x1p27, 3}, {0, 0x1p27}, {7, -0x1p27}}), kLattice);  // products beyond 2^53
  EXPECT_EQ(asks(kFine), kIntegers);
}

// Runs a small sample of the comparisons that `waywright_soak --predicates` makes by the hundred million.
TEST(Stages, AgreeWithEachOther) {
  const std::uint64_t calls = case_count<std::uint64_t>(20000);
  for (const NearMiss kind : kNearMisses) {
    const Agreement agreement = compare_stages(kind, 7, calls, 20);
    EXPECT_EQ(agreement.fault, "") << to_string(kind);
    EXPECT_EQ(agreement.calls, calls);
    // The draws are near zero so that later stages must decide: for most kinds the first stage leaves many calls to
    // them.
    EXPECT_LT(agreement.doubles, agreement.calls) << to_string(kind);
    EXPECT_GT(agreement.against_integers, 0U);
  }
}

}  // namespace
}  // namespace waywright::test
