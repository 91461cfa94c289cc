#pragma once

#include <string_view>

namespace waywright::io {

/// Whether a `.poly` text counts 0 vertices, and so takes them from the `.node` file of the same name.
[[nodiscard]] bool lacks_vertices(std::string_view poly_text);

}  // namespace waywright::io
