#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include "waywright/scene.hpp"

#include "support/scene_check.hpp"

namespace waywright::test {
namespace {

/// Removes smaller and smaller runs of items, as long as the check still fails.
void shrink_items(Scene& scene, const SceneCheck& check) {
  for (std::size_t run = scene.items.size(); run > 0; run /= 2) {
    for (std::size_t first = 0; first < scene.items.size();) {
      Scene less = scene;
      const std::size_t last = std::min(first + run, less.items.size());
      less.items.erase(less.items.begin() + static_cast<std::ptrdiff_t>(first),
                       less.items.begin() + static_cast<std::ptrdiff_t>(last));
      if (check(less).fault) {
        scene = std::move(less);
      } else {
        first += run;
      }
    }
  }
}

void shrink_points(Scene& scene, const SceneCheck& check) {
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    const auto fixed = scene.items[i].shape.kind == ItemKind::point || scene.items[i].shape.kind == ItemKind::segment;
    if (fixed) continue;
    for (std::size_t r = 0; r < scene.items[i].shape.rings.size(); ++r) {
      for (std::size_t p = 0; p < scene.items[i].shape.rings[r].size();) {
        Scene less = scene;
        std::vector<std::vector<Point>> rings = less.items[i].shape.rings;
        rings[r].erase(rings[r].begin() + static_cast<std::ptrdiff_t>(p));
        if (rings[r].empty()) rings.erase(rings.begin() + static_cast<std::ptrdiff_t>(r));
        less.items[i].shape.rings = rings;
        if (rings.empty() || !check(less).fault) {
          ++p;
          continue;
        }
        scene = std::move(less);
        if (r >= scene.items[i].shape.rings.size()) break;
      }
    }
  }
}

}  // namespace

Scene shrink(Scene scene, const SceneCheck& check) {
  shrink_items(scene, check);
  shrink_points(scene, check);
  return scene;
}

std::string report_failure(const Scene& scene, const std::string& name, const SceneCheck& check) {
  const Scene small = shrink(scene, check);
  const std::string script = to_script(small);
  const auto file = std::filesystem::temp_directory_path() / ("waywright-" + name + ".wws");
  std::ofstream(file, std::ios::binary) << script;
  const auto fault = check(small).fault;
  return name + ": " + (fault ? *fault : "fails now and then") + "\nshrunk to " + std::to_string(small.items.size()) +
         " items, " + file.string() + ":\n" + script;
}

}  // namespace waywright::test
