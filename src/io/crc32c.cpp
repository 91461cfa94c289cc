#include "io/crc32c.hpp"

#include <array>
#include <cstddef>

namespace waywright::io {

namespace {

constexpr std::size_t kStep = 8;
using Table = std::array<std::uint32_t, 256>;

/// Returns the tables: in table i, the entry of a byte is the effect of this byte, followed by i zero bytes.
constexpr std::array<Table, kStep> make_tables() {
  constexpr std::uint32_t kReversedPolynomial = 0x82f63b78;
  std::array<Table, kStep> tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t state = byte;
    for (int bit = 0; bit < 8; ++bit) state = (state >> 1) ^ ((state & 1) != 0 ? kReversedPolynomial : 0);
    tables[0][byte] = state;
  }
  for (std::size_t i = 1; i < kStep; ++i) {
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t before = tables[i - 1][byte];
      tables[i][byte] = (before >> 8) ^ tables[0][before & 0xff];
    }
  }
  return tables;
}

constexpr std::array<Table, kStep> kTables = make_tables();

}  // namespace

void Crc32c::add(std::string_view bytes) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])); };
  std::uint32_t state = state_;
  while (bytes.size() >= kStep) {
    state ^= byte(0) | byte(1) << 8 | byte(2) << 16 | byte(3) << 24;
    state = kTables[7][state & 0xff] ^ kTables[6][state >> 8 & 0xff] ^ kTables[5][state >> 16 & 0xff] ^
            kTables[4][state >> 24] ^ kTables[3][byte(4)] ^ kTables[2][byte(5)] ^ kTables[1][byte(6)] ^
            kTables[0][byte(7)];
    bytes.remove_prefix(kStep);
  }
  for (std::size_t i = 0; i < bytes.size(); ++i) state = (state >> 8) ^ kTables[0][(state ^ byte(i)) & 0xff];
  state_ = state;
}

}  // namespace waywright::io
