#include "check.h"

#include <stddef.h>

int failed_checks = 0;

void check_status(ww_status actual, ww_status expected, const char* call, const char* file, int line) {
  char message[256] = "";
  if (actual == expected) return;
  ww_last_error_message(message, sizeof message, NULL);
  fprintf(stderr, "%s:%d: %s returned %s, not %s: %s\n", file, line, call, ww_status_name(actual),
          ww_status_name(expected), message);
  ++failed_checks;
}

int result_of_checks(void) {
  if (failed_checks != 0) fprintf(stderr, "%d checks failed\n", failed_checks);
  return failed_checks == 0 ? 0 : 1;
}
