#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "waywright/scene.hpp"

#include "support/random_scenes.hpp"

namespace waywright::test {

/// What checking a world found: the body that the property tests and the soak share.
struct SceneReport {
  std::optional<std::string> fault;  ///< the first
  std::size_t operations = 0;        ///< insertions, refused ones too, and queries
  std::size_t vertices = 0;          ///< of the finished mesh
};

/// Builds the scene's world item by item and holds it against the oracle: validate() after every insertion; the dump
/// and the snapshot of the finished mesh; locations of random points, corners and middles of sides; refused insertions
/// change nothing; another order of the items gives the same dump. All that is random follows from the seed.
[[nodiscard]] SceneReport check_scene(const Scene& scene, Flavour flavour, std::uint64_t seed);

using SceneCheck = std::function<SceneReport(const Scene&)>;

/// The scene less all items and points that it can do without and still fail the check.
[[nodiscard]] Scene shrink(Scene scene, const SceneCheck& check);

/// Shrinks a scene that fails a check and writes it as a world script into the folder for temporary files. Returns a
/// message with the fault, the file's name and the script.
[[nodiscard]] std::string report_failure(const Scene& scene, const std::string& name, const SceneCheck& check);

}  // namespace waywright::test
