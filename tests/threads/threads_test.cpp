#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "support/job_systems.hpp"
#include "support/random.hpp"
#include "support/random_scenes.hpp"

namespace waywright::test {
namespace {

struct Answers {
  std::vector<std::vector<Point>> paths;
  std::vector<std::vector<ItemId>> inside;
  std::vector<WidestPath> widest;

  bool operator==(const Answers&) const = default;
};

Answers ask(const World& world, const std::vector<Point>& points) {
  Answers answers;
  QueryContext context;
  Path path;
  Location location;
  DiscFit fit;
  WidestPath widest;
  for (std::size_t i = 1; i < points.size(); ++i) {
    world.locate(points[i], context, location).value();
    answers.inside.push_back(location.polygons);
    world.find_path({points[i - 1], points[i]}, context, path).value();
    answers.paths.push_back(path.points);
    answers.paths.push_back(world.find_path({points[i], points[i - 1]}).value().points);  // the world's own context
    answers.inside.push_back(world.items_in({points[i], points[i]}).value());
    world.fit_disc(points[i], {.radius = 500}, context, fit).value();
    answers.inside.push_back(fit.items);
    world.widest_path(points[i - 1], points[i], {}, context, widest).value();
    answers.widest.push_back(widest);
    answers.widest.push_back(world.widest_path(points[i], points[i - 1]).value());
  }
  return answers;
}

// Made for the thread sanitizer: queries write to no memory that they share.
TEST(Threads, AnyNumberMayQueryOneWorldAtOnce) {
  const Scene scene = random_scene(Flavour::small, 7, 60);
  World world = World::create(scene.domain, {.keep_bridges = true}).value();
  for (const Item& item : scene.items) ASSERT_TRUE(world.insert(item.shape, item.id).ok());
  Random random(7);
  std::vector<Point> points;
  for (int i = 0; i < 60; ++i) points.push_back(random_point(Flavour::small, scene.domain, random));

  const Answers alone = ask(world, points);
  std::vector<Answers> answers(4);
  std::vector<std::thread> threads;
  for (Answers& own_answers : answers) threads.emplace_back([&] { own_answers = ask(world, points); });
  for (std::thread& thread : threads) thread.join();
  for (const Answers& own_answers : answers) EXPECT_EQ(own_answers, alone);
}

TEST(Threads, ShareTheQueriesOfABatch) {
  const Scene scene = random_scene(Flavour::small, 8, 60);
  World world = World::create(scene.domain).value();
  for (const Item& item : scene.items) ASSERT_TRUE(world.insert(item.shape, item.id).ok());
  Random random(8);
  std::vector<PathQuery> queries;
  for (int i = 0; i < 100; ++i) {
    queries.push_back(
        {random_point(Flavour::small, scene.domain, random), random_point(Flavour::small, scene.domain, random)});
  }
  const std::vector<Path> paths = world.find_paths(queries, 4).value();
  ASSERT_EQ(paths.size(), queries.size());
  Pool pool(3);
  const std::vector<Path> by_pool = world.find_paths(queries, 4, &pool).value();
  for (std::size_t i = 0; i < queries.size(); ++i) {
    EXPECT_EQ(paths[i].points, world.find_path(queries[i]).value().points);
    EXPECT_EQ(by_pool[i].points, paths[i].points);
  }
}

// A crowd, a lattice and repeated points; enough of them that every thread has work.
TEST(Threads, ManyBuildTheWorldThatOneBuilds) {
  Random random(31);
  std::vector<Point> points;
  for (int i = 0; i < 6000; ++i) {
    const auto fraction = [&] { return static_cast<double>(random.below(std::size_t{1} << 40)) * 0x1p-40; };
    points.push_back({fraction(), fraction()});
    points.push_back({fraction() / 64, fraction() / 64});
    points.push_back({static_cast<double>(random.below(65)) / 64, static_cast<double>(random.below(65)) / 64});
  }
  std::string alone;
  for (const std::size_t threads : {1U, 2U, 3U, 7U}) {
    World world = World::create({{0, 0}, {1, 1}}).value();
    std::size_t last = 0;
    const auto progress = [&](std::size_t done, std::size_t total) {
      EXPECT_EQ(total, points.size());
      EXPECT_LE(last, done);
      last = done;
    };
    EXPECT_EQ(world.insert_points(points, {}, {threads, progress}).value(), ItemId{1});
    EXPECT_EQ(last, points.size());
    if (threads == 1) alone = world.dump();
    EXPECT_EQ(world.dump(), alone) << threads << " threads";
    EXPECT_TRUE(world.validate().ok);
    World other = World::create({{0, 0}, {1, 1}}).value();
    Pool pool(3);
    other.insert_points(points, {}, {threads, {}, &pool}).value();
    EXPECT_EQ(other.dump(), alone) << threads << " jobs";
  }
}

// Made for the thread sanitizer: sides in regions beside each other, and sides that leave their region.
TEST(Threads, InsertTheSidesOfOneBatch) {
  Random random(32);
  std::vector<Item> items;
  const auto fraction = [&] { return static_cast<double>(random.below(std::size_t{1} << 40)) * 0x1p-40; };
  for (std::uint64_t i = 1; i <= 9000; ++i) {
    const Point from{64 * fraction(), 64 * fraction()};
    const Point to{from.x + fraction() - 0.5, from.y + fraction() - 0.5};
    items.push_back({{i}, Shape::segment(from, to)});
  }
  std::string alone;
  for (const std::size_t threads : {1U, 2U, 4U}) {
    World world = World::create({{-1, -1}, {65, 65}}).value();
    world.insert_all(items, {threads, {}}).value();
    if (threads == 1) alone = world.dump();
    EXPECT_EQ(world.dump(), alone) << threads << " threads";
  }
}

}  // namespace
}  // namespace waywright::test
