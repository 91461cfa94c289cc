#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "waywright/scene.hpp"

#include "crowds/game.hpp"

namespace waywright::bench {
namespace {

constexpr std::size_t kWarmUp = 5;  // ticks before the first one that is printed
constexpr const char* kUsage = "usage: waywright_crowds MAP MODE TICKS RADIUS...\n";

/// Prints a line for a tick: the update in seconds; the searches of each radius in seconds; their numbers; how many
/// units have each status.
void print_tick(const Tick& tick) {
  std::printf("%.9f", tick.update_seconds);
  for (const double seconds : tick.path_seconds) std::printf("\t%.9f", seconds);
  for (const std::size_t count : tick.searches) std::printf("\t%zu", count);
  for (const std::size_t count : tick.statuses) std::printf("\t%zu", count);
  std::printf("\n");
  std::fflush(stdout);
}

int fail(const std::string& message) {
  std::fprintf(stderr, "waywright_crowds: %s\n", message.c_str());
  return 1;
}

int run(const std::string& map, CrowdMode mode, std::size_t ticks, const std::vector<double>& radii) {
  const Result<Scene> scene = read_scene(map);
  if (!scene.ok()) return fail(scene.error().message());
  Game game(*scene, radii, mode);
  for (std::size_t i = 0; i < kWarmUp; ++i) static_cast<void>(game.play());
  std::printf("%zu\n", game.world().vertex_count());
  for (std::size_t i = 0; i < ticks; ++i) {
    print_tick(game.play());
    const std::size_t wrong = game.count_wrong_answers();
    if (wrong != 0) return fail("tick " + std::to_string(i) + ": " + std::to_string(wrong) + " wrong answers");
  }
  return 0;
}

}  // namespace
}  // namespace waywright::bench

// Prints the number of vertices of the world with its buildings, then a line for each tick. See print_tick().
// scripts/crowds.py runs this program and prints tables.
int main(int argc, char** argv) {
  const auto mode = argc > 2 ? waywright::bench::crowd_mode(argv[2]) : std::nullopt;
  std::vector<double> radii;
  for (int i = 4; i < argc; ++i) radii.push_back(std::strtod(argv[i], nullptr));
  if (!mode || radii.empty()) {
    std::fputs(waywright::bench::kUsage, stderr);
    return 2;
  }
  return waywright::bench::run(argv[1], *mode, std::strtoull(argv[3], nullptr, 10), radii);
}
