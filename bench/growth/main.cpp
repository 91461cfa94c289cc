#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "growth/inputs.hpp"

// usage: waywright_growth              prints a line for each input: its name, smallest n, kind and description
//        waywright_growth NAME N       runs an input and prints the processor time of its measured part in seconds
//        waywright_growth NAME N start runs an input until its measured part starts, and prints nothing
//        waywright_growth NAME N stop  runs an input until its measured part stops, and prints nothing
int main(int argc, char** argv) {
  using End = waywright::bench::Meter::End;
  std::vector<waywright::bench::Input> inputs;
  for (const auto& part : {waywright::bench::growth_inputs(), waywright::bench::bridge_inputs()}) {
    inputs.insert(inputs.end(), part.begin(), part.end());
  }
  if (argc == 1) {
    for (const auto& input : inputs) {
      std::printf("%.*s\t%zu\t%s\t%.*s\n", static_cast<int>(input.name.size()), input.name.data(), input.size,
                  input.is_one_operation ? "operation" : "all", static_cast<int>(input.what.size()), input.what.data());
    }
    return 0;
  }
  for (const auto& input : inputs) {
    if (argc < 3 || input.name != std::string_view(argv[1])) continue;
    const std::string_view end = argc == 4 ? argv[3] : "";
    waywright::bench::Meter meter(end == "start" ? End::at_start : end == "stop" ? End::at_stop : End::after_run);
    input.run(static_cast<std::size_t>(std::strtoull(argv[2], nullptr, 10)), meter);
    std::printf("%.9f\n", meter.seconds());
    return 0;
  }
  std::fputs("usage: waywright_growth [NAME N [start|stop]]\n", stderr);
  return 2;
}
