#include "waywright/error.hpp"

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace waywright {

std::string_view to_string(ErrorCode code) {
  switch (code) {
    case ErrorCode::coordinate_range:
      return "coordinate-range";
    case ErrorCode::out_of_domain:
      return "out-of-domain";
    case ErrorCode::id_in_use:
      return "id-in-use";
    case ErrorCode::unknown_id:
      return "unknown-id";
    case ErrorCode::bad_distance:
      return "bad-distance";
    case ErrorCode::bad_radius:
      return "bad-radius";
    case ErrorCode::bad_id:
      return "bad-id";
    case ErrorCode::bad_domain:
      return "bad-domain";
    case ErrorCode::empty_shape:
      return "empty-shape";
    case ErrorCode::too_large:
      return "too-large";
    case ErrorCode::world_gone:
      return "world-gone";
    case ErrorCode::not_supported:
      return "not-supported";
    case ErrorCode::unreadable:
      return "unreadable";
    case ErrorCode::malformed:
      return "malformed";
  }
  return "unknown";
}

BadResult::BadResult(Error error) : std::runtime_error(error.message), error_(std::move(error)) {}

// Defined here so that the class's type information is in the library, once.
BadResult::~BadResult() = default;

namespace detail {

void raise(const Error& error) {
#if defined(__cpp_exceptions)
  throw BadResult(error);
#else
  std::fprintf(stderr, "waywright: value() of a refused call: %s\n", error.message.c_str());
  std::abort();
#endif
}

}  // namespace detail

}  // namespace waywright
