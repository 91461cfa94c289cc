#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace waywright::text {

/// Returns the SHA-256 digest of the bytes. Source: NIST, FIPS 180-4, *Secure Hash Standard*, 2015.
[[nodiscard]] std::array<std::uint8_t, 32> sha256(std::string_view bytes);

}  // namespace waywright::text
