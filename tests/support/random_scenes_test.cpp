#include "support/random_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/item.hpp"

#include "oracle/oracle.hpp"
#include "support/oracle_adapter.hpp"

namespace waywright::test {
namespace {

constexpr std::size_t kRandomScenes = 40;
constexpr std::size_t kItems = 60;

/// How often each kind of event occurs.
using Census = std::map<std::string, std::size_t>;

bool is_degenerate(const std::vector<Point>& ring) {
  return ring.size() > 1 && std::all_of(ring.begin(), ring.end(), [&](const Point& p) { return p == ring.front(); });
}

bool on_border(Point p, const Box& domain) {
  return p.x == domain.min.x || p.x == domain.max.x || p.y == domain.min.y || p.y == domain.max.y;
}

void count_items(const Scene& scene, Census& census) {
  std::vector<Shape> earlier;
  for (const Item& item : scene.items) {
    ++census[std::string(to_string(item.shape.kind))];
    if (item.shape.rings.size() > 1) ++census["several rings"];
    if (item.shape.kind == ItemKind::polygon) ++census[std::string(to_string(item.shape.fill))];
    if (item.id.value > scene.items.size()) ++census["sparse ids"];
    const bool again = std::find(earlier.begin(), earlier.end(), item.shape) != earlier.end();
    if (again && item.shape.kind != ItemKind::point) ++census["duplicates"];
    earlier.push_back(item.shape);
    for (const auto& ring : item.shape.rings) {
      if (is_degenerate(ring)) ++census["zero length"];
      if (ring.size() == 1 && item.shape.kind != ItemKind::point) ++census["rings of one point"];
      census["points on the border"] += static_cast<std::size_t>(
          std::count_if(ring.begin(), ring.end(), [&](const Point& p) { return on_border(p, scene.domain); }));
    }
  }
}

/// Counts what only the oracle can see. A corner inside another item's side divides a wall there.
void count_meetings(const Scene& scene, Census& census) {
  const oracle::Oracle oracle(oracle::to_oracle(scene));
  census["vertices"] += oracle.vertex_count();
  census["crossings"] += oracle.crossing_count();
  std::map<std::uint32_t, std::size_t> degrees;
  for (const oracle::OracleConstraint& constraint : oracle.expected().constraints) {
    if (constraint.ids.size() > 1) ++census["overlaps"];
    if (constraint.ids.size() > 1 && constraint.ids.front() == 0) ++census["sides on the border"];
    ++degrees[constraint.from];
    ++degrees[constraint.to];
  }
  for (const auto& [vertex, degree] : degrees) {
    if (degree == 3) ++census["ends on sides"];
    if (degree >= 6) ++census["bundles"];
  }
}

Census census_of(Flavour flavour) {
  Census census;
  for (std::uint64_t seed = 0; seed < kRandomScenes; ++seed) {
    const Scene scene = random_scene(flavour, seed, kItems);
    count_items(scene, census);
    count_meetings(scene, census);
  }
  return census;
}

class RandomScenes : public ::testing::TestWithParam<Flavour> {};

TEST_P(RandomScenes, HaveAllKindsOfThings) {
  Census census = census_of(GetParam());
  for (const char* thing : {"point", "segment", "polyline", "polygon", "even-odd", "nonzero", "several rings",
                            "sparse ids", "duplicates", "zero length", "rings of one point", "points on the border",
                            "overlaps", "sides on the border", "ends on sides", "bundles"}) {
    EXPECT_GE(census[thing], kRandomScenes / 2) << thing;
  }
  EXPECT_GE(census["crossings"], 10 * kRandomScenes);
  EXPECT_LE(census["vertices"], 1000 * kRandomScenes);  // otherwise the long runs would take too long
}

TEST_P(RandomScenes, AreWhatAWorldTakes) {
  const auto legal = [](double value) {
    return value == 0.0 || (std::fabs(value) >= 0x1p-100 && std::fabs(value) <= 0x1p100);
  };
  for (std::uint64_t seed = 0; seed < kRandomScenes; ++seed) {
    const Scene scene = random_scene(GetParam(), seed, kItems);
    const Box& box = scene.domain;
    ASSERT_LT(box.min.x, box.max.x);
    ASSERT_LT(box.min.y, box.max.y);
    for (const double value : {box.min.x, box.min.y, box.max.x, box.max.y}) ASSERT_TRUE(legal(value)) << value;
    ASSERT_EQ(scene.items.size(), kItems);
    std::set<ItemId> ids;
    for (const Item& item : scene.items) {
      ASSERT_TRUE(item.id.value >= 1 && item.id.value <= ItemId::kLargest && ids.insert(item.id).second);
      ASSERT_FALSE(item.shape.rings.empty());
      for (const auto& ring : item.shape.rings) {
        ASSERT_FALSE(ring.empty());
        for (const Point& p : ring) {
          ASSERT_TRUE(legal(p.x) && legal(p.y)) << p.x << ' ' << p.y;
          ASSERT_TRUE(p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y);
        }
      }
    }
  }
}

TEST_P(RandomScenes, FollowFromTheirSeed) {
  const Scene scene = random_scene(GetParam(), 7, kItems);
  const Scene again = random_scene(GetParam(), 7, kItems);
  EXPECT_EQ(scene.domain, again.domain);
  EXPECT_EQ(scene.items, again.items);
  EXPECT_NE(scene.items, random_scene(GetParam(), 8, kItems).items);
}

TEST_P(RandomScenes, HaveTightAndWideDomains) {
  std::size_t tight = 0;
  for (std::uint64_t seed = 0; seed < kRandomScenes; ++seed) {
    const Scene scene = random_scene(GetParam(), seed, 6);
    std::set<double> xs;
    for (const Item& item : scene.items) {
      for (const auto& ring : item.shape.rings) {
        for (const Point& p : ring) xs.insert(p.x);
      }
    }
    if (*xs.begin() == scene.domain.min.x && *xs.rbegin() == scene.domain.max.x) ++tight;
  }
  EXPECT_GE(tight, kRandomScenes / 10);
  EXPECT_LE(tight, kRandomScenes - kRandomScenes / 10);
}

INSTANTIATE_TEST_SUITE_P(Flavours, RandomScenes, ::testing::ValuesIn(kFlavours),
                         [](const auto& flavour) { return std::string(to_string(flavour.param)); });

// Near-misses are numbers that differ by less than 2^-48 of their size.
TEST(RandomScenesMixed, HaveNearMissesAndManySizes) {
  std::size_t near_misses = 0;
  std::set<int> exponents;
  for (std::uint64_t seed = 0; seed < kRandomScenes; ++seed) {
    std::set<double> xs;
    for (const Item& item : random_scene(Flavour::mixed, seed, kItems).items) {
      for (const auto& ring : item.shape.rings) {
        for (const Point& p : ring) xs.insert(p.x);
      }
    }
    for (auto x = xs.begin(); std::next(x) != xs.end(); ++x) {
      if (*std::next(x) - *x < 0x1p-48 * std::fabs(*x)) ++near_misses;
      if (*x != 0.0) exponents.insert(std::ilogb(*x));
    }
  }
  EXPECT_GE(near_misses, 2 * kRandomScenes);
  EXPECT_GE(exponents.size(), 180U);
}

}  // namespace
}  // namespace waywright::test
