#pragma once

#include <optional>
#include <string>
#include <vector>

#include "waywright/point.hpp"

#include "workloads.hpp"

namespace waywright::bench {

/// A path that somebody else found to be shortest.
struct KnownPath {
  Point start;
  Point goal;
  double length = 0.0;
};

/// The folder of real inputs: $WAYWRIGHT_DATA, or `../shared/data` beside the project.
[[nodiscard]] std::string data_folder();

/// The scenes that map benchmarks build, under data_folder().
[[nodiscard]] const std::vector<std::string>& real_scene_files();

/// The scene's items as insertions; nothing where the file is absent or no scene. Footprints of SUMO (`.poly.xml`),
/// whose coordinates are hundredths, are taken as whole numbers.
[[nodiscard]] std::optional<Workload> read_real_scene(const std::string& file);

/// The queries of a scenario of MovingAI whose lengths are Euclidean; nothing where the file is absent.
[[nodiscard]] std::optional<std::vector<KnownPath>> read_known_paths(const std::string& file);

}  // namespace waywright::bench
