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

/// Why data was refused. A refused call has changed nothing.
enum class ErrorCode : std::uint8_t {
  coordinate_range,  ///< not finite, beyond ±2^100, or nearer to 0 than 2^-100 without being 0
  out_of_domain,     ///< a point outside the world's domain
  id_in_use,         ///< an item of that id is alive
  unknown_id,        ///< no item of that id is alive
  bad_radius,        ///< a radius that is negative or not finite
  bad_distance,      ///< a distance that is negative or not a number
  bad_id,            ///< an id above 2^63 - 1; a negative number is one
  bad_domain,        ///< a domain that is not min.x < max.x and min.y < max.y
  empty_shape,       ///< a polyline or ring without points, a polygon without rings
  too_large,         ///< more vertices, triangles or items than 32-bit indices can name
  world_gone,        ///< the world of a search no longer exists
  not_supported,     ///< a request this version does not carry out
  unreadable,        ///< a file that cannot be opened or read
  malformed,         ///< text that does not follow its format
};

/// The code as the world script prints it: `coordinate-range`, `out-of-domain`, ...
[[nodiscard]] WAYWRIGHT_API std::string_view to_string(ErrorCode code);

namespace detail {

/// What messages call a point: by a name, `the start`, or by its number in a list, `goal 3`.
struct PointName {
  constexpr PointName() = default;
  template <std::size_t N>
  constexpr PointName(const char (&literal)[N]) : name(literal) {}
  constexpr PointName(const char* literal, std::size_t position) : name(literal), number(position), has_number(true) {}

  const char* name = nullptr;
  std::uint64_t number = 0;
  bool has_number = false;
};

/// What Error::message() makes its text of. Only a text that a reader of files has written takes memory of its own.
struct ErrorWords {
  ErrorWords() = default;
  /// The whole message. It is not copied, so it must be a literal.
  template <std::size_t N>
  ErrorWords(const char (&message)[N]) : literal(message) {}
  template <std::size_t N>
  ErrorWords(char (&message)[N]) = delete;
  /// The whole message.
  ErrorWords(std::string message) : text(std::move(message)) {}

  std::string text;
  const char* literal = nullptr;
  const char* list =
      nullptr;           ///< of a list's element: what one is called, `change` or `query`; its position is the index
  PointName point_name;  ///< of a point that is refused
  Point point;
  Box domain;
};

}  // namespace detail

/// What was wrong, where, and what to do about it. An Error that a World gives owns no memory, so a refusal in a hot
/// loop allocates nothing; the text is made when it is asked for.
struct Error {
  ErrorCode code = ErrorCode::malformed;
  detail::ErrorWords words;  ///< what message() makes its text of; of your own errors: a string
  ItemId item;               ///< the offending id, null where no id is to blame
  std::uint64_t index = 0;   ///< the offending point's position in its list, or the line of a text (from 1)

  /// The error in words, for a person to read: `the goal, (7, 12), lies outside the domain, (0, 0) to (10, 10)`.
  [[nodiscard]] WAYWRIGHT_API std::string message() const;
};

/// Thrown by Result::value() on an error, for callers who like exceptions; the library itself throws nothing.
class WAYWRIGHT_API_EXCEPTION BadResult : public std::runtime_error {
 public:
  explicit BadResult(Error error);
  BadResult(const BadResult&) = default;
  BadResult(BadResult&&) = default;
  BadResult& operator=(const BadResult&) = default;
  BadResult& operator=(BadResult&&) = default;
  ~BadResult() override;

  [[nodiscard]] const Error& error() const { return error_; }

 private:
  Error error_;
};

namespace detail {
[[noreturn]] WAYWRIGHT_API void raise(const Error& error);
/// Fails as an assertion does: the value of a refused call was taken without a look at ok().
[[noreturn]] WAYWRIGHT_API void fail_value_of(const Error& error);
}  // namespace detail

/// A value, or the reason why there is none.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  [[nodiscard]] bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// The value. Throws BadResult on an error (ends the process where exceptions are off).
  const T& value() const& {
    if (!ok()) detail::raise(error());
    return *std::get_if<0>(&state_);
  }
  /// Of a temporary, the value itself, so that `for (auto& x : f().value())` is safe.
  T value() && {
    if (!ok()) detail::raise(error());
    return std::move(*std::get_if<0>(&state_));
  }

  /// Requires: ok(). Checked in every build; see set_assertion_handler.
  [[nodiscard]] const T& operator*() const& { return *operator->(); }
  [[nodiscard]] T& operator*() & { return *operator->(); }
  [[nodiscard]] T operator*() && { return std::move(*operator->()); }
  [[nodiscard]] const T* operator->() const {
    if (!ok()) detail::fail_value_of(error());
    return std::get_if<0>(&state_);
  }
  [[nodiscard]] T* operator->() {
    if (!ok()) detail::fail_value_of(error());
    return std::get_if<0>(&state_);
  }

  /// Requires: not ok(). Checked in every build.
  [[nodiscard]] const Error& error() const {
    WAYWRIGHT_ASSERT(!ok(), "Result::error(): the call was carried out, there is no error");
    return *std::get_if<1>(&state_);
  }

 private:
  std::variant<T, Error> state_;
};

/// Done, or the reason why nothing was done.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}

  [[nodiscard]] bool ok() const { return !error_.has_value(); }
  explicit operator bool() const { return ok(); }

  /// Throws BadResult on an error (ends the process where exceptions are off).
  void value() const {
    if (!ok()) detail::raise(*error_);
  }

  /// Requires: not ok(). Checked in every build.
  [[nodiscard]] const Error& error() const {
    WAYWRIGHT_ASSERT(!ok(), "Result::error(): the call was carried out, there is no error");
    return *error_;
  }

 private:
  std::optional<Error> error_;
};

}  // namespace waywright
