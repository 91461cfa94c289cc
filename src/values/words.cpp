#include <cstdint>
#include <string>
#include <string_view>

#include "waywright/hashes.hpp"
#include "waywright/location.hpp"

namespace waywright {

std::string_view to_string(LocationKind kind) {
  switch (kind) {
    case LocationKind::vertex:
      return "vertex";
    case LocationKind::edge:
      return "edge";
    case LocationKind::face:
      return "face";
  }
  return "unknown";
}

namespace {

std::string hexadecimal(std::uint64_t value, int digits) {
  std::string text;
  for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) text += "0123456789abcdef"[value >> shift & 0xf];
  return text;
}

}  // namespace

std::string to_string(const ItemsHash& hash) { return hexadecimal(hash.words[0], 16) + hexadecimal(hash.words[1], 16); }

std::string to_string(const MeshHash& hash) {
  std::string text;
  for (const std::uint8_t byte : hash.bytes) text += hexadecimal(byte, 2);
  return text;
}

}  // namespace waywright
