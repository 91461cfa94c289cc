#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "waywright/assert.hpp"
#include "waywright/export.hpp"
#include "waywright/id.hpp"
#include "waywright/point.hpp"

namespace waywright {

/// @addtogroup errors
/// @{

/// The kind of an error: why a function refused its arguments or its data. A refused call changes no world.
/// The C interface has the same numbers.
enum class ErrorCode : std::uint8_t {
  coordinate_range = 1,  ///< a coordinate that is not finite, beyond ±2^100, or nearer to 0 than 2^-100 but not 0
  out_of_domain,         ///< a point outside the world's domain
  id_in_use,             ///< a live item has this id already
  unknown_id,            ///< no live item has this id
  bad_radius,            ///< a radius that is negative or not finite
  bad_distance,          ///< a distance that is negative, not a number, or too small
  /// An id above 2^63 - 1, for example an id made from a negative number. World::reserve_ids and ReplayWriter::record
  /// also refuse the null id with this code.
  bad_id,
  bad_domain,  ///< a domain without min.x < max.x and min.y < max.y, or a box with min beyond max
  /// A number of rings or points that the kind of the item does not allow, for example 0. Or a kind or a fill rule that
  /// is none of the values of its type.
  bad_shape,
  /// A change that makes the mesh too large. There are two limits. The number of vertices plus the number of points
  /// of the new shapes may be at most 2^27. With the crossings that the change makes, the mesh may have at most 350
  /// million vertices.
  too_large,
  too_many_vertices,  ///< an operation that would make more vertices than WorldOptions::new_vertex_limit allows
  world_gone,         ///< the world of a PathSearch no longer exists
  not_supported,      ///< a request that this version or this world does not support
  no_bridges,         ///< a query that needs bridges, of a world that does not keep them
  no_history,         ///< a rewind, or a snapshot of a tick, of a world that keeps no history
  old_tick,           ///< a tick that the history of a world no longer contains
  unknown_tick,       ///< a tick that no mark has: World::mark() has not returned it, or a rewind has dropped it
  unreadable,         ///< a file that cannot be opened or read
  malformed,          ///< text or bytes that do not follow their format
  unwritable,         ///< a file or a stream that cannot be written
};

/// Returns the name by which the command `waywright run` prints a code: `coordinate-range`, `out-of-domain` and so on.
[[nodiscard]] WAYWRIGHT_API std::string_view to_string(ErrorCode code);

/// @}

namespace detail {

/// The words that a message uses for a point: a name (`the start`), or a noun with a number in a list (`goal 3`).
struct PointName {
  constexpr PointName() = default;
  template <std::size_t N>
  constexpr PointName(const char (&literal)[N]) : name(literal) {}
  constexpr PointName(const char* literal, std::size_t index) : name(literal), number(index), has_number(true) {}

  const char* name = nullptr;
  std::uint64_t number = 0;
  bool has_number = false;
};

/// The data from which Error::message() makes its text. It owns memory only if `text` is set, for example by a parser
/// of files.
struct ErrorWords {
  ErrorWords() = default;
  /// The whole message. The constructor keeps the pointer, so `message` must be a literal.
  template <std::size_t N>
  ErrorWords(const char (&message)[N]) : literal(message) {}
  template <std::size_t N>
  ErrorWords(char (&message)[N]) = delete;
  /// The whole message.
  ErrorWords(std::string message) : text(std::move(message)) {}

  std::string text;
  const char* literal = nullptr;
  /// The noun for the refused element of a list, for example `change`. Error::index is the index of this element.
  const char* element_noun = nullptr;
  PointName point_name;  ///< the name of the refused point, if the error is about a point
  Point point;
  Box domain;
  std::uint64_t limit = 0;  ///< the limit that the operation would have exceeded, if the error is about a limit
};

}  // namespace detail

/// @addtogroup errors
/// @{

/// An error: what is wrong, and where. An Error that a World returns owns no memory, so a refusal in a hot loop
/// allocates nothing. message() makes the text when you call it.
///
/// @code{.cpp}
/// const Result<ItemId> id = world.insert_point({101, 5});  // the domain is (0, 0) to (100, 100)
/// if (!id) {
///   const bool is_outside = id.error().code == ErrorCode::out_of_domain;  // == true
///   std::puts(id.error().message().c_str());
/// }
/// @endcode
struct Error {
  ErrorCode code = ErrorCode::malformed;
  detail::ErrorWords words;  ///< the data of message(); if you make an Error yourself, set it to a string
  ItemId item;               ///< the id that caused the error, or null
  /// The index of the refused element in its list (from 0); for a query with two ends, 0 for the first and 1 for the
  /// second; or a line number (from 1). World::rewind and World::publish set it to the tick, and load_world to a
  /// number of bytes.
  std::uint64_t index = 0;

  /// Returns the error in words, for a person: `the goal, (7, 12), lies outside the domain, (0, 0) to (10, 10)`.
  [[nodiscard]] WAYWRIGHT_API std::string message() const;
};

/// The exception that Result::value() throws if there is an error. Only your call of value() throws it.
///
/// @code{.cpp}
/// try {
///   world.remove(99).value();  // no item has this id
/// } catch (const BadResult& bad) {
///   std::puts(bad.what());
///   const bool is_unknown = bad.error().code == ErrorCode::unknown_id;  // == true
/// }
/// @endcode
class WAYWRIGHT_API_EXCEPTION BadResult : public std::runtime_error {
 public:
  explicit BadResult(Error error);
  BadResult(const BadResult&) = default;
  BadResult(BadResult&&) = default;
  BadResult& operator=(const BadResult&) = default;
  BadResult& operator=(BadResult&&) = default;
  ~BadResult() override;

  /// Returns the error of the Result that threw this exception.
  [[nodiscard]] const Error& error() const { return error_; }

 private:
  Error error_;
};

/// @}

namespace detail {
/// Throws BadResult. In a build without exceptions it ends the process instead.
[[noreturn]] WAYWRIGHT_API void raise(const Error& error);
/// Calls the assertion handler and aborts. Result calls this function if you use `*` or `->` on a result that has an
/// error.
[[noreturn]] WAYWRIGHT_API void fail_value_access(const Error& error);
}  // namespace detail

/// @addtogroup errors
/// @{

/// A value of type `T`, or the Error that says why there is none.
///
/// @code{.cpp}
/// const Result<Path> result = world.find_path({.start = start, .goal = goal});
/// if (!result) {
///   std::puts(result.error().message().c_str());
///   return;
/// }
/// std::printf("length %g\n", result->length);
///
/// const double length = world.find_path({start, goal}).value().length;  // == result->length
/// @endcode
///
/// After a check of ok(), use `*result` and `result->`. Use value() if an exception should report the error.
template <class T>
class [[nodiscard]] Result {
 public:
  /// Makes a result with a value.
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  /// Makes a result with an error.
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  /// Returns whether there is a value.
  [[nodiscard]] bool ok() const { return state_.index() == 0; }
  /// Returns ok().
  explicit operator bool() const { return ok(); }

  /// Returns the value.
  /// Exceptions: throws BadResult if there is an error. In a build without exceptions it ends the process instead.
  const T& value() const& {
    if (!ok()) detail::raise(error());
    return *std::get_if<0>(&state_);
  }
  /// Moves the value out of a temporary result, so that `for (auto& x : f().value())` is safe.
  /// Exceptions: throws BadResult if there is an error. In a build without exceptions it ends the process instead.
  T value() && {
    if (!ok()) detail::raise(error());
    return std::move(*std::get_if<0>(&state_));
  }

  /// Returns the value.
  /// Requires: ok(). The library checks this in every build; see set_assertion_handler.
  [[nodiscard]] const T& operator*() const& { return *operator->(); }
  /// Returns the value.
  /// Requires: ok().
  [[nodiscard]] T& operator*() & { return *operator->(); }
  /// Moves the value out of a temporary result.
  /// Requires: ok().
  [[nodiscard]] T operator*() && { return std::move(*operator->()); }
  /// Gives access to the members of the value.
  /// Requires: ok(). The library checks this in every build.
  [[nodiscard]] const T* operator->() const {
    if (!ok()) detail::fail_value_access(error());
    return std::get_if<0>(&state_);
  }
  /// Gives access to the members of the value.
  /// Requires: ok().
  [[nodiscard]] T* operator->() {
    if (!ok()) detail::fail_value_access(error());
    return std::get_if<0>(&state_);
  }

  /// Returns the error.
  /// Requires: not ok(). The library checks this in every build.
  [[nodiscard]] const Error& error() const {
    WAYWRIGHT_ASSERT(!ok(), "Result::error(): the result has no error");
    return *std::get_if<1>(&state_);
  }

 private:
  std::variant<T, Error> state_;
};

/// The result of a function that returns no value: success, or the Error that says why the function did nothing.
///
/// @code{.cpp}
/// const Result<void> done = world.replace(1, Shape::rectangle({{30, 30}, {50, 50}}));
/// if (!done) std::puts(done.error().message().c_str());
/// @endcode
template <>
class [[nodiscard]] Result<void> {
 public:
  /// Makes a result without an error.
  Result() = default;
  /// Makes a result with an error.
  Result(Error error) : error_(std::move(error)) {}

  /// Returns whether there is no error.
  [[nodiscard]] bool ok() const { return !error_.has_value(); }
  /// Returns ok().
  explicit operator bool() const { return ok(); }

  /// Does nothing if there is no error.
  /// Exceptions: throws BadResult if there is an error. In a build without exceptions it ends the process instead.
  void value() const {
    if (!ok()) detail::raise(*error_);
  }

  /// Returns the error.
  /// Requires: not ok(). The library checks this in every build.
  [[nodiscard]] const Error& error() const {
    WAYWRIGHT_ASSERT(!ok(), "Result::error(): the result has no error");
    return *error_;
  }

 private:
  std::optional<Error> error_;
};

/// @}

}  // namespace waywright
