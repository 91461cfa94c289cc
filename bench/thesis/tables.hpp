#pragma once

#include <cstddef>

namespace waywright::bench {

// The experiments of Chen 2009 that count. Each prints a Markdown table.

/// Experiment 1, Table 5.1: how often the in-circle test is wrong about four nearly cocircular points, `trials` of them
/// a row.
void print_in_circle_table(std::size_t trials);

/// What comes of many small scenes full of degeneracies under each arithmetic.
void print_survival_table(std::size_t scenes);

/// Experiment 5, Table 5.2: how often each kind of arithmetic is asked for random constraints.
void print_evaluations_table();

}  // namespace waywright::bench
