#pragma once

#include <string>

namespace waywright {

/// @addtogroup world
/// @{

/// The answer of World::validate.
///
/// @code{.cpp}
/// const Validation validation = world.validate();
/// if (!validation.ok) std::puts(validation.fault.c_str());
/// @endcode
struct Validation {
  bool ok = true;
  std::string fault;  ///< the first fault; empty if `ok`
};

/// @}

}  // namespace waywright
