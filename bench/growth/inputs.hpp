#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace waywright::bench {

/// Measures the time of a run from start() to stop(). Everything before start() makes the world.
class Meter {
 public:
  /// Where the process ends.
  enum class End { after_run, at_start, at_stop };

  explicit Meter(End end) : end_(end) {}
  void start();
  void stop();
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  End end_;
  double started_ = 0.0;
  double seconds_ = 0.0;
};

/// An input whose cost once grew faster than its size, or could do so.
struct Input {
  std::string_view name;
  std::size_t size;       ///< the smallest n of the table
  bool is_one_operation;  ///< the run repeats one operation a fixed number of times in a world of size n
  std::string_view what;
  void (*run)(std::size_t n, Meter& meter);
};

/// The inputs of inputs.cpp, in the order of the table.
[[nodiscard]] std::span<const Input> growth_inputs();
/// The inputs of bridge_inputs.cpp, which follow in the table: worlds with bridges.
[[nodiscard]] std::span<const Input> bridge_inputs();

}  // namespace waywright::bench
