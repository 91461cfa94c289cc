#pragma once

#include <optional>
#include <string>
#include <vector>

#include "waywright/point.hpp"

#include "workloads.hpp"

namespace waywright::bench {

/// A query whose shortest path another program has found.
struct KnownPath {
  Point start;
  Point goal;
  double length = 0.0;
};

/// Returns the folder of real inputs: $WAYWRIGHT_DATA, or `../shared/data` beside the project.
[[nodiscard]] std::string data_folder();

/// Returns the scenes that map benchmarks build, relative to data_folder().
[[nodiscard]] const std::vector<std::string>& real_scene_files();

/// Returns the scene's items as insertions, or nothing if the file is absent or is not a scene. Reads footprints of
/// SUMO (`.poly.xml`), whose coordinates are hundredths, as whole numbers.
[[nodiscard]] std::optional<Workload> read_real_scene(const std::string& file);

/// Returns the queries of a MovingAI scenario with Euclidean lengths, or nothing if the file is absent.
[[nodiscard]] std::optional<std::vector<KnownPath>> read_known_paths(const std::string& file);

}  // namespace waywright::bench
