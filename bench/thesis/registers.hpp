#pragma once

namespace waywright::bench {

// Each adds its benchmarks; main() calls them before it runs any.

/// Experiments 2 and 3: the thesis' ways to start a walk, and ours.
void register_location();

/// Experiments 4, 5 and 6: the same updates under four arithmetics.
void register_arithmetic();

}  // namespace waywright::bench
