#pragma once

namespace waywright::test {

/// Sets whether the creation of threads fails from now on, as on a system that has no threads left. Requires: the
/// program links threads.cpp.
void refuse_threads(bool refuse);

}  // namespace waywright::test
