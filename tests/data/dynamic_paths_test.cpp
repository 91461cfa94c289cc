#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/scene.hpp"
#include "waywright/world.hpp"

#include "support/data_folder.hpp"
#include "support/point_text.hpp"

namespace waywright::test {
namespace {

using Rows = std::vector<std::string>;
using Microseconds = std::chrono::duration<double, std::micro>;

/// Reads the patches of a `.patch` file of the grid-based path planning competition. Each patch is a list of rows.
std::vector<Rows> read_patches(const std::filesystem::path& file) {
  std::vector<Rows> patches;
  std::ifstream in(file);
  std::size_t height = 0;
  for (std::string word; in >> word;) {
    if (word == "height") in >> height;
    if (word != "map") continue;
    Rows& rows = patches.emplace_back(height);
    for (std::string& row : rows) in >> row;
  }
  return patches;
}

std::string key_of(const Shape& shape) {
  std::string key;
  for (const auto& ring : shape.rings) {
    for (const Point& p : ring) key += text_of(p) + ',';
    key += '/';
  }
  return key;
}

/// A grid of tiles, and a world that holds the outlines of the blocked tiles.
class GridWorld {
 public:
  GridWorld(std::size_t width, std::size_t height)
      : rows_(height, std::string(width, '.')),
        world_(World::create({{0, 0}, {static_cast<double>(width), static_cast<double>(height)}}).value()) {}

  /// Copies a patch's tiles into the grid and applies all changes of outlines to the world in one operation. Returns
  /// the time that the world took.
  Microseconds apply(const Rows& patch, std::size_t x, std::size_t y) {
    for (std::size_t row = 0; row < patch.size(); ++row) rows_.at(y + row).replace(x, patch[row].size(), patch[row]);
    std::map<std::string, ItemId> now;
    std::vector<Change> changes;
    for (Item& item : parse_movingai_map(map_text(), "patched").value().items) {
      const std::string key = key_of(item.shape);
      const auto known = outlines_.find(key);
      if (known == outlines_.end()) {
        changes.push_back({Change::Kind::insert, {next_id_}, std::move(item.shape)});
        now[key] = {next_id_++};
      } else {
        now.insert(outlines_.extract(known));
      }
    }
    std::vector<Change> all;
    for (const auto& [key, id] : outlines_) all.push_back({Change::Kind::remove, id, {}});
    all.insert(all.end(), changes.begin(), changes.end());
    outlines_ = std::move(now);
    change_count_ += all.size();
    const auto start = std::chrono::steady_clock::now();
    world_.apply(all).value();
    return std::chrono::steady_clock::now() - start;
  }

  [[nodiscard]] const World& world() const { return world_; }
  [[nodiscard]] std::size_t outline_count() const { return outlines_.size(); }
  [[nodiscard]] std::size_t change_count() const { return change_count_; }

 private:
  [[nodiscard]] std::string map_text() const {
    std::string text = "type octile\nheight " + std::to_string(rows_.size()) + "\nwidth " +
                       std::to_string(rows_.front().size()) + "\nmap\n";
    for (const std::string& row : rows_) text += row + '\n';
    return text;
  }

  Rows rows_;
  World world_;
  std::map<std::string, ItemId> outlines_;
  std::uint64_t next_id_ = 1;
  std::size_t change_count_ = 0;
};

void print_times(const char* what, std::vector<Microseconds> times) {
  std::sort(times.begin(), times.end());
  Microseconds sum{0};
  for (const Microseconds& time : times) sum += time;
  std::cout << what << ": " << times.size() << ", µs: median " << times[times.size() / 2].count() << ", mean "
            << sum.count() / static_cast<double>(times.size()) << ", max " << times.back().count() << '\n';
}

/// Searches a path between the middles of two tiles with each algorithm. The path by `optimal` must not be longer than
/// the grid path of length `grid_length`, nor longer than the path by `ta`. Returns the time of the search by
/// `optimal`.
Microseconds expect_path(const World& world, Point start, Point goal, double grid_length, QueryContext& context) {
  Path path;
  PathQuery query{start, goal};
  query.wants_time = true;
  query.algorithm = PathAlgorithm::optimal;
  world.find_path(query, context, path).value();
  const Microseconds time = path.time;
  const double shortest = path.length;
  const PathStatus expected = grid_length < 0 ? PathStatus::no_path : PathStatus::found;
  EXPECT_EQ(path.status, expected) << text_of(start) << " to " << text_of(goal);
  if (expected == PathStatus::found) {
    EXPECT_LE(shortest, grid_length * (1 + 1e-9)) << text_of(start) << " to " << text_of(goal);
  }
  query.algorithm = PathAlgorithm::ta;
  world.find_path(query, context, path).value();
  EXPECT_EQ(path.status, expected) << text_of(start) << " to " << text_of(goal);
  EXPECT_GE(path.length, shortest * (1 - 1e-9));
  return time;
}

// The world starts without obstacles. The lengths in the file are those of 8-connected grid paths between the middles
// of tiles. A grid path exists exactly when any path exists, and the path by `optimal` is never longer.
TEST(DynamicPaths, FollowThePatchesOfAGrid) {
  const std::filesystem::path folder = data_folder() / "dynamic";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder << ": set WAYWRIGHT_DATA to the data folder";
  const std::vector<Rows> patches = read_patches(folder / "dao_arena2.patch");
  ASSERT_EQ(patches.size(), 336U);
  GridWorld grid(281, 209);
  QueryContext context;
  std::vector<Microseconds> patch_times;
  std::vector<Microseconds> query_times;
  std::ifstream in(folder / "dao_arena2.scen");
  bool is_changed = false;
  for (std::string line; std::getline(in, line);) {
    std::istringstream fields(line);
    std::string command, bucket;
    fields >> command >> bucket;
    if (command == "P") {
      std::size_t patch = 0, x = 0, y = 0;
      fields >> patch >> x >> y;
      patch_times.push_back(grid.apply(patches.at(patch), x, y));
      is_changed = true;
    } else if (command == "Q") {
      if (std::exchange(is_changed, false)) {
        ASSERT_TRUE(grid.world().validate().ok) << "before " << line;
      }
      double start_x = 0, start_y = 0, goal_x = 0, goal_y = 0, length = 0;
      fields >> start_x >> start_y >> goal_x >> goal_y >> length;
      query_times.push_back(
          expect_path(grid.world(), {start_x + 0.5, start_y + 0.5}, {goal_x + 0.5, goal_y + 0.5}, length, context));
    }
  }
  EXPECT_EQ(patch_times.size(), 439U);
  EXPECT_EQ(query_times.size(), 2000U);
  EXPECT_EQ(grid.world().item_count(), grid.outline_count());
  std::cout << grid.change_count() << " outlines came or went\n";
  print_times("patches", patch_times);
  print_times("queries", query_times);
}

}  // namespace
}  // namespace waywright::test
