#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/parse_bodies.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  waywright::test::stop_at(waywright::test::fault_of_saved_world(bytes));
  return 0;
}
