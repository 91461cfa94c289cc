#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "waywright/export.hpp"
#include "waywright/id.hpp"

namespace waywright {

/// Why data was refused. A refused call has changed nothing.
enum class ErrorCode : std::uint8_t {
  coordinate_range,  ///< not finite, beyond ±2^100, or nearer to 0 than 2^-100 without being 0
  out_of_domain,     ///< a point outside the world's domain
  id_in_use,         ///< an item of that id is alive
  unknown_id,        ///< no item of that id is alive
  bad_radius,        ///< a radius that is negative or not finite
  bad_distance,      ///< a distance that is negative or not a number
  bad_id,            ///< an id above 2^63 - 1
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

/// What was wrong, where, and what to do about it.
struct Error {
  ErrorCode code = ErrorCode::malformed;
  std::string message;
  ItemId item;              ///< the offending id, null where no id is to blame
  std::uint64_t index = 0;  ///< the offending point's position in its list, or the line of a text (from 1)
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

  /// Requires ok().
  [[nodiscard]] const T& operator*() const& { return *std::get_if<0>(&state_); }
  [[nodiscard]] T& operator*() & { return *std::get_if<0>(&state_); }
  [[nodiscard]] T operator*() && { return std::move(*std::get_if<0>(&state_)); }
  [[nodiscard]] const T* operator->() const { return std::get_if<0>(&state_); }
  [[nodiscard]] T* operator->() { return std::get_if<0>(&state_); }

  /// Requires !ok().
  [[nodiscard]] const Error& error() const { return *std::get_if<1>(&state_); }

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

  /// Requires !ok().
  [[nodiscard]] const Error& error() const { return *error_; }

 private:
  std::optional<Error> error_;
};

}  // namespace waywright
