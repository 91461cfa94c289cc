#pragma once

#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "support/case_count.hpp"
#include "support/random_changes.hpp"

namespace waywright::test {

/// Calls `check(flavour, seed)` for case_count() seeds of each flavour of random changes, until one of the calls fails.
template <class Check>
void check_each_flavour(Check&& check) {
  for (const Flavour flavour : kFlavours) {
    for (std::uint64_t seed = 1; seed <= case_count(); ++seed) {
      SCOPED_TRACE(std::string(to_string(flavour)) + ", seed " + std::to_string(seed));
      ASSERT_NO_FATAL_FAILURE(check(flavour, seed));
    }
  }
}

}  // namespace waywright::test
