/* The calls whose allocations a test of memory lets fail. */
#ifndef WAYWRIGHT_TESTS_C_MEMORY_CALLS_H
#define WAYWRIGHT_TESTS_C_MEMORY_CALLS_H

#include <stddef.h>

#include "memory_state.h"

/* A call with the objects of a state. Returns the status of the call. */
typedef ww_status (*Call)(State*);

typedef struct Case {
  const char* name;
  Call call;
  int changes_world;
} Case;

extern const Case kCases[];
extern const size_t kCaseCount;

/* Queries that need no memory if their context and their answer have served the same query before. */
extern const Call kWarmQueries[];
extern const size_t kWarmQueryCount;

/* The file that a case writes, in the folder of the build. */
extern const char kFile[];

#endif
