#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "waywright/scene.hpp"

#include "support/data_folder.hpp"

namespace waywright {
namespace {

using Rows = std::vector<std::string>;
using Ring = std::vector<Point>;
using TileRings = std::vector<Ring>;

std::string map_text(const Rows& rows) {
  std::string text = "type octile\nheight " + std::to_string(rows.size()) + "\nwidth " +
                     std::to_string(rows.front().size()) + "\nmap\n";
  for (const std::string& row : rows) text += row + "\n";
  return text;
}

Scene parsed_map(const Rows& rows) {
  const Result<Scene> scene = parse_movingai_map(map_text(rows), "test.map");
  EXPECT_TRUE(scene.ok()) << scene.error().message();
  return scene.ok() ? *scene : Scene{};
}

/// Returns the rings of each polygon.
std::vector<TileRings> rings_of(const Rows& rows) {
  std::vector<TileRings> all;
  for (const Item& item : parsed_map(rows).items) all.push_back(item.shape.rings);
  return all;
}

TEST(ParseMovingaiMap, SetsTheDomainAndTheAxis) {
  const Scene scene = parsed_map({".....", "....."});
  EXPECT_EQ(scene.domain, (Box{{0, 0}, {5, 2}}));
  EXPECT_TRUE(scene.y_down);
  EXPECT_TRUE(scene.items.empty());
}

TEST(ParseMovingaiMap, DistinguishesFreeCellsFromBlockedOnes) {
  const Scene scene = parsed_map({".GS.@.O.T.W"});
  ASSERT_EQ(scene.items.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const double x = 4.0 + 2.0 * static_cast<double>(i);
    EXPECT_EQ(scene.items[i], (Item{{i + 1}, {ItemKind::polygon, {{{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}}}}}));
  }
}

TEST(ParseMovingaiMap, TakesCarriageReturnsBlankEndsAndNoLastLineEnd) {
  const Scene expected = parsed_map({"@."});
  for (const std::string_view text :
       {"type octile\r\nheight 1\r\nwidth 2\r\nmap\r\n@.\r\n", "type octile\nheight 1\nwidth 2\nmap\n@.",
        "type  octile \nheight\t1\nwidth 2\nmap\n@.\n\n \n"}) {
    const Result<Scene> scene = parse_movingai_map(text, "test.map");
    ASSERT_TRUE(scene.ok()) << scene.error().message();
    EXPECT_EQ(*scene, expected);
  }
}

TEST(ParseMovingaiMap, JoinsBlockedCellsOfAllLettersIntoOnePolygonOfTrueCorners) {
  EXPECT_EQ(rings_of({"@T.",  //
                      ".O.",  //
                      ".WW"}),
            (std::vector<TileRings>{{{{0, 0}, {2, 0}, {2, 2}, {3, 2}, {3, 3}, {1, 3}, {1, 1}, {0, 1}}}}));
}

TEST(ParseMovingaiMap, TracesHolesAndWhatLiesInThem) {
  EXPECT_EQ(rings_of({"@@@@@",  //
                      "@...@",  //
                      "@.@.@",  //
                      "@...@",  //
                      "@@@@@"}),
            (std::vector<TileRings>{{{{0, 0}, {5, 0}, {5, 5}, {0, 5}}, {{1, 4}, {4, 4}, {4, 1}, {1, 1}}},
                                    {{{2, 2}, {3, 2}, {3, 3}, {2, 3}}}}));
}

TEST(ParseMovingaiMap, KeepsGroupsThatTouchDiagonallyApart) {
  EXPECT_EQ(rings_of({"@.",  //
                      ".@"}),
            (std::vector<TileRings>{{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, {{{1, 1}, {2, 1}, {2, 2}, {1, 2}}}}));
  EXPECT_EQ(rings_of({".@",  //
                      "@."}),
            (std::vector<TileRings>{{{{1, 0}, {2, 0}, {2, 1}, {1, 1}}}, {{{0, 1}, {1, 1}, {1, 2}, {0, 2}}}}));
}

TEST(ParseMovingaiMap, PartsTheRingsWhereAGroupTouchesItself) {
  EXPECT_EQ(
      rings_of({"@@@",  //
                "@.@",  //
                "@@."}),
      (std::vector<TileRings>{{{{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 3}, {0, 3}}, {{1, 2}, {2, 2}, {2, 1}, {1, 1}}}}));
  EXPECT_EQ(
      rings_of({"@@@@",  //
                "@.@@",  //
                "@@.@",  //
                "@@@@"}),
      (std::vector<TileRings>{
          {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 2}, {2, 2}, {2, 1}, {1, 1}}, {{2, 3}, {3, 3}, {3, 2}, {2, 2}}}}));
}

bool is_blocked(char tile) { return std::string_view(".GS").find(tile) == std::string_view::npos; }

/// Returns which tiles' centres have an odd winding number. Each vertical side changes the parity
/// of all centres to its right.
std::vector<std::vector<bool>> covered_tiles(const TileRings& rings, std::size_t height, std::size_t width) {
  std::vector<std::vector<bool>> covered(height, std::vector<bool>(width + 1));
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i];
      const Point b = ring[(i + 1) % ring.size()];
      if (a.x != b.x) continue;
      const auto x = static_cast<std::size_t>(a.x);
      const auto low = static_cast<std::size_t>(std::min(a.y, b.y));
      const auto high = static_cast<std::size_t>(std::max(a.y, b.y));
      for (std::size_t y = low; y < high; ++y) covered[y][x] = !covered[y][x];
    }
  }
  for (std::vector<bool>& row : covered) {
    for (std::size_t x = 1; x < row.size(); ++x) row[x] = row[x] != row[x - 1];
  }
  return covered;
}

double signed_area(const Ring& ring) {
  double doubled = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[(i + 1) % ring.size()];
    doubled += a.x * b.y - b.x * a.y;
  }
  return doubled / 2.0;
}

/// Returns whether each corner connects a horizontal and a vertical side, and no side has length 0.
bool has_true_corners_alone(const Ring& ring) {
  if (ring.size() < 4) return false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[(i + 1) % ring.size()];
    const Point c = ring[(i + 2) % ring.size()];
    const bool across_then_along = a.y == b.y && a.x != b.x && b.x == c.x && b.y != c.y;
    const bool along_then_across = a.x == b.x && a.y != b.y && b.y == c.y && b.x != c.x;
    if (!across_then_along && !along_then_across) return false;
  }
  return true;
}

/// Returns whether the ring visits no lattice point twice.
bool is_simple(const Ring& ring) {
  std::set<std::pair<double, double>> passed;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point end = ring[(i + 1) % ring.size()];
    for (Point p = ring[i]; p != end;) {
      if (!passed.emplace(p.x, p.y).second) return false;
      p.x += end.x > p.x ? 1.0 : end.x < p.x ? -1.0 : 0.0;
      p.y += end.y > p.y ? 1.0 : end.y < p.y ? -1.0 : 0.0;
    }
  }
  return true;
}

/// Returns what is wrong with all polygons of a map together, or an empty text if nothing is.
std::string fault_of(const Scene& scene, const Rows& rows) {
  TileRings all;
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    const Item& item = scene.items[i];
    if (item.id.value != i + 1) return "ids do not count from 1";
    if (item.shape.kind != ItemKind::polygon || item.shape.rings.empty()) return "an item is no polygon";
    for (std::size_t r = 0; r < item.shape.rings.size(); ++r) {
      const Ring& ring = item.shape.rings[r];
      if (!has_true_corners_alone(ring)) return "a point of a ring is no corner";
      if (!is_simple(ring)) return "a ring is not simple";
      if ((signed_area(ring) > 0.0) != (r == 0))
        return "an outer ring is clockwise, or the ring of a hole is counter-clockwise";
      all.push_back(ring);
    }
  }
  const auto covered = covered_tiles(all, rows.size(), rows.front().size());
  for (std::size_t y = 0; y < rows.size(); ++y) {
    for (std::size_t x = 0; x < rows[y].size(); ++x) {
      if (covered[y][x] != is_blocked(rows[y][x])) {
        return "tile " + std::to_string(x) + "," + std::to_string(y) +
               " is blocked outside of the rings, or free inside";
      }
    }
  }
  return {};
}

/// Returns which polygon covers each tile, counted from 1, or 0 where none does. At most one polygon may cover a tile.
std::vector<std::vector<std::size_t>> owners(const Scene& scene, const Rows& rows) {
  std::vector<std::vector<std::size_t>> owner(rows.size(), std::vector<std::size_t>(rows.front().size()));
  for (const Item& item : scene.items) {
    const auto covered = covered_tiles(item.shape.rings, rows.size(), rows.front().size());
    for (std::size_t y = 0; y < rows.size(); ++y) {
      for (std::size_t x = 0; x < rows[y].size(); ++x) {
        if (!covered[y][x]) continue;
        EXPECT_EQ(owner[y][x], 0U) << "two polygons cover tile " << x << "," << y;
        owner[y][x] = item.id.value;
      }
    }
  }
  return owner;
}

/// Returns the groups of blocked tiles, numbered from 1 in scan order. Replaces each number by the smallest number of
/// its neighbours until nothing changes.
std::vector<std::vector<std::size_t>> groups_of(const Rows& rows) {
  const std::size_t width = rows.front().size();
  std::vector<std::vector<std::size_t>> group(rows.size(), std::vector<std::size_t>(width));
  for (std::size_t y = 0; y < rows.size(); ++y) {
    for (std::size_t x = 0; x < width; ++x) group[y][x] = is_blocked(rows[y][x]) ? y * width + x + 1 : 0;
  }
  bool changed = true;
  const auto settle = [&](std::size_t& a, std::size_t& b) {
    if (a == 0 || b == 0 || a == b) return;
    a = b = std::min(a, b);
    changed = true;
  };
  while (changed) {
    changed = false;
    for (std::size_t y = 0; y < rows.size(); ++y) {
      for (std::size_t x = 0; x < width; ++x) {
        if (x > 0) settle(group[y][x], group[y][x - 1]);
        if (y > 0) settle(group[y][x], group[y - 1][x]);
      }
    }
  }
  std::set<std::size_t> seen;
  for (const auto& row : group) seen.insert(row.begin(), row.end());
  seen.insert(0);
  for (auto& row : group) {
    for (std::size_t& g : row) g = static_cast<std::size_t>(std::distance(seen.begin(), seen.find(g)));
  }
  return group;
}

RC_GTEST_PROP(ParseMovingaiMap, CoversTheBlockedCellsOfEachGroupByOnePolygon, ()) {
  const auto width = *rc::gen::inRange<std::size_t>(1, 14);
  const auto height = *rc::gen::inRange<std::size_t>(1, 14);
  const auto blocked_weight = *rc::gen::inRange<std::size_t>(1, 10);
  const auto tile = rc::gen::weightedOneOf<char>(
      {{10 - blocked_weight, rc::gen::element('.', 'G', 'S')}, {blocked_weight, rc::gen::element('@', 'O', 'T', 'W')}});
  const auto rows = *rc::gen::container<Rows>(height, rc::gen::container<std::string>(width, tile));
  const Result<Scene> scene = parse_movingai_map(map_text(rows), "random.map");
  RC_ASSERT(scene.ok());
  RC_ASSERT(fault_of(*scene, rows) == "");
  RC_ASSERT(owners(*scene, rows) == groups_of(rows));
}

TEST(ParseMovingaiMap, CoversTheBlockedCellsOfTheRealMaps) {
  const std::filesystem::path folder = test::data_folder() / "grid";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "no maps in " << folder << "; set WAYWRIGHT_DATA";
  std::size_t maps = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".map") continue;
    ++maps;
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    std::istringstream lines(text);
    Rows rows;
    std::string line;
    for (int header = 0; header < 4; ++header) std::getline(lines, line);
    while (std::getline(lines, line)) rows.push_back(line);
    const Result<Scene> scene = parse_movingai_map(text, entry.path().string());
    ASSERT_TRUE(scene.ok()) << scene.error().message();
    EXPECT_EQ(fault_of(*scene, rows), "") << entry.path();
  }
  EXPECT_GT(maps, 0U);
}

}  // namespace
}  // namespace waywright
