#include <cstdio>
#include <cstring>
#include <waywright/waywright.hpp>

namespace {

bool fail(const char* what) {
  std::puts(what);
  return false;
}

// The path leads up and around the wall's upper end: (1, 0), (2, 2), (3, 0).
bool finds_path() {
  waywright::World world = waywright::World::create({{0, 0}, {4, 3}}).value();
  world.insert_segment({2, 0}, {2, 2}).value();
  const waywright::Path path = world.find_path({.start = {1, 0}, .goal = {3, 0}}).value();
  if (path.status != waywright::PathStatus::found || path.points.size() != 3) return fail("no way around the wall");
  return true;
}

// The library throws and the program catches: both must use the same exception class.
bool catches() {
  try {
    waywright::World::create({{0, 0}, {0, 0}}).value();
  } catch (const waywright::BadResult& refusal) {
    return refusal.error().code == waywright::ErrorCode::bad_domain || fail("another error");
  }
  return fail("nothing thrown");
}

bool has_version() {
  static_assert(WAYWRIGHT_VERSION_NUMBER >= WAYWRIGHT_MAKE_VERSION(0, 1, 0));
#if WAYWRIGHT_VERSION_NUMBER < WAYWRIGHT_MAKE_VERSION(0, 1, 0)
#error "the preprocessor must be able to compare versions, too"
#endif
  return std::strlen(WAYWRIGHT_VERSION) >= 5 || fail("no version");
}

}  // namespace

// Returns 0 only if the build found the headers, the library and the language standard.
int main() { return finds_path() && catches() && has_version() ? 0 : 1; }
