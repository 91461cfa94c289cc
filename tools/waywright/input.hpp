#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "waywright/point.hpp"
#include "waywright/scene.hpp"
#include "waywright/script.hpp"
#include "waywright/world.hpp"

#include "file_names.hpp"

namespace waywright::command {

/// All of a file, or of standard input where `name` is `-`. Throws Failure.
[[nodiscard]] std::string read_text(const std::string& name);

/// A world script from a file, or from standard input where `name` is `-`. Throws Failure.
[[nodiscard]] Script load_script(const std::string& name);

/// A scene from a file, whose ending tells its format; from a world script on standard input where `name` is `-`.
/// Throws Failure.
[[nodiscard]] Scene load_scene(const std::string& name);

/// The world of a scene's items. Items that the world refuses are left out, and one line on standard error says so.
/// Throws Failure where the domain is refused.
[[nodiscard]] World build_world(const Scene& scene, const std::string& name);

/// The files that load_scene reads; the second may be missing.
[[nodiscard]] std::vector<NamedFile> files_of_map(const std::string& name);

/// The point that the two values of an option give. Throws Failure.
[[nodiscard]] Point parse_point(std::string_view option, const std::vector<std::string>& values);

/// A file's name without its folders: what pictures are titled with.
[[nodiscard]] std::string title_of(const std::string& name);

}  // namespace waywright::command
