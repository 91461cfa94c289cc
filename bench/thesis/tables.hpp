#pragma once

#include <cstddef>

namespace waywright::bench {

// The experiments of Chen 2009 that count events. Each prints a Markdown table.

/// Experiment 1, Table 5.1: how often the in-circle test gives a wrong result for four nearly cocircular points, with
/// `trials` tests in each row.
void print_in_circle_table(std::size_t trials);

/// Prints the results of many small scenes full of degeneracies under each arithmetic.
void print_survival_table(std::size_t scenes);

/// Experiment 5, Table 5.2: how often each kind of arithmetic answers a question for random constraints.
void print_evaluations_table();

}  // namespace waywright::bench
