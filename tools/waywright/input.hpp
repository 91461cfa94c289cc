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

/// Reads a whole file, or standard input if `name` is `-`. Throws Failure.
[[nodiscard]] std::string read_text(const std::string& name);

/// Reads a world script from a file, or from standard input if `name` is `-`. Throws Failure.
[[nodiscard]] Script load_script(const std::string& name);

/// Reads a scene from a file: a saved world, or another format that the ending of the name tells. If `name` is `-`,
/// reads a saved world or a world script from standard input. Throws Failure.
[[nodiscard]] Scene load_scene(const std::string& name);

/// Reads the same inputs as load_scene(). A saved world keeps its options and its next id. Throws Failure.
[[nodiscard]] World load_world(const std::string& name);

/// Builds a world from the items of a scene, for agents of a radius: with a radius above 0 the world keeps its bridges.
/// Leaves out items that the world refuses, and reports this in one line on standard error. Throws Failure if the world
/// refuses the domain.
[[nodiscard]] World build_world(const Scene& scene, const std::string& name, double radius);

/// Returns the names of the files that load_scene() reads. The second one may be missing.
[[nodiscard]] std::vector<NamedFile> files_of_map(const std::string& name);

/// Returns the point in the two values of an option. Throws Failure.
[[nodiscard]] Point parse_point(std::string_view option, const std::vector<std::string>& values);

/// Returns the radius in the value of the option `--radius`. Throws Failure unless it is a number of 0 or more.
[[nodiscard]] double parse_radius(const std::string& value);

/// Returns the name of a file without its folders. It is the title of pictures.
[[nodiscard]] std::string title_of(const std::string& name);

}  // namespace waywright::command
