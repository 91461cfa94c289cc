#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "waywright/scene.hpp"

#include "support/random_scenes.hpp"

namespace waywright::test {

/// The result of checking a world. The property tests and the soak use the same check.
struct SceneReport {
  std::optional<std::string> fault;  ///< the first fault
  std::size_t operations = 0;        ///< insertions, also refused ones, and queries
  std::size_t vertices = 0;          ///< of the finished mesh
};

/// Builds the scene's world item by item and compares it with the oracle: validate() after every insertion; the dump
/// and the snapshot of the finished mesh; the locations of random points, corners and midpoints of sides. Also checks
/// that refused insertions change nothing and that another order of the items gives the same dump. The seed determines
/// everything that is random.
[[nodiscard]] SceneReport check_scene(const Scene& scene, Flavour flavour, std::uint64_t seed);

using SceneCheck = std::function<SceneReport(const Scene&)>;

/// Returns the scene without all items and points that are not needed for it to fail the check.
[[nodiscard]] Scene shrink(Scene scene, const SceneCheck& check);

/// Shrinks a scene that fails a check and writes it as a world script into the folder for temporary files. Returns a
/// message with the fault, the file's name and the script.
[[nodiscard]] std::string report_failure(const Scene& scene, const std::string& name, const SceneCheck& check);

}  // namespace waywright::test
