/* The tests that interface_test.c runs and does not contain. */
#ifndef WAYWRIGHT_TESTS_C_TESTS_H
#define WAYWRIGHT_TESTS_C_TESTS_H

void test_point_paths(void);
void test_disc_paths(void);
void test_many_paths(void);
void test_search(void);
void test_following_changes(void);
void test_mesh(void);
void test_scenes(void);
void test_pictures(void);

#endif
