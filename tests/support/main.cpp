#include <csignal>
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

// The function `main` of the test programs. Each runs many tests and prints only those that fail (GTEST_BRIEF). So if a
// test ends the program, this code says which test that was.

namespace {

std::string& running_test() {
  static std::string name;
  return name;
}

class NamesRunningTest : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo& test) override {
    running_test() = std::string(test.test_suite_name()) + '.' + test.name();
  }
};

extern "C" void say_which_test(int signal) {
  if (!testing::internal::InDeathTestChild()) {
    std::fprintf(stderr, "\nThe program ended in the test %s\n", running_test().c_str());
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  testing::UnitTest::GetInstance()->listeners().Append(new NamesRunningTest);
  running_test() = "(none)";
  std::signal(SIGABRT, say_which_test);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  for (const int signal : {SIGSEGV, SIGFPE, SIGILL}) std::signal(signal, say_which_test);
#endif
  return RUN_ALL_TESTS();
}
