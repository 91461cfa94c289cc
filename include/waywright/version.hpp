#pragma once

/// The version of these headers, as text and as numbers. Before 1.0 a new minor version may break what the one before
/// promised.
#define WAYWRIGHT_VERSION "0.1.0"
#define WAYWRIGHT_VERSION_MAJOR 0
#define WAYWRIGHT_VERSION_MINOR 1
#define WAYWRIGHT_VERSION_PATCH 0

/// One number for comparisons: `#if WAYWRIGHT_VERSION_NUMBER >= WAYWRIGHT_MAKE_VERSION(0, 2, 0)`.
#define WAYWRIGHT_VERSION_NUMBER \
  WAYWRIGHT_MAKE_VERSION(WAYWRIGHT_VERSION_MAJOR, WAYWRIGHT_VERSION_MINOR, WAYWRIGHT_VERSION_PATCH)
#define WAYWRIGHT_MAKE_VERSION(major, minor, patch) ((major)*10000 + (minor)*100 + (patch))
