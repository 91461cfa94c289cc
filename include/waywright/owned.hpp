#pragma once

#include <memory>
#include <utility>

#include "waywright/assert.hpp"

namespace waywright::detail {

/// A std::unique_ptr that checks each access. It is empty in an object that has been moved from.
template <class T, const char* kIfEmpty>
class Owned {
 public:
  Owned(std::unique_ptr<T> object) : object_(std::move(object)) {}

  [[nodiscard]] T* operator->() const {
    WAYWRIGHT_ASSERT(object_ != nullptr, kIfEmpty);
    return object_.get();
  }
  [[nodiscard]] T* get() const { return operator->(); }
  [[nodiscard]] T& operator*() const { return *operator->(); }

 private:
  std::unique_ptr<T> object_;
};

inline constexpr char kMovedWorld[] = "World: this object has been moved from; you may only assign to it or destroy it";
inline constexpr char kMovedContext[] =
    "QueryContext: this object has been moved from; you may only assign to it or destroy it";
inline constexpr char kMovedSearch[] =
    "PathSearch: this object has been moved from; you may only assign to it or destroy it";
inline constexpr char kMovedWatch[] =
    "PathWatch: this object has been moved from; you may only assign to it or destroy it";

}  // namespace waywright::detail
