#include "waywright/error.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "base/float_environment.hpp"
#include "base/number_text.hpp"

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
    case ErrorCode::bad_shape:
      return "bad-shape";
    case ErrorCode::too_large:
      return "too-large";
    case ErrorCode::too_many_vertices:
      return "too-many-vertices";
    case ErrorCode::world_gone:
      return "world-gone";
    case ErrorCode::not_supported:
      return "not-supported";
    case ErrorCode::no_bridges:
      return "no-bridges";
    case ErrorCode::no_history:
      return "no-history";
    case ErrorCode::old_tick:
      return "old-tick";
    case ErrorCode::unknown_tick:
      return "unknown-tick";
    case ErrorCode::unreadable:
      return "unreadable";
    case ErrorCode::malformed:
      return "malformed";
    case ErrorCode::unwritable:
      return "unwritable";
  }
  return "unknown";
}

namespace {

/// The number of an id that is too large. A negative number has become such an id (ItemId), so most of them print as
/// negative numbers. The id after the largest one prints as 2^63.
std::string text_of_bad_id(ItemId id) {
  return id.value == ItemId::kLargest + 1 ? "2^63" : std::to_string(static_cast<std::int64_t>(id.value));
}

void append_point_error(std::string& text, const Error& error) {
  const detail::PointName& named = error.words.point_name;
  const Point& point = error.words.point;
  const auto append_name = [&] {
    text += named.name;
    if (named.has_number) text += base::with_number(" ", named.number, "");
    text += ", ";
  };
  if (error.code == ErrorCode::out_of_domain) {
    append_name();
    text += to_string(point) + ", lies outside the domain, " + to_string(error.words.domain.min) + " to " +
            to_string(error.words.domain.max);
    return;
  }
  const bool is_x = !is_in_range(point.x);
  const double value = is_x ? point.x : point.y;
  text += is_x ? "x of " : "y of ";
  append_name();
  base::append_number(text, value);
  if (!std::isfinite(value)) {
    text += ", is not finite";
  } else if (std::abs(value) > kLargestCoordinate) {
    text += ", lies beyond +-2^100";
  } else {
    text += ", is nearer to 0 than 2^-100 without being 0";
  }
}

/// Appends the message of an error that names an id and perhaps a limit.
void append_id_error(std::string& text, const Error& error) {
  const auto append_limit = [&](const char* before, const char* after) {
    text += base::with_number("item ", error.item.value, before) + base::with_number("", error.words.limit, after);
  };
  switch (error.code) {
    case ErrorCode::too_large:
      append_limit(" would bring the world to more than ", " vertices; remove items or divide the world");
      break;
    case ErrorCode::too_many_vertices:
      append_limit(" would bring the operation to more than ",
                   " new vertices, its limit; divide the operation or raise the limit");
      break;
    case ErrorCode::id_in_use:
      text += base::with_number("an item has id ", error.item.value, " already");
      break;
    case ErrorCode::unknown_id:
      text += base::with_number("no item has id ", error.item.value, "");
      break;
    case ErrorCode::bad_id:
      text += "ids go from 1 to 2^63 - 1, and " + text_of_bad_id(error.item) + " is not an id";
      break;
    default:
      text += to_string(error.code);
  }
}

}  // namespace

std::string Error::message() const {
  const base::FloatEnvironment environment;
  std::string text;
  if (words.element_noun != nullptr) text = words.element_noun + base::with_number(" ", index, ": ");
  if (!words.text.empty()) {
    text += words.text;
  } else if (words.literal != nullptr) {
    text += words.literal;
  } else if (words.point_name.name != nullptr) {
    append_point_error(text, *this);
  } else {
    append_id_error(text, *this);
  }
  return text;
}

BadResult::BadResult(Error error) : std::runtime_error(error.message()), error_(std::move(error)) {}

// Defined here, so that only the library contains the type information of the class.
BadResult::~BadResult() = default;

namespace detail {

void raise(const Error& error) {
#if defined(__cpp_exceptions)
  throw BadResult(error);
#else
  fail_value_access(error);
#endif
}

void fail_value_access(const Error& error) {
  const std::string message = "the program took the value of a Result that has an error: " + error.message();
  fail_assertion({message.c_str(), "Result::ok()", WAYWRIGHT_FILE_NAME, __LINE__});
}

}  // namespace detail

}  // namespace waywright
