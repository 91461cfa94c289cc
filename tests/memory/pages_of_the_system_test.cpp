#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/world.hpp"
#include "waywright/world_snapshot.hpp"

#include "memory/arena.hpp"
#include "support/world_internals.hpp"

// The system refuses page files or mappings, and gets back those that it has given.

#if defined(__linux__)
#include <csignal>
#include <dirent.h>
#include <sys/resource.h>

namespace waywright::test {
namespace {

/// Sets a limit of the system for this process, until the object is destroyed.
class Limit {
 public:
  Limit(decltype(RLIMIT_AS) resource, std::size_t value) : resource_(resource) {
    ::getrlimit(resource, &old_);
    const ::rlimit limit{value, old_.rlim_max};
    ::setrlimit(resource, &limit);
  }
  ~Limit() { ::setrlimit(resource_, &old_); }
  Limit(const Limit&) = delete;
  Limit& operator=(const Limit&) = delete;

 private:
  decltype(RLIMIT_AS) resource_;
  ::rlimit old_{};
};

std::size_t open_files() {
  std::size_t count = 0;
  DIR* const folder = ::opendir("/proc/self/fd");
  while (::readdir(folder) != nullptr) ++count;
  ::closedir(folder);
  return count;
}

std::size_t mapped_pages_files() {
  std::ifstream maps("/proc/self/maps");
  const std::vector<std::string> words{std::istream_iterator<std::string>(maps), {}};
  return static_cast<std::size_t>(std::count(words.begin(), words.end(), "/memfd:waywright"));
}

std::size_t mapped_memory() {
  std::ifstream file("/proc/self/statm");
  std::size_t pages = 0;
  file >> pages;
  return pages * 4096;
}

/// A world that changes between snapshots. All its replicas share pages if the system lets them.
class Publisher {
 public:
  Publisher() { WorldInternals::share_pages(world_); }

  /// Changes the world and publishes it, and checks the snapshot.
  WorldSnapshot publish() {
    const double x = 1 + count_++ % 90;
    world_.insert(Shape::rectangle({{x, 1}, {x + 0.5, 2}})).value();
    WorldSnapshot snapshot = world_.publish();
    EXPECT_EQ(snapshot->mesh_hash(), world_.mesh_hash());
    EXPECT_EQ(snapshot->validate().fault, "");
    return snapshot;
  }
  std::size_t sharing_replicas() const { return WorldInternals::sharing_replicas(world_); }

 private:
  World world_ = World::create({{0, 0}, {100, 100}}, {.keep_bridges = true}).value();
  int count_ = 0;
};

class PagesOfTheSystem : public testing::Test {
 protected:
  void SetUp() override {
    if (memory::Arena::make(1) == nullptr) GTEST_SKIP() << "this system does not share pages";
  }
};

TEST_F(PagesOfTheSystem, GiveWayToCopiesIfNoFileCanBeOpened) {
  Publisher publisher;
  std::vector<WorldSnapshot> held;
  {
    const Limit limit(RLIMIT_NOFILE, 3);
    for (int i = 0; i < 4; ++i) held.push_back(publisher.publish());
  }
  EXPECT_EQ(publisher.sharing_replicas(), 0U);
  held.push_back(publisher.publish());
  EXPECT_EQ(publisher.sharing_replicas(), 0U) << "the pool does not try again";
}

// A file above the limit would end the process by the signal SIGXFSZ.
TEST_F(PagesOfTheSystem, GiveWayToCopiesIfFilesMustBeSmall) {
  Publisher publisher;
  const Limit limit(RLIMIT_FSIZE, 100'000);
  std::vector<WorldSnapshot> held;
  for (int i = 0; i < 4; ++i) held.push_back(publisher.publish());
  EXPECT_EQ(publisher.sharing_replicas(), 0U);
}

TEST_F(PagesOfTheSystem, GiveWayToCopiesIfThereAreNoAddresses) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer needs addresses";
#endif
  Publisher publisher;
  std::vector<WorldSnapshot> held;
  for (int i = 0; i < 3; ++i) held.push_back(publisher.publish());
  EXPECT_EQ(publisher.sharing_replicas(), 3U);
  const Limit limit(RLIMIT_AS, mapped_memory() + (std::size_t{1} << 19));  // less than an arena, which has 1 MB or more
  for (int i = 0; i < 3; ++i) held.push_back(publisher.publish());
  EXPECT_EQ(publisher.sharing_replicas(), 3U);
}

TEST_F(PagesOfTheSystem, GoBackToTheSystem) {
  const std::size_t files_before = open_files();
  ASSERT_EQ(mapped_pages_files(), 0U);
  std::vector<WorldSnapshot> held;
  std::optional<World> clone;
  {
    Publisher publisher;
    for (int i = 0; i < 30; ++i) held.push_back(publisher.publish());
    EXPECT_GT(mapped_pages_files(), 29U);
    EXPECT_GT(publisher.sharing_replicas(), 29U);
    clone = held[10]->clone();
  }
  EXPECT_EQ(open_files(), files_before) << "only a base has an open file";
  const MeshHash hash = held[10]->mesh_hash();
  std::thread reader([&] {
    for (WorldSnapshot& snapshot : held) {
      EXPECT_EQ(snapshot->validate().fault, "");
      snapshot.release();
    }
  });
  reader.join();
  EXPECT_EQ(mapped_pages_files(), 0U);
  EXPECT_EQ(clone->mesh_hash(), hash);
  clone->insert_point({50, 50}).value();
  EXPECT_EQ(clone->validate().fault, "");
}

}  // namespace
}  // namespace waywright::test
#endif
