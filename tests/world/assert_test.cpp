#include "waywright/assert.hpp"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/path_search.hpp"
#include "waywright/path_watch.hpp"
#include "waywright/world.hpp"

namespace waywright::test {
namespace {

World world_of_ten() { return World::create({{0, 0}, {10, 10}}).value(); }

/// Prints the failure and ends the process with a special status.
[[noreturn]] void end(const AssertionFailure& failure) {
  std::fprintf(stderr, "mine: %s (%s) in %s, line %s\n", failure.message, failure.condition, failure.file,
               failure.line > 0 ? "known" : "unknown");
  std::_Exit(3);
}

TEST(Assertion, PrintsWhatAndWhereAndAborts) {
  EXPECT_DEATH(static_cast<void>(centroid({})),
               "^waywright: centroid: the shape has no point\n  item.cpp:[0-9]+: '.*' is false\n$");
  EXPECT_EXIT(static_cast<void>(centroid({})), testing::KilledBySignal(SIGABRT), "");
}

// A message does not say in which folder the program was built.
TEST(Assertion, NamesItsFileWithoutFolders) {
  EXPECT_DEATH(WAYWRIGHT_ASSERT(1 > 2, "mine"), "^waywright: mine\n  assert_test.cpp:[0-9]+: '1 > 2' is false\n$");
  EXPECT_DEATH(static_cast<void>(*world_of_ten().locate({3, 17})), "\n  [a-z]+\\.[a-z]+:[0-9]+: '.*' is false\n$");
  EXPECT_STREQ(detail::file_name("/home/me/game/wall.cpp"), "wall.cpp");
  EXPECT_STREQ(detail::file_name("C:\\game\\wall.cpp"), "wall.cpp");
  EXPECT_STREQ(detail::file_name("wall.cpp"), "wall.cpp");
  EXPECT_STREQ(detail::file_name(""), "");
}

TEST(Assertion, CallsTheHandlerThatIsSet) {
  EXPECT_EXIT(
      {
        set_assertion_handler(end);
        static_cast<void>(centroid({}));
      },
      testing::ExitedWithCode(3), "^mine: centroid: the shape has no point \\(.+\\) in item.cpp, line known\n$");
}

TEST(Assertion, AbortsWhenTheHandlerReturns) {
  EXPECT_EXIT(
      {
        set_assertion_handler([](const AssertionFailure&) { std::fputs("seen\n", stderr); });
        static_cast<void>(centroid({}));
      },
      testing::KilledBySignal(SIGABRT), "^seen\n$");
}

TEST(Assertion, HandlerIsHandedBack) {
  const AssertionHandler first = set_assertion_handler(end);
  EXPECT_NE(first, nullptr);
  EXPECT_EQ(set_assertion_handler(nullptr), &end);
  EXPECT_EQ(set_assertion_handler(nullptr), first) << "null stands for the default handler";
}

TEST(AssertionOf, AResultIsBrokenByTheWrongAccess) {
  const Result<Location> refused = world_of_ten().locate({3, 17});
  const char* const why =
      "the program took the value of a Result that has an error: the point, \\(3, 17\\), lies outside the domain, "
      "\\(0, 0\\) to \\(10, 10\\)";
  EXPECT_DEATH(static_cast<void>(*refused), why);
  EXPECT_DEATH(static_cast<void>(refused->kind), why);
  EXPECT_DEATH(static_cast<void>(*world_of_ten().locate({3, 17})), why);
  const Result<Location> done = world_of_ten().locate({3, 7});
  EXPECT_DEATH(static_cast<void>(done.error()), "Result::error\\(\\): the result has no error");
  EXPECT_DEATH(static_cast<void>(Result<void>().error()), "Result::error\\(\\): the result has no error");
}

TEST(AssertionOf, AnObjectThatHasBeenMovedFrom) {
  World world = world_of_ten();
  const World other = std::move(world);
  const char* const moved_world = "World: this object has been moved from";
  EXPECT_DEATH(static_cast<void>(world.contains(1)), moved_world);
  EXPECT_DEATH(static_cast<void>(world.insert_point({1, 1})), moved_world);
  EXPECT_DEATH(static_cast<void>(world.find_path({.start = {1, 1}, .goal = {2, 2}})), moved_world);
  EXPECT_DEATH(static_cast<void>(world.version()), moved_world);

  QueryContext context;
  const QueryContext other_context = std::move(context);
  const char* const moved_context = "QueryContext: this object has been moved from";
  Location location;
  std::vector<ItemId> items;
  Path path;
  EXPECT_DEATH(static_cast<void>(other.locate({1, 1}, context, location)), moved_context);
  EXPECT_DEATH(static_cast<void>(other.items_at({1, 1}, context, items)), moved_context);
  EXPECT_DEATH(static_cast<void>(other.find_path({.start = {1, 1}, .goal = {2, 2}}, context, path)), moved_context);

  PathSearch search;
  const PathSearch other_search = std::move(search);
  EXPECT_DEATH(static_cast<void>(search.begin(other, {.start = {1, 1}, .goal = {2, 2}})),
               "PathSearch: this object has been moved from");
  EXPECT_DEATH(static_cast<void>(search.is_running()), "PathSearch: this object has been moved from");

  // A program can assign to objects that were moved from.
  world = world_of_ten();
  context = QueryContext();
  search = PathSearch();
  EXPECT_TRUE(world.locate({1, 1}, context, location).ok());
  EXPECT_FALSE(search.is_running());
}

TEST(AssertionOf, ThereBeingAThreadAndAContext) {
  World world = world_of_ten();
  const std::vector<Item> items{{1, Shape::point({1, 1})}};
  const std::vector<PathQuery> queries{{.start = {1, 1}, .goal = {2, 2}}};
  std::vector<Path> paths;
  BulkOptions no_thread;
  no_thread.threads = 0;
  EXPECT_DEATH(static_cast<void>(world.insert_all(items, no_thread)), "`threads` is 0");
  EXPECT_DEATH(static_cast<void>(world.insert_points({{1, 1}}, {}, no_thread)), "`threads` is 0");
  EXPECT_DEATH(static_cast<void>(world.find_paths(queries, 0)), "there is no context, or the number of threads is 0");
  EXPECT_DEATH(static_cast<void>(world.find_paths(queries, {}, paths)), "there is no context");
}

TEST(AssertionOf, APathWithoutPoints) {
  const Path path;
  EXPECT_DEATH(static_cast<void>(path.at(1)), "the path has no points");
  EXPECT_DEATH(static_cast<void>(path.nearest({1, 1})), "the path has no points");
  const World world = world_of_ten();
  const std::vector<Point> goals = {{7, 7}};
  const Path without_points = world.find_paths_from({.start = {1, 1}, .goals = goals}).value()[0];
  PathWatch watch(world);
  EXPECT_DEATH(watch.add(1, without_points), "the path is found, but has no points");
}

TEST(AssertionOf, ShapesAndBoxes) {
  Rings rings;
  EXPECT_DEATH(static_cast<void>(rings[0]), "there is no ring with this index");
  EXPECT_DEATH(static_cast<void>(rings.back()), "there is no ring with this index");
  EXPECT_DEATH(rings.add_point({1, 1}), "there is no ring yet");
  EXPECT_DEATH(static_cast<void>(centroid({ItemKind::polygon, {{}}})), "the shape has no point");
  EXPECT_DEATH(static_cast<void>(Box::bounding({})), "Box::bounding: there is no point");
}

}  // namespace
}  // namespace waywright::test
