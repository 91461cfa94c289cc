/* The tests that interface_test.c runs and does not contain. */
#ifndef WAYWRIGHT_TESTS_C_TESTS_H
#define WAYWRIGHT_TESTS_C_TESTS_H

void test_point_paths(void);
void test_disc_paths(void);
void test_many_paths(void);
void test_search(void);
void test_search_windows(void);
void test_following_changes(void);
void test_copies(void);
void test_limits(void);
void test_going_back(void);
void test_trying_out(void);
void test_disconnecting(void);
void test_changed_regions(void);
void test_path_watch(void);
void test_snapshots(void);
void test_snapshots_of_ticks(void);
void test_saving(void);
void test_replaying(void);
void test_snippets(void);
void test_mesh(void);
void test_scenes(void);
void test_pictures(void);
void test_callbacks(void);

#endif
