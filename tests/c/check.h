/* The smallest test frame that serves: checks that print where they fail and count. */
#ifndef WAYWRIGHT_TESTS_C_CHECK_H
#define WAYWRIGHT_TESTS_C_CHECK_H

#include <stdio.h>

static int failed_checks = 0;

#define CHECK(condition)                                                          \
  do {                                                                            \
    if (!(condition)) {                                                           \
      fprintf(stderr, "%s:%d: '%s' is false\n", __FILE__, __LINE__, #condition);  \
      ++failed_checks;                                                            \
    }                                                                             \
  } while (0)

/* Checks a status, and prints the message of another one. */
#define CHECK_STATUS(call, expected) check_status((call), (expected), #call, __FILE__, __LINE__)
#define CHECK_OK(call) CHECK_STATUS(call, WW_OK)

static void check_status(ww_status actual, ww_status expected, const char* call, const char* file, int line) {
  char message[256] = "";
  if (actual == expected) return;
  ww_last_error_message(message, sizeof message, NULL);
  fprintf(stderr, "%s:%d: %s returned %s, not %s: %s\n", file, line, call, ww_status_name(actual),
          ww_status_name(expected), message);
  ++failed_checks;
}

static int result_of_checks(void) {
  if (failed_checks != 0) fprintf(stderr, "%d checks failed\n", failed_checks);
  return failed_checks == 0 ? 0 : 1;
}

#endif
