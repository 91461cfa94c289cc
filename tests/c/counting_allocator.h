/* An allocator that counts its blocks, and can refuse memory. */
#ifndef WAYWRIGHT_TESTS_C_COUNTING_ALLOCATOR_H
#define WAYWRIGHT_TESTS_C_COUNTING_ALLOCATOR_H

#include <stddef.h>
#include <waywright.h>

/* The number of blocks that the library holds. */
extern size_t live_blocks;
/* The number of calls of the allocator, and the number of calls that it refused. A test sets both to 0. */
extern size_t allocations;
extern size_t failures;
/* The allocation that fails, counted from 1; 0 for none. If fails_from_then_on is 1, all later ones fail, too. */
extern size_t failing_allocation;
extern int fails_from_then_on;

/* Returns the allocator. */
ww_allocator counting_allocator(void);

#endif
