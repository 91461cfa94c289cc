#include <algorithm>
#include <bit>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>
#include <waywright/waywright.hpp>

/// usage: run_scripts FOLDER...
/// Runs the world scripts in the folders and prints all results, with the bits of each number. A build with hostile
/// flags must print the same as an ordinary build. This file itself is compiled with the hostile flags.
namespace {

using namespace waywright;

void print(double value) { std::printf(" %016" PRIx64, std::bit_cast<std::uint64_t>(value)); }
void print(const Point& point) {
  print(point.x);
  print(point.y);
}

void print(const Result<Path>& path) {
  if (!path) return void(std::printf(" %s", std::string(to_string(path.error().code)).c_str()));
  std::printf(" %s %zu", std::string(to_string(path->status)).c_str(), path->expansions);
  print(path->length);
  print(path->lower_bound);
  for (const Point& point : path->points) print(point);
}

void print_insertion(World& world, const Item& item) {
  const Result<ItemId> inserted = world.insert(item.shape, item.id);
  if (inserted) {
    std::printf(" %" PRIu64, inserted->value);
  } else {
    std::printf(" %s", std::string(to_string(inserted.error().code)).c_str());
  }
}

void perform(World& world, const ScriptLine& operation) {
  std::printf("%s", std::string(to_string(operation)).c_str());
  switch (operation.kind) {
    case ScriptLineKind::insert:
      print_insertion(world, operation.item);
      break;
    case ScriptLineKind::remove:
      std::printf(" %d", world.remove(operation.item.id).ok());
      break;
    case ScriptLineKind::locate:
      if (const auto location = world.locate(operation.from)) print(location->vertices[0]);
      break;
    case ScriptLineKind::ray:
      if (const auto hit = world.ray(operation.from, operation.to)) print(hit->at);
      break;
    case ScriptLineKind::path:
      print(world.find_path({.start = operation.from,
                             .goal = operation.to,
                             .algorithm = operation.algorithm.value_or(PathAlgorithm::optimal)}));
      break;
    default:
      break;
  }
  std::printf(" %s %s\n", to_string(world.items_hash()).c_str(), to_string(world.mesh_hash()).c_str());
}

bool run(const std::filesystem::path& file) {
  std::ifstream in(file);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const Result<Script> script = parse_script(text, file.filename().string());
  if (!script) return std::fprintf(stderr, "%s\n", script.error().message().c_str()), false;
  World world = World::create(script->domain).value();
  std::printf("script %s\n", file.filename().string().c_str());
  for (const ScriptLine& operation : script->lines) perform(world, operation);
  std::printf("%s%s", world.validate().fault.c_str(), world.dump().c_str());
  return true;
}

}  // namespace

int main(int count, char** arguments) {
  std::vector<std::filesystem::path> files;
  for (int i = 1; i < count; ++i) {
    for (const auto& entry : std::filesystem::directory_iterator(arguments[i])) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.filename() < b.filename(); });
  if (files.empty()) return 1;
  for (const std::filesystem::path& file : files) {
    if (!run(file)) return 1;
  }
  return std::fflush(stdout) == 0 ? 0 : 1;
}
