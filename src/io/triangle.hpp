#pragma once

#include <string_view>

namespace waywright::io {

/// Returns whether a `.poly` text counts 0 vertices. Its vertices are then in the `.node` file of the same name.
[[nodiscard]] bool lacks_vertices(std::string_view poly_text);

}  // namespace waywright::io
