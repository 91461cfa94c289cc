#pragma once

/// WAYWRIGHT_API stands before each public class and function that the library defines outside its headers. It makes
/// them visible outside a shared library, which hides everything else. In a static library it does nothing.
///
/// The build sets two macros. CMake targets and waywright.pc set them for you:
/// - WAYWRIGHT_SHARED, in the library and in programs that use it, if the library is a shared one;
/// - WAYWRIGHT_BUILDING, in the sources of the library only.
#if !defined(WAYWRIGHT_SHARED)
#define WAYWRIGHT_API
#elif defined(_WIN32) || defined(__CYGWIN__)
#if defined(WAYWRIGHT_BUILDING)
#define WAYWRIGHT_API __declspec(dllexport)
#else
#define WAYWRIGHT_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define WAYWRIGHT_API __attribute__((visibility("default")))
#else
#define WAYWRIGHT_API
#endif

/// Stands before the private classes inside a class that has WAYWRIGHT_API. It hides them again.
#if defined(__GNUC__) && !defined(_WIN32) && !defined(__CYGWIN__)
#define WAYWRIGHT_INTERNAL __attribute__((visibility("hidden")))
#else
#define WAYWRIGHT_INTERNAL
#endif

/// Stands before classes that a program catches. Their type information must be one and the same in a program and in
/// all its shared libraries, also where the library itself is static.
#if !defined(WAYWRIGHT_SHARED) && defined(__GNUC__) && !defined(_WIN32) && !defined(__CYGWIN__)
#define WAYWRIGHT_API_EXCEPTION __attribute__((visibility("default")))
#else
#define WAYWRIGHT_API_EXCEPTION WAYWRIGHT_API
#endif

/// Stands before inline functions of public headers that take more than one rounded step. The compiler puts each call
/// of them in place. Otherwise a linker could replace the library's copy by one that a program has compiled with its
/// own floating-point options, and the library's answers would change.
#if defined(__GNUC__)
#define WAYWRIGHT_INLINE __attribute__((always_inline)) inline
#elif defined(_MSC_VER)
#define WAYWRIGHT_INLINE __forceinline
#else
#define WAYWRIGHT_INLINE inline
#endif
