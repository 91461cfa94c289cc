// Writes the changes of the 200 worlds of tests/determinism as JSON, one world a line, for the tests of the npm
// package. Coordinates are the hexadecimal digits of the bits of doubles.
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <string>
#include <string_view>

#include "base/compiler.hpp"
#include "support/random_changes.hpp"

namespace waywright::test {
namespace {

// The same numbers as in tests/determinism/print_meshes.cpp.
constexpr std::uint64_t kScriptsOfFlavour = 40;
constexpr std::size_t kSteps = 60;
constexpr std::size_t kLiveItems = 25;

void print_bits(double value) {
  constexpr std::string_view kHex = "0123456789abcdef";
  const auto bits = base::bit_cast<std::uint64_t>(value);
  for (int shift = 60; shift >= 0; shift -= 4) std::cout << kHex[static_cast<std::size_t>(bits >> shift & 0xf)];
}

void print_point(const Point& point) {
  print_bits(point.x);
  print_bits(point.y);
}

void print_shape(const Shape& shape) {
  std::cout << R"(,"shape":")" << to_string(shape.kind) << R"(","fill":")" << to_string(shape.fill) << R"(","rings":[)";
  const char* separator = "";
  for (const PointSpan ring : shape.rings) {
    std::cout << separator << ring.size();
    separator = ",";
  }
  std::cout << R"(],"points":")";
  for (const Point& point : shape.rings.points()) print_point(point);
  std::cout << '"';
}

void print_change(const Change& change) {
  constexpr std::string_view kKinds[] = {"insert", "remove", "replace"};
  std::cout << R"({"kind":")" << kKinds[static_cast<std::size_t>(change.kind)] << R"(","id":")" << change.id.value
            << '"';
  if (change.kind != Change::Kind::remove) print_shape(change.shape);
  std::cout << '}';
}

void print_step(const Step& step) {
  std::cout << R"({"batch":)" << (step.is_batch ? "true" : "false") << R"(,"changes":[)";
  for (std::size_t i = 0; i < step.changes.size(); ++i) {
    if (i > 0) std::cout << ',';
    print_change(step.changes[i]);
  }
  std::cout << "]}";
}

void print_world(Flavour flavour, std::uint64_t seed) {
  const ChangeScript script = random_changes(flavour, seed, kSteps, kLiveItems);
  std::cout << R"({"flavour":")" << to_string(flavour) << R"(","seed":)" << seed << R"(,"domain":")";
  print_point(script.domain.min);
  print_point(script.domain.max);
  std::cout << R"(","steps":[)";
  for (std::size_t i = 0; i < script.steps.size(); ++i) {
    if (i > 0) std::cout << ',';
    print_step(script.steps[i]);
  }
  std::cout << "]}\n";
}

}  // namespace
}  // namespace waywright::test

int main() {
  for (const waywright::test::Flavour flavour : waywright::test::kFlavours) {
    for (std::uint64_t seed = 0; seed < waywright::test::kScriptsOfFlavour; ++seed) {
      waywright::test::print_world(flavour, seed);
    }
  }
  std::cout.flush();
  return std::cout.good() ? 0 : 1;
}
