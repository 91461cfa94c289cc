#include "waywright/job_system.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"

#include "support/case_count.hpp"
#include "support/job_systems.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

constexpr Box kMillion{{0, 0}, {1 << 20, 1 << 20}};

Point random_whole_point(Random& random) {
  return {static_cast<double>(random.between(0, 1 << 20)), static_cast<double>(random.between(0, 1 << 20))};
}

/// Returns enough points that every thread has work, and walls.
std::vector<Item> many_items() {
  Random random(4);
  std::vector<Item> items;
  const std::size_t points = case_count<std::size_t>(20'000, 4);
  while (items.size() < points)
    items.push_back({ItemId{items.size() + 1}, {ItemKind::point, {{random_whole_point(random)}}}});
  while (items.size() < points + 100) {
    const Point from = random_whole_point(random);
    items.push_back({ItemId{items.size() + 1}, {ItemKind::segment, {{from, {from.x / 2, from.y / 3}}}}});
  }
  return items;
}

/// Returns a world of these items, built by a job system. Checks that progress is reported on the calling thread only,
/// and increases.
World world_by(JobSystem& jobs, std::size_t threads) {
  const std::thread::id here = std::this_thread::get_id();
  std::size_t last = 0;
  BulkOptions options;
  options.threads = threads;
  options.jobs = &jobs;
  options.progress = [&](std::size_t done, std::size_t) {
    EXPECT_EQ(std::this_thread::get_id(), here);
    EXPECT_GE(done, last);
    last = done;
  };
  World world = World::create(kMillion).value();
  world.insert_all(many_items(), options).value();
  EXPECT_GT(last, 0U);
  return world;
}

class JobSystems : public testing::Test {
 protected:
  JobSystems() {
    Random random(5);
    world_.insert_all(many_items()).value();
    while (queries_.size() < 40)
      queries_.push_back({.start = random_whole_point(random), .goal = random_whole_point(random)});
    for (const PathQuery& query : queries_) expected_.push_back(world_.find_path(query).value());
  }

  /// Compares the results of a job system with those of one thread.
  void expect_right(JobSystem& jobs) {
    for (const std::size_t threads : {1U, 2U, 3U, 8U}) {
      const World world = world_by(jobs, threads);
      EXPECT_EQ(world.mesh_hash(), world_.mesh_hash());
      const std::vector<Path> paths = world_.find_paths(queries_, threads, &jobs).value();
      ASSERT_EQ(paths.size(), queries_.size());
      for (std::size_t i = 0; i < paths.size(); ++i) EXPECT_EQ(paths[i].points, expected_[i].points);
    }
  }

  World world_ = World::create(kMillion).value();
  std::vector<PathQuery> queries_;
  std::vector<Path> expected_;
};

TEST_F(JobSystems, MayMakeAllCallsInOrderOnTheCallingThread) {
  OneThread jobs(OneThread::Order::forwards);
  expect_right(jobs);
  EXPECT_GT(jobs.run_count, 10U);
}

TEST_F(JobSystems, MayMakeTheLastCallFirst) {
  OneThread jobs(OneThread::Order::backwards);
  expect_right(jobs);
}

TEST_F(JobSystems, MayMakeAllCallsOnOtherThreads) {
  Pool jobs(3);
  expect_right(jobs);
  EXPECT_GT(jobs.call_count, 50U);
}

TEST_F(JobSystems, MayMakeSomeCallsLateAndLeaveOthersOut) {
  Dawdler jobs;
  expect_right(jobs);
  EXPECT_GT(jobs.left_out, 10U);
}

TEST_F(JobSystems, AreNotAskedWhereOneThreadDoesAll) {
  OneThread jobs(OneThread::Order::forwards);
  world_by(jobs, 1);
  world_.find_paths(queries_, 1, &jobs).value();
  world_.find_paths(std::span(queries_).first(1), 4, &jobs).value();
  EXPECT_EQ(jobs.run_count, 0U);
}

/// Counts the calls of each run.
class Counting final : public JobSystem {
 public:
  void run(std::size_t count, const std::function<void(std::size_t)>& job) override {
    counts.push_back(count);
    for (std::size_t i = 0; i < count; ++i) job(i);
  }
  std::vector<std::size_t> counts;
};

TEST_F(JobSystems, AreAskedForAsManyCallsAsThereAreThreads) {
  Counting jobs;
  world_by(jobs, 5);
  ASSERT_FALSE(jobs.counts.empty());
  for (const std::size_t count : jobs.counts) EXPECT_EQ(count, 5U);
}

/// Fails at its n-th run.
class Failing final : public JobSystem {
 public:
  explicit Failing(int runs) : runs_(runs) {}
  void run(std::size_t count, const std::function<void(std::size_t)>& job) override {
    if (runs_-- == 0) throw std::runtime_error("no more jobs");
    for (std::size_t i = 0; i < count; ++i) job(i);
  }

 private:
  int runs_;
};

TEST_F(JobSystems, ThatThrowLeaveTheWorldAsItWas) {
  const MeshHash empty = World::create(kMillion).value().mesh_hash();
  int failures = 0;
  for (int runs = 0;; ++runs, ++failures) {
    World world = World::create(kMillion).value();
    Failing jobs(runs);
    BulkOptions options;
    options.threads = 3;
    options.jobs = &jobs;
    try {
      world.insert_all(many_items(), options).value();
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(error.what(), std::string("no more jobs"));
      EXPECT_EQ(world.mesh_hash(), empty);
      EXPECT_EQ(world.item_count(), 0U);
      continue;
    }
    EXPECT_EQ(world.mesh_hash(), world_.mesh_hash());
    break;
  }
  EXPECT_GT(failures, 3);
}

}  // namespace
}  // namespace waywright::test
