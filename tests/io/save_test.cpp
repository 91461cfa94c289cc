#include "waywright/save.hpp"

#include <csignal>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <string_view>
#include <sys/resource.h>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/scene.hpp"
#include "waywright/script.hpp"

#include "io/crc32c.hpp"
#include "support/saved_world_oracle.hpp"
#include "support/small_worlds.hpp"

namespace waywright::test {
namespace {

namespace fs = std::filesystem;
using saved_world::Contents;
using saved_world::fixed;
using saved_world::sealed;
using saved_world::varint;

const std::string kPoint = fixed(item_hash::bits(1.0), 8) + fixed(item_hash::bits(2.0), 8);

/// A few items of every kind, with ids that count up and ids that do not.
std::map<ItemId, Shape> items_of_every_kind() {
  const Rings with_hole = {{{1, 1}, {9, 1}, {9, 9}, {1, 9}}, {{3, 3}, {6, 3}, {6, 6}}};
  return {{1, Shape::point({1, 2})},
          {2, Shape::point({-0.0, 4.5})},
          {3, Shape::segment({5, 5}, {5, 5})},
          {4, Shape::segment({2, 0}, {2, 10})},
          {7, Shape::polyline({{1, 1}, {1, 1}, {2, 3}, {8, 0.1}})},
          {300, Shape::polygon(with_hole)},
          {301, Shape::polygon(with_hole, FillRule::nonzero)},
          {ItemId::kLargest - 1, Shape::polygon({{4, 4}, {4, 4}})}};
}

Contents small_contents() { return {kTen, 1, ItemId::kLargest, items_of_every_kind()}; }

World world_of(const Contents& contents) {
  World world = World::create(contents.domain,
                              {.keep_abstraction = (contents.options & 1) != 0, .keep_bridges = contents.options > 1})
                    .value();
  std::vector<Item> items;
  for (const auto& [id, shape] : contents.items) items.push_back({id, shape});
  world.insert_all(items).value();
  if (contents.largest_id > 0) world.reserve_ids(contents.largest_id).value();
  return world;
}

std::string save(const World& world) {
  std::ostringstream out;
  EXPECT_TRUE(save_world(world, out).ok());
  return out.str();
}

Result<World> load(const std::string& bytes) {
  std::istringstream in(bytes);
  return load_world(in);
}

void expect_refused(const std::string& bytes, ErrorCode code, std::string_view text) {
  const Result<World> world = load(bytes);
  ASSERT_FALSE(world.ok()) << text;
  EXPECT_EQ(world.error().code, code) << world.error().message();
  EXPECT_NE(world.error().message().find(text), std::string::npos) << world.error().message();
}

void expect_malformed(const std::string& bytes, std::string_view text) {
  expect_refused(bytes, ErrorCode::malformed, text);
}

/// Returns a saved world with this header and these runs.
std::string with_runs(std::uint64_t largest_id, std::uint64_t item_count, const std::string& runs) {
  std::string bytes = saved_world::header({kTen, 1, largest_id, {}});
  bytes.replace(52, 8, fixed(item_count, 8));
  return sealed(bytes + runs);
}

TEST(Crc32c, HasThePublishedValues) {
  const auto of = [](std::string_view bytes) {
    io::Crc32c crc;
    crc.add(bytes);
    return crc.value();
  };
  EXPECT_EQ(of("123456789"), 0xe3069283U);
  EXPECT_EQ(of(std::string(32, '\0')), 0x8a9136aaU);  // RFC 3720, B.4
  EXPECT_EQ(of(std::string(32, '\xff')), 0x62a8ab43U);
  EXPECT_EQ(of(""), 0U);
}

TEST(Crc32c, DoesNotDependOnThePieces) {
  const std::string bytes = saved_world::bytes_of(small_contents());
  for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
    io::Crc32c crc;
    crc.add(std::string_view(bytes).substr(0, cut));
    crc.add(std::string_view(bytes).substr(cut));
    ASSERT_EQ(crc.value(), saved_world::checksum(bytes)) << cut;
  }
}

TEST(SaveWorld, WritesTheBytesOfThePage) {
  EXPECT_EQ(save(World::create(kTen).value()), saved_world::bytes_of({kTen, 1, 0, {}}));
  EXPECT_EQ(save(world_of(small_contents())), saved_world::bytes_of(small_contents()));
  for (std::uint64_t options = 0; options < 4; ++options) {
    Contents contents = small_contents();
    contents.options = options;
    EXPECT_EQ(save(world_of(contents)), saved_world::bytes_of(contents)) << options;
  }
}

TEST(SaveWorld, DividesLongRuns) {
  Contents contents{kTen, 1, 9000, {}};
  for (int i = 1; i <= 9000; ++i) contents.items.insert({i, Shape::point({i / 1024.0, 5.0})});
  World world = World::create(kTen).value();
  std::vector<Point> points;
  for (const auto& [id, shape] : contents.items) points.push_back(shape.rings[0][0]);
  world.insert_points(points).value();
  const std::string bytes = save(world);
  EXPECT_EQ(bytes, saved_world::bytes_of(contents));
  EXPECT_LE(bytes.size(), 9000U * 16 + 100);
  EXPECT_EQ(load(bytes).value().mesh_hash(), world.mesh_hash());
}

TEST(LoadWorld, ReadsWhatThePageDescribes) {
  const Contents contents = small_contents();
  const World world = load(saved_world::bytes_of(contents)).value();
  EXPECT_EQ(world.items_hash().words, item_hash::hash_of(contents.domain, contents.items));
  EXPECT_EQ(world.mesh_hash(), world_of(contents).mesh_hash());
  EXPECT_EQ(world.largest_id_seen(), ItemId{ItemId::kLargest});
  EXPECT_TRUE(world.options().keep_abstraction);
  EXPECT_FALSE(world.options().keep_bridges);
  EXPECT_EQ(world.validate().fault, "");
}

/// A saved world in tests/saved. A world script of the same name has its items.
struct Golden {
  std::string name;
  std::uint64_t options;
  std::uint64_t largest_id;
};

std::string read_all(const std::string& name) {
  std::ifstream in(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Every later version must read these files, which another program has written after the page. Never write them anew:
// add files for a new version of the format.
TEST(LoadWorld, ReadsTheFilesOfEveryVersion) {
  for (const Golden& golden :
       {Golden{"empty", 1, 0}, Golden{"points", 1, 40}, Golden{"every_kind", 3, ItemId::kLargest},
        Golden{"extremes", 0, 200}, Golden{"long_run", 1, 4100}}) {
    SCOPED_TRACE(golden.name);
    const std::string stem = WAYWRIGHT_SOURCE_DIR "/tests/saved/" + golden.name;
    const Scene scene = scene_of(parse_script(read_all(stem + ".wws"), golden.name).value());
    Contents contents{scene.domain, golden.options, golden.largest_id, {}};
    for (const Item& item : scene.items) contents.items.insert({item.id, item.shape});
    const Result<World> world = load_world_file(stem + ".wwb");
    ASSERT_TRUE(world.ok()) << world.error().message();
    EXPECT_EQ(world->items_hash().words, item_hash::hash_of(contents.domain, contents.items));
    EXPECT_EQ(world->mesh_hash(), world_of(contents).mesh_hash());
    EXPECT_EQ(world->largest_id_seen(), ItemId{golden.largest_id});
    EXPECT_EQ(world->options().keep_abstraction, (golden.options & 1) != 0);
    EXPECT_EQ(world->options().keep_bridges, (golden.options & 2) != 0);
    EXPECT_EQ(save(*world), read_all(stem + ".wwb"));
  }
}

TEST(LoadWorld, ContinuesTheIds) {
  World world = World::create(kTen).value();
  world.insert_point({1, 1}, 70).value();
  world.remove(70).value();
  World loaded = load(save(world)).value();
  EXPECT_EQ(loaded.insert_point({2, 2}).value(), ItemId{71});
}

TEST(LoadWorld, ReadsOnThreadsAndReportsProgress) {
  const std::string bytes = saved_world::bytes_of(small_contents());
  std::istringstream in(bytes);
  std::size_t last = 0;
  std::size_t of = 1;
  const BulkOptions options{.threads = 2, .progress = [&](std::size_t done, std::size_t total) {
                              last = done;
                              of = total;
                            }};
  EXPECT_EQ(load_world(in, options).value().items_hash(), world_of(small_contents()).items_hash());
  EXPECT_EQ(last, of);
}

TEST(LoadWorld, LeavesTheStreamAfterTheWorld) {
  std::stringstream stream;
  stream << "before";
  ASSERT_TRUE(save_world(world_of(small_contents()), stream).ok());
  ASSERT_TRUE(save_world(World::create(kTen).value(), stream).ok());
  stream << "after";
  std::string before(6, ' ');
  stream.read(before.data(), 6);
  EXPECT_EQ(load_world(stream).value().item_count(), 8U);
  EXPECT_EQ(load_world(stream).value().item_count(), 0U);
  std::string after;
  stream >> after;
  EXPECT_EQ(after, "after");
}

TEST(LoadWorld, AcceptsRepeatedPointsAndShortRuns) {
  Contents contents{kTen, 1, 2, {{1, Shape::point({1, 2})}, {2, Shape::point({1, 2})}}};
  const std::string runs = varint(1) + varint(8) + kPoint + varint(1) + varint(8) + kPoint;
  EXPECT_EQ(load(sealed(saved_world::header(contents) + runs)).value().item_count(), 2U);
  contents = {kTen, 1, 1, {{1, Shape::polyline({{1, 2}})}}};
  const std::string repeated = varint(1) + varint(8 + 2) + varint(2) + kPoint + kPoint;
  EXPECT_EQ(load(sealed(saved_world::header(contents) + repeated)).value().item_count(), 1U);
}

TEST(LoadWorld, RefusesEveryPrefix) {
  const std::string bytes = saved_world::bytes_of(small_contents());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ASSERT_NO_FATAL_FAILURE(expect_malformed(bytes.substr(0, size), "found the end")) << size;
  }
}

TEST(LoadWorld, RefusesEveryOtherByte) {
  const std::string bytes = saved_world::bytes_of(small_contents());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (int value = 0; value < 256; ++value) {
      std::string altered = bytes;
      altered[i] = static_cast<char>(value);
      ASSERT_EQ(load(altered).ok(), altered == bytes) << "byte " << i << " is " << value;
    }
  }
}

/// Alters each byte and makes the checksum right again: so only the other checks can refuse the bytes. If they do not,
/// the world must be the world that its own bytes describe.
TEST(LoadWorld, RefusesOrUnderstandsOtherBytesWithARightChecksum) {
  const std::string bytes = saved_world::bytes_of(small_contents());
  const std::string body = bytes.substr(0, bytes.size() - 4);
  for (std::size_t i = 0; i < body.size(); ++i) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      std::string altered = body;
      altered[i] = static_cast<char>(altered[i] ^ static_cast<char>(1U << bit));
      const Result<World> world = load(sealed(altered));
      if (!world.ok()) continue;
      const bool is_described = save(*world) == sealed(altered);
      const bool has_only_another_zero = save(*world) == bytes;  // -0 in place of 0
      ASSERT_TRUE(is_described || has_only_another_zero) << "byte " << i << ", bit " << bit;
    }
  }
}

TEST(LoadWorld, RefusesHostileHeaders) {
  const std::string header = saved_world::header({kTen, 1, 5, {}});
  const auto with = [&](std::size_t at, const std::string& bytes) {
    return sealed(std::string(header).replace(at, bytes.size(), bytes));
  };
  const std::string nan = fixed(item_hash::bits(std::numeric_limits<double>::quiet_NaN()), 8);
  expect_malformed(with(0, "w"), "starts with 'WWORLD'");
  expect_malformed("waywright 1\ndomain 0 0 1 1\n", "starts with 'WWORLD'");
  expect_refused(with(6, fixed(2, 2)), ErrorCode::not_supported, "version 2");
  expect_refused(with(6, fixed(0, 2)), ErrorCode::not_supported, "version 0");
  expect_malformed(with(8, nan), "domain");
  expect_malformed(with(8, fixed(item_hash::bits(10.0), 8)), "min.x < max.x");
  expect_malformed(with(40, fixed(4, 4)), "unknown bit");
  expect_malformed(with(40, fixed(0x80000001, 4)), "unknown bit");
  expect_malformed(with(44, fixed(ItemId::kLargest + 1, 8)), "largest id");
  expect_malformed(with(52, fixed(std::uint64_t{1} << 60, 8)), "");
  expect_malformed(with(60, fixed(1, 8)), "the hash of the items is wrong");
}

TEST(LoadWorld, RefusesHostileRuns) {
  const std::string huge = varint(std::uint64_t{1} << 60);
  const std::string largest = varint(~std::uint64_t{0});
  expect_malformed(with_runs(9, 1, varint(0) + varint(8) + kPoint), "ids do not ascend");
  expect_malformed(with_runs(9, 1, varint(10) + varint(8) + kPoint), "above the largest id");
  expect_malformed(with_runs(9, 2, varint(9) + varint(16) + kPoint + kPoint), "above the largest id");
  expect_malformed(with_runs(9, 1, largest + varint(8) + kPoint), "above the largest id");
  expect_malformed(with_runs(9, 1, varint(1) + varint(0)), "items of a run");
  expect_malformed(with_runs(9, 9000, varint(1) + varint(4097 * 8)), "items of a run");
  expect_malformed(with_runs(9, 9, varint(1) + largest), "items of a run");
  expect_malformed(with_runs(9, 1, varint(1) + varint(16) + kPoint + kPoint), "more items than are left");
  expect_malformed(with_runs(9, 1, varint(1) + varint(8 + 5)), "unknown kind");
  expect_malformed(with_runs(9, 1, varint(1) + varint(8 + 2) + varint(0)), "not from 1 to 2^27");
  expect_malformed(with_runs(9, 1, varint(1) + varint(8 + 2) + huge + kPoint), "not from 1 to 2^27");
  expect_malformed(with_runs(9, 1, varint(1) + varint(8 + 3) + huge + varint(1) + kPoint), "not from 1 to 2^27");
  expect_malformed(with_runs(9, 1, varint(1) + varint(8 + 2) + varint(1U << 27) + kPoint), "found the end");
  expect_malformed(with_runs(9, 1, "\x81\x80" + std::string(1, '\0')), "more bytes than it needs");
  expect_malformed(with_runs(9, 1, std::string(9, '\xff') + "\x02"), "above 2^64 - 1");
  expect_malformed(with_runs(9, 1, std::string(10, '\xff') + "\x01"), "above 2^64 - 1");
  const std::string outside = fixed(item_hash::bits(11.0), 8) + fixed(item_hash::bits(1.0), 8);
  expect_malformed(with_runs(9, 1, varint(1) + varint(8) + outside), "outside the domain");
}

TEST(LoadWorld, ReportsWhereTheFaultIs) {
  const Result<World> world = load(with_runs(9, 1, varint(0) + varint(8) + kPoint));
  EXPECT_EQ(world.error().index, 78U);
  EXPECT_EQ(world.error().message(), "byte 78: the ids do not ascend");
}

/// A stream buffer that fails after some bytes, with an exception or without one.
class FailingBuffer : public std::streambuf {
 public:
  FailingBuffer(std::string bytes, std::size_t limit, bool throws)
      : bytes_(std::move(bytes)), limit_(limit), throws_(throws) {}

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 protected:
  int_type underflow() override {
    if (at_ == limit_) return fail();
    return traits_type::to_int_type(bytes_[at_]);
  }
  int_type uflow() override {
    const int_type c = underflow();
    if (c != traits_type::eof()) ++at_;
    return c;
  }
  int_type overflow(int_type c) override {
    if (bytes_.size() == limit_) return fail();
    bytes_ += traits_type::to_char_type(c);
    return c;
  }

 private:
  int_type fail() const {
    if (throws_) throw std::runtime_error("the device is gone");
    return traits_type::eof();
  }

  std::string bytes_;
  std::size_t limit_;
  std::size_t at_ = 0;
  bool throws_;
};

TEST(SaveWorld, ReportsAStreamThatFailsAfterAnyByte) {
  const World world = world_of(small_contents());
  const std::string bytes = save(world);
  for (const bool throws : {false, true}) {
    for (std::size_t limit = 0; limit < bytes.size(); ++limit) {
      FailingBuffer buffer({}, limit, throws);
      std::ostream out(&buffer);
      const Result<void> saved = save_world(world, out);
      ASSERT_FALSE(saved.ok()) << limit;
      ASSERT_EQ(saved.error().code, ErrorCode::unwritable);
      ASSERT_EQ(buffer.bytes(), bytes.substr(0, limit));
    }
  }
}

TEST(LoadWorld, ReportsAStreamThatFailsAfterAnyByte) {
  const std::string bytes = saved_world::bytes_of(small_contents());
  for (std::size_t limit = 0; limit < bytes.size(); ++limit) {
    FailingBuffer buffer(bytes, limit, true);
    std::istream in(&buffer);
    const Result<World> world = load_world(in);
    ASSERT_FALSE(world.ok()) << limit;
    ASSERT_EQ(world.error().code, ErrorCode::unreadable) << world.error().message();
  }
}

TEST(SaveAndLoad, RefuseStreamsThatHaveFailed) {
  std::stringstream stream;
  stream.setstate(std::ios::failbit);
  EXPECT_EQ(save_world(world_of(small_contents()), stream).error().code, ErrorCode::unwritable);
  EXPECT_EQ(load_world(stream).error().code, ErrorCode::unreadable);
  EXPECT_EQ(stream.str(), "");
}

/// A test that has a folder of its own.
class WorldFile : public testing::Test {
 protected:
  void SetUp() override {
    const std::string test_name = testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = fs::path(testing::TempDir()) / ("waywright_world_file_" + test_name);
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string file_of(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::size_t file_count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
  }
  static std::string read(const std::string& name) {
    std::ifstream in(name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  static void write(const std::string& name, const std::string& bytes) {
    std::ofstream(name, std::ios::binary) << bytes;
  }

 private:
  fs::path folder_;
};

TEST_F(WorldFile, IsWrittenAndReadAgain) {
  const World world = world_of(small_contents());
  ASSERT_TRUE(save_world_file(world, file_of("a.wwb")).ok());
  EXPECT_EQ(read(file_of("a.wwb")), saved_world::bytes_of(small_contents()));
  EXPECT_EQ(load_world_file(file_of("a.wwb")).value().mesh_hash(), world.mesh_hash());
  EXPECT_EQ(file_count(), 1U);
}

TEST_F(WorldFile, ReplacesAFileAndKeepsItsPermissions) {
  const std::string name = file_of("a.wwb");
  write(name, "old");
  fs::permissions(name, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  ASSERT_TRUE(save_world_file(world_of(small_contents()), name).ok());
  EXPECT_EQ(load_world_file(name).value().item_count(), 8U);
  EXPECT_EQ(fs::status(name).permissions(), fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  EXPECT_EQ(file_count(), 1U);
}

TEST_F(WorldFile, ReplacesTheFileBehindALink) {
  write(file_of("a.wwb"), "old");
  fs::create_symlink("a.wwb", file_of("link.wwb"));
  ASSERT_TRUE(save_world_file(world_of(small_contents()), file_of("link.wwb")).ok());
  EXPECT_TRUE(fs::is_symlink(file_of("link.wwb")));
  EXPECT_EQ(read(file_of("a.wwb")), saved_world::bytes_of(small_contents()));
  EXPECT_EQ(file_count(), 2U);
}

TEST_F(WorldFile, IsMadeWhereALinkLeads) {
  fs::create_directory(file_of("saves"));
  fs::create_symlink("saves/second.wwb", file_of("first.wwb"));
  fs::create_symlink("a.wwb", file_of("saves/second.wwb"));
  ASSERT_TRUE(save_world_file(world_of(small_contents()), file_of("first.wwb")).ok());
  EXPECT_TRUE(fs::is_symlink(file_of("first.wwb")));
  EXPECT_TRUE(fs::is_symlink(file_of("saves/second.wwb")));
  EXPECT_EQ(read(file_of("saves/a.wwb")), saved_world::bytes_of(small_contents()));
}

TEST_F(WorldFile, IsNotWrittenIfTheLinksHaveNoEnd) {
  fs::create_symlink("loop.wwb", file_of("loop.wwb"));
  const auto saved = save_world_file(world_of(small_contents()), file_of("loop.wwb"));
  ASSERT_FALSE(saved.ok());
  EXPECT_EQ(saved.error().code, ErrorCode::unwritable);
  EXPECT_TRUE(fs::is_symlink(file_of("loop.wwb")));
}

TEST_F(WorldFile, DoesNotUseATemporaryFileOfSomeoneElse) {
  write(file_of("a.wwb.tmp0"), "precious");
  ASSERT_TRUE(save_world_file(world_of(small_contents()), file_of("a.wwb")).ok());
  EXPECT_EQ(read(file_of("a.wwb.tmp0")), "precious");
  EXPECT_EQ(file_count(), 2U);
}

TEST_F(WorldFile, IsNotWrittenWhereNoFileCanBe) {
  fs::create_directories(file_of("folder"));
  for (const std::string& name :
       {file_of("folder"), file_of("missing/a.wwb"), std::string(), file_of(std::string(300, 'a'))}) {
    const Result<void> saved = save_world_file(world_of(small_contents()), name);
    ASSERT_FALSE(saved.ok()) << name;
    EXPECT_EQ(saved.error().code, ErrorCode::unwritable);
    EXPECT_EQ(saved.error().message().rfind(name + ": cannot be written: ", 0), 0U) << saved.error().message();
  }
  EXPECT_EQ(file_count(), 1U);
}

/// While the object lives, this process cannot write files beyond a size, as on a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(std::size_t size) {
    old_handler_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &old_);
    rlimit limit = old_;
    limit.rlim_cur = size;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, old_handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit old_{};
  void (*old_handler_)(int) = nullptr;
};

TEST_F(WorldFile, StaysAsItWasIfTheNewOneCannotBeWritten) {
  const std::string name = file_of("a.wwb");
  write(name, "old");
  World large = world_of(small_contents());
  std::vector<Point> points;
  for (int i = 0; i < 9000; ++i) points.push_back({i / 1024.0, 5.0});
  large.insert_points(points, 1000).value();
  for (const std::size_t size : {0U, 1U, 100U, 4096U, 70000U, 140000U}) {
    Result<void> saved;
    {
      const FileSizeLimit limit(size);
      saved = save_world_file(large, name);
    }
    ASSERT_FALSE(saved.ok()) << size;
    EXPECT_EQ(saved.error().code, ErrorCode::unwritable);
    EXPECT_EQ(saved.error().message().rfind(name + ": cannot be written: ", 0), 0U) << saved.error().message();
    EXPECT_EQ(read(name), "old");
    EXPECT_EQ(file_count(), 1U);
  }
}

TEST_F(WorldFile, WithAFaultIsRefusedByName) {
  const std::string bytes = saved_world::bytes_of(small_contents());
  const auto expect = [&](const std::string& name, ErrorCode code, const std::string& text) {
    const Result<World> world = load_world_file(name);
    ASSERT_FALSE(world.ok());
    EXPECT_EQ(world.error().code, code);
    EXPECT_EQ(world.error().message().rfind(name + ": " + text, 0), 0U) << world.error().message();
  };
  const std::string name = file_of("a.wwb");
  expect(name, ErrorCode::unreadable, "cannot be read: ");
  fs::create_directories(file_of("folder"));
  expect(file_of("folder"), ErrorCode::unreadable, "cannot be read: ");
  write(name, "");
  expect(name, ErrorCode::malformed, "byte 0: expected more bytes");
  write(name, bytes.substr(0, 100));
  expect(name, ErrorCode::malformed, "byte 100: expected more bytes");
  write(name, bytes + "x");
  expect(name, ErrorCode::malformed, "there are more bytes");
}

}  // namespace
}  // namespace waywright::test
