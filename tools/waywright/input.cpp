#include "input.hpp"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include "waywright/error.hpp"

#include "base/number_text.hpp"
#include "failure.hpp"
#include "progress.hpp"

namespace waywright::command {

namespace {

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

std::string read_all(std::FILE* file, const std::string& name) {
  std::string text;
  std::array<char, 1 << 16> chunk{};
  while (const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), file)) text.append(chunk.data(), count);
  if (std::ferror(file) != 0) throw Failure(fmt::format("{}: cannot be read: {}", name, std::strerror(errno)));
  return text;
}

double parse_number(std::string_view option, const std::string& word) {
  double value = 0.0;
  const char* const end = word.data() + word.size();
  const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  const auto [stop, fault] = base::read_double(word.data() + (plus ? 1 : 0), end, value);
  if (stop != end || fault != std::errc{}) {
    throw Failure(fmt::format("waywright: {}: '{}' is not a number that fits a double", option, word));
  }
  return value;
}

}  // namespace

std::string read_text(const std::string& name) {
  if (name == "-") return read_all(stdin, name);
  const std::unique_ptr<std::FILE, Closer> file(std::fopen(name.c_str(), "rb"));
  if (!file) throw Failure(fmt::format("{}: cannot be read: {}", name, std::strerror(errno)));
  return read_all(file.get(), name);
}

Scene load_scene(const std::string& name) {
  Result<Scene> scene = read_scene(name);
  if (!scene.ok()) throw Failure(scene.error().message);
  return std::move(scene).value();
}

World build_world(const Scene& scene, const std::string& name) {
  Result<World> created = World::create(scene.domain);
  if (!created.ok()) throw Failure(fmt::format("{}: {}", name, created.error().message));
  World world = std::move(created).value();
  Progress progress("insert");
  const auto show = [&](std::size_t done, std::size_t total) { progress.show(done, total); };
  if (world.insert_all(scene.items, {.threads = 1, .progress = show}).ok()) return world;
  // Some are refused: one by one, the others come in all the same.
  std::size_t left_out = 0;
  std::size_t done = 0;
  std::string first_reason;
  for (const Item& item : scene.items) {
    progress.show(done++, scene.items.size());
    const Result<ItemId> inserted = world.insert(item.shape, item.id);
    if (inserted.ok()) continue;
    if (left_out++ == 0) first_reason = fmt::format("item {}: {}", item.id.value, inserted.error().message);
  }
  progress.finish();
  if (left_out > 0) fmt::print(stderr, "{}: left out {} of the items, the first: {}\n", name, left_out, first_reason);
  return world;
}

Point parse_point(std::string_view option, const std::vector<std::string>& values) {
  return {parse_number(option, values.at(0)), parse_number(option, values.at(1))};
}

std::string title_of(const std::string& name) {
  return name == "-" ? "standard input" : std::filesystem::path(name).filename().string();
}

}  // namespace waywright::command
