#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "internal.hpp"

#if !defined(__cpp_exceptions)
#error "the C library turns exceptions into statuses: compile it with exceptions, or set WAYWRIGHT_BUILD_C to OFF"
#endif

namespace waywright::c {

namespace {

static_assert(WW_VERSION_MAJOR == WAYWRIGHT_VERSION_MAJOR && WW_VERSION_MINOR == WAYWRIGHT_VERSION_MINOR &&
              WW_VERSION_PATCH == WAYWRIGHT_VERSION_PATCH && WW_VERSION_NUMBER == WAYWRIGHT_VERSION_NUMBER);

template <class Enum>
constexpr bool equal(std::int32_t c, Enum cpp) {
  return c == static_cast<std::int32_t>(cpp);
}
static_assert(equal(WW_COORDINATE_RANGE, ErrorCode::coordinate_range));
static_assert(equal(WW_OUT_OF_DOMAIN, ErrorCode::out_of_domain));
static_assert(equal(WW_ID_IN_USE, ErrorCode::id_in_use));
static_assert(equal(WW_UNKNOWN_ID, ErrorCode::unknown_id));
static_assert(equal(WW_BAD_RADIUS, ErrorCode::bad_radius));
static_assert(equal(WW_BAD_DISTANCE, ErrorCode::bad_distance));
static_assert(equal(WW_BAD_ID, ErrorCode::bad_id));
static_assert(equal(WW_BAD_DOMAIN, ErrorCode::bad_domain));
static_assert(equal(WW_BAD_SHAPE, ErrorCode::bad_shape));
static_assert(equal(WW_TOO_LARGE, ErrorCode::too_large));
static_assert(equal(WW_TOO_MANY_VERTICES, ErrorCode::too_many_vertices));
static_assert(equal(WW_WORLD_GONE, ErrorCode::world_gone));
static_assert(equal(WW_NOT_SUPPORTED, ErrorCode::not_supported));
static_assert(equal(WW_NO_BRIDGES, ErrorCode::no_bridges));
static_assert(equal(WW_NO_HISTORY, ErrorCode::no_history));
static_assert(equal(WW_OLD_TICK, ErrorCode::old_tick));
static_assert(equal(WW_UNKNOWN_TICK, ErrorCode::unknown_tick));
static_assert(equal(WW_UNREADABLE, ErrorCode::unreadable));
static_assert(equal(WW_MALFORMED, ErrorCode::malformed));
static_assert(equal(WW_UNWRITABLE, ErrorCode::unwritable));
static_assert(WW_LARGEST_COORDINATE == kLargestCoordinate && WW_SMALLEST_COORDINATE == kSmallestCoordinate);
static_assert(equal(WW_ITEM_POINT, ItemKind::point) && equal(WW_ITEM_SEGMENT, ItemKind::segment) &&
              equal(WW_ITEM_POLYLINE, ItemKind::polyline) && equal(WW_ITEM_POLYGON, ItemKind::polygon));
static_assert(equal(WW_FILL_EVEN_ODD, FillRule::even_odd) && equal(WW_FILL_NONZERO, FillRule::nonzero));
static_assert(equal(WW_CHANGE_INSERT, Change::Kind::insert) && equal(WW_CHANGE_REMOVE, Change::Kind::remove) &&
              equal(WW_CHANGE_REPLACE, Change::Kind::replace));
static_assert(equal(WW_LOCATION_VERTEX, LocationKind::vertex) && equal(WW_LOCATION_EDGE, LocationKind::edge) &&
              equal(WW_LOCATION_FACE, LocationKind::face));
static_assert(equal(WW_ALGORITHM_TA, PathAlgorithm::ta) && equal(WW_ALGORITHM_TRA, PathAlgorithm::tra) &&
              equal(WW_ALGORITHM_OPTIMAL, PathAlgorithm::optimal));
static_assert(equal(WW_PATH_FOUND, PathStatus::found) && equal(WW_PATH_START_BLOCKED, PathStatus::start_blocked) &&
              equal(WW_PATH_GOAL_BLOCKED, PathStatus::goal_blocked) && equal(WW_PATH_NO_PATH, PathStatus::no_path));
static_assert(equal(WW_PIECE_LINE, PathPiece::Kind::line) && equal(WW_PIECE_ARC, PathPiece::Kind::arc));
static_assert(equal(WW_FLOAT64, Precision::float64) && equal(WW_FLOAT32, Precision::float32));
static_assert(equal(WW_SCENE_SCRIPT, SceneFormat::script) && equal(WW_SCENE_MOVINGAI, SceneFormat::movingai) &&
              equal(WW_SCENE_TRIANGLE_POLY, SceneFormat::triangle_poly) &&
              equal(WW_SCENE_TRIANGLE_NODE, SceneFormat::triangle_node) &&
              equal(WW_SCENE_SAVED_WORLD, SceneFormat::saved_world));
static_assert(equal(WW_SCRIPT_INSERT, ScriptLineKind::insert) && equal(WW_SCRIPT_REMOVE, ScriptLineKind::remove) &&
              equal(WW_SCRIPT_REPLACE, ScriptLineKind::replace) && equal(WW_SCRIPT_LOCATE, ScriptLineKind::locate) &&
              equal(WW_SCRIPT_RAY, ScriptLineKind::ray) && equal(WW_SCRIPT_DISC, ScriptLineKind::disc) &&
              equal(WW_SCRIPT_NEAREST, ScriptLineKind::nearest) && equal(WW_SCRIPT_PATH, ScriptLineKind::path) &&
              equal(WW_SCRIPT_CHECK, ScriptLineKind::check) && equal(WW_SCRIPT_HASH, ScriptLineKind::hash) &&
              equal(WW_SCRIPT_CLEAR, ScriptLineKind::clear) && equal(WW_SCRIPT_TICK, ScriptLineKind::tick) &&
              equal(WW_SCRIPT_MARK, ScriptLineKind::mark) && equal(WW_SCRIPT_REWIND, ScriptLineKind::rewind));
static_assert(equal(WW_DIFFERENCE_DOMAIN, ReplayDifference::Kind::domain) &&
              equal(WW_DIFFERENCE_CHANGE, ReplayDifference::Kind::change) &&
              equal(WW_DIFFERENCE_HASH, ReplayDifference::Kind::hash) &&
              equal(WW_DIFFERENCE_LENGTH, ReplayDifference::Kind::length));
static_assert(equal(WW_SVG_AUTOMATIC, SvgTheme::automatic) && equal(WW_SVG_LIGHT, SvgTheme::light) &&
              equal(WW_SVG_DARK, SvgTheme::dark));

/// The last error of a thread.
struct LastError {
  ww_status status = WW_OK;
  const char* literal = nullptr;  ///< the message, or null if `error` has it
  Error error;
};

thread_local LastError last_error;

/// A broken precondition inside the library. Only a bug in this library throws it, because the functions of the
/// interface check their arguments before.
struct BrokenPrecondition {
  const char* message;
};

/// The library aborts when its assertion handler returns. So this handler throws an exception instead.
[[noreturn]] void throw_failure(const AssertionFailure& failure) { throw BrokenPrecondition{failure.message}; }

/// Copies a text, as far as the buffer holds it, and a zero byte. Returns false if the buffer is too small.
bool copy_text(std::string_view text, char* buffer, std::size_t capacity, std::size_t* count) noexcept {
  if (count != nullptr) *count = text.size() + 1;
  if (capacity == 0) return buffer == nullptr;
  const std::size_t written = std::min(text.size(), capacity - 1);
  std::copy_n(text.data(), written, buffer);
  buffer[written] = '\0';
  return text.size() < capacity;
}

[[maybe_unused]] const AssertionHandler previous_handler = set_assertion_handler(throw_failure);

}  // namespace

ww_status fail(ww_status status, const char* message) noexcept {
  last_error.status = status;
  last_error.literal = message;
  last_error.error.item = {};
  last_error.error.index = 0;
  return status;
}

ww_status fail(const Error& error) {
  last_error.error = error;
  last_error.literal = nullptr;
  last_error.status = static_cast<ww_status>(error.code);
  return last_error.status;
}

ww_status fail_by_exception() noexcept {
  try {
    throw;
  } catch (const Refusal& refusal) {
    return fail(refusal.status, refusal.message);
  } catch (const std::bad_alloc&) {
    return fail(WW_OUT_OF_MEMORY, "there is not enough memory");
  } catch (const std::length_error&) {
    return fail(WW_OUT_OF_MEMORY, "a list is larger than any memory");
  } catch (const BrokenPrecondition& bug) {
    return fail(WW_INTERNAL_ERROR, bug.message);
  } catch (...) {
    return fail(WW_INTERNAL_ERROR, "the library threw an unknown exception");
  }
}

ww_status write_text(std::string_view text, char* buffer, std::size_t capacity, std::size_t* count) {
  require(buffer != nullptr || capacity == 0, "a buffer is null, and its capacity is not 0");
  if (copy_text(text, buffer, capacity, count)) return WW_OK;
  return fail(WW_BUFFER_TOO_SMALL, "a buffer is too small for a text and its zero byte");
}

/// Forgets the error of this thread, which can own memory.
void clear_last_error() noexcept {
  LastError none;
  std::swap(last_error, none);  // an assignment would keep the memory of the text
}

}  // namespace waywright::c

using namespace waywright;
using namespace waywright::c;

const char* ww_status_name(ww_status status) {
  switch (status) {
    case WW_OK:
      return "ok";
    case WW_OUT_OF_MEMORY:
      return "out-of-memory";
    case WW_INVALID_ARGUMENT:
      return "invalid-argument";
    case WW_BUFFER_TOO_SMALL:
      return "buffer-too-small";
    case WW_INTERNAL_ERROR:
      return "internal-error";
    default:
      break;
  }
  if (status < WW_COORDINATE_RANGE || status > WW_UNWRITABLE) return "unknown";
  return to_string(static_cast<ErrorCode>(status)).data();
}

const char* ww_version(void) { return WAYWRIGHT_VERSION; }
int32_t ww_version_number(void) { return WAYWRIGHT_VERSION_NUMBER; }

ww_status ww_last_error(ww_error* error) {
  if (error == nullptr || error->struct_size != sizeof(ww_error)) return WW_INVALID_ARGUMENT;
  const std::uint32_t size = error->struct_size;
  *error = {size, last_error.status, last_error.error.item.value, last_error.error.index};
  return WW_OK;
}

ww_status ww_last_error_message(char* buffer, size_t capacity, size_t* count) {
  if (buffer == nullptr && capacity != 0) return WW_INVALID_ARGUMENT;
  const auto write = [&](std::string_view text) {
    return copy_text(text, buffer, capacity, count) ? WW_OK : WW_BUFFER_TOO_SMALL;
  };
  if (last_error.status == WW_OK) return write("");
  if (last_error.literal != nullptr) return write(last_error.literal);
  try {
    return write(last_error.error.message());
  } catch (...) {  // not enough memory for the message
    return write(ww_status_name(last_error.status));
  }
}

const char* ww_item_kind_name(ww_item_kind kind) {
  return kind < 0 || kind > WW_ITEM_POLYGON ? "unknown" : to_string(static_cast<ItemKind>(kind)).data();
}
const char* ww_fill_rule_name(ww_fill_rule rule) {
  return rule < 0 || rule > WW_FILL_NONZERO ? "unknown" : to_string(static_cast<FillRule>(rule)).data();
}
const char* ww_location_kind_name(ww_location_kind kind) {
  return kind < 0 || kind > WW_LOCATION_FACE ? "unknown" : to_string(static_cast<LocationKind>(kind)).data();
}
const char* ww_path_algorithm_name(ww_path_algorithm algorithm) {
  const bool is_known = algorithm >= 0 && algorithm <= WW_ALGORITHM_OPTIMAL;
  return is_known ? to_string(static_cast<PathAlgorithm>(algorithm)).data() : "unknown";
}
const char* ww_path_status_name(ww_path_status status) {
  return status < 0 || status > WW_PATH_NO_PATH ? "unknown" : to_string(static_cast<PathStatus>(status)).data();
}

ww_status ww_path_algorithm_by_name(const char* name, ww_path_algorithm* algorithm) {
  return guarded([&] {
    const std::optional<PathAlgorithm> found = path_algorithm(to_view(name));
    require(found.has_value(), "no path algorithm has this name");
    answer(algorithm) = static_cast<ww_path_algorithm>(*found);
    return WW_OK;
  });
}
