#pragma once

/// @addtogroup build
/// @{

/// @name The version of these headers
/// The version as text and as numbers. Before 1.0, a new minor version may break the promises of the previous one.
///
/// @code{.cpp}
/// std::puts("compiled with waywright " WAYWRIGHT_VERSION);
/// #if WAYWRIGHT_VERSION_NUMBER >= WAYWRIGHT_MAKE_VERSION(0, 2, 0)
/// std::puts("0.2 or later");
/// #endif
/// @endcode
/// @{

/// The version as text.
#define WAYWRIGHT_VERSION "0.1.0"
#define WAYWRIGHT_VERSION_MAJOR 0
#define WAYWRIGHT_VERSION_MINOR 1
#define WAYWRIGHT_VERSION_PATCH 0

/// The version as one number, for comparisons.
#define WAYWRIGHT_VERSION_NUMBER \
  WAYWRIGHT_MAKE_VERSION(WAYWRIGHT_VERSION_MAJOR, WAYWRIGHT_VERSION_MINOR, WAYWRIGHT_VERSION_PATCH)
/// Returns the number of a version, for comparisons with WAYWRIGHT_VERSION_NUMBER.
#define WAYWRIGHT_MAKE_VERSION(major, minor, patch) ((major)*10000 + (minor)*100 + (patch))

/// @}
/// @}
