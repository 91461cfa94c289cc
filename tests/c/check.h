/* The checks of the tests in C. A check that fails prints its file and line, and is counted. */
#ifndef WAYWRIGHT_TESTS_C_CHECK_H
#define WAYWRIGHT_TESTS_C_CHECK_H

#include <stdio.h>
#include <waywright.h>

extern int failed_checks;

#define CHECK(condition)                                                         \
  do {                                                                           \
    if (!(condition)) {                                                          \
      fprintf(stderr, "%s:%d: '%s' is false\n", __FILE__, __LINE__, #condition); \
      ++failed_checks;                                                           \
    }                                                                            \
  } while (0)

/* Checks a status, and prints the message of another one. */
#define CHECK_STATUS(call, expected) check_status((call), (expected), #call, __FILE__, __LINE__)
#define CHECK_OK(call) CHECK_STATUS(call, WW_OK)

void check_status(ww_status actual, ww_status expected, const char* call, const char* file, int line);
/* Prints how many checks have failed. Returns the exit status of the program. */
int result_of_checks(void);

#endif
