#pragma once

namespace waywright::bench {

// Each function registers its benchmarks; main() calls them before it runs any.

/// Experiments 2 and 3: the strategies of the thesis for the start of a walk, and the library's.
void register_location();

/// Experiments 4, 5 and 6: the same updates under four arithmetics.
void register_arithmetic();

}  // namespace waywright::bench
