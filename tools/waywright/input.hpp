#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "waywright/point.hpp"
#include "waywright/scene.hpp"
#include "waywright/world.hpp"

namespace waywright::command {

/// All of a file, or of standard input where `name` is `-`. Throws Failure.
[[nodiscard]] std::string read_text(const std::string& name);

/// A scene from a file. Throws Failure.
[[nodiscard]] Scene load_scene(const std::string& name);

/// The world of a scene's items. Items that the world refuses are left out, and one line on standard error says so.
/// Throws Failure where the domain is refused.
[[nodiscard]] World build_world(const Scene& scene, const std::string& name);

/// The point that the two values of an option give. Throws Failure.
[[nodiscard]] Point parse_point(std::string_view option, const std::vector<std::string>& values);

/// A file's name without its folders: what pictures are titled with.
[[nodiscard]] std::string title_of(const std::string& name);

}  // namespace waywright::command
