#pragma once

#include <string>
#include <string_view>

namespace waywright::formats {

/// Returns the text as a JSON string, in quotes. Replaces bytes that are not UTF-8.
[[nodiscard]] std::string json_string(std::string_view text);

}  // namespace waywright::formats
