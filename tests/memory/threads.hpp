#pragma once

namespace waywright::test {

/// Whether a program that links threads.cpp gets no threads from now on, as from a system that has none left.
void refuse_threads(bool refuse);

}  // namespace waywright::test
