#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "support/point_text.hpp"
#include "support/random.hpp"
#include "support/random_changes.hpp"

/// usage: write_scripts FOLDER COUNT
/// Writes COUNT random world scripts of each flavour for run_scripts. The scripts contain path queries.
namespace waywright::test {
namespace {

std::string random_script(Flavour flavour, std::uint64_t seed) {
  const ChangeScript changes = random_changes(flavour, seed, 24, 16);
  std::string text = to_script(changes);
  Random random(seed);
  for (const std::string algorithm : {"optimal", "ta", "tra", "optimal", "ta", "tra"}) {
    const Point from = random_point(flavour, changes.domain, random);
    const Point to = random_point(flavour, changes.domain, random);
    text += "path " + text_of(from) + ' ' + text_of(to) + " 0 " + algorithm + '\n';
    text += "ray " + text_of(from) + ' ' + text_of(to) + "\nlocate " + text_of(from) + '\n';
  }
  return text;
}

}  // namespace
}  // namespace waywright::test

int main(int count, char** arguments) {
  using namespace waywright::test;
  if (count != 3) return 2;
  const std::filesystem::path folder = arguments[1];
  std::filesystem::create_directories(folder);
  for (const Flavour flavour : kFlavours) {
    for (std::uint64_t seed = 0; seed < std::stoull(arguments[2]); ++seed) {
      std::ofstream out(folder / (std::string(to_string(flavour)) + '_' + std::to_string(seed) + ".wws"));
      out << random_script(flavour, seed);
      if (!out.flush()) return 1;
    }
  }
  return 0;
}
