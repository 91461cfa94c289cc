#pragma once

#include <cstdint>
#include <string_view>

namespace waywright::io {

/// The checksum CRC-32C of bytes that come in pieces. It detects every change of up to 32 consecutive bits. Source:
/// Castagnoli, Bräuer and Herrmann, *Optimization of cyclic redundancy-check codes with 24 and 32 parity bits*, IEEE
/// Transactions on Communications 41, 1993.
class Crc32c {
 public:
  /// Adds bytes. Cost: linear; about one byte in each nanosecond or faster. Source: Kounavis and Berry, *A systematic
  /// approach to building high performance software-based CRC generators*, ISCC 2005 (eight bytes in one step).
  void add(std::string_view bytes);
  [[nodiscard]] std::uint32_t value() const { return ~state_; }

 private:
  std::uint32_t state_ = 0xffffffff;
};

}  // namespace waywright::io
