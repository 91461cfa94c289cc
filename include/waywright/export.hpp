#pragma once

/// @addtogroup build
/// @{

/// @def WAYWRIGHT_API
/// Marks each public class and function that the library defines outside its headers. A shared library exports only the
/// marked names. In a static library the mark does nothing.
///
/// Two macros decide what the mark does. The CMake targets and waywright.pc set them for you:
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

/// @def WAYWRIGHT_INTERNAL
/// Marks a private class inside a class that has WAYWRIGHT_API, so that a shared library does not export the private
/// class.
#if defined(__GNUC__) && !defined(_WIN32) && !defined(__CYGWIN__)
#define WAYWRIGHT_INTERNAL __attribute__((visibility("hidden")))
#else
#define WAYWRIGHT_INTERNAL
#endif

/// @def WAYWRIGHT_API_EXCEPTION
/// Marks a class that a program can catch as an exception. A program and all its shared libraries must share the type
/// information of such a class, even if this library is a static one.
#if !defined(WAYWRIGHT_SHARED) && defined(__GNUC__) && !defined(_WIN32) && !defined(__CYGWIN__)
#define WAYWRIGHT_API_EXCEPTION __attribute__((visibility("default")))
#else
#define WAYWRIGHT_API_EXCEPTION WAYWRIGHT_API
#endif

/// @def WAYWRIGHT_INLINE
/// Marks an inline function of a public header that carries out several floating-point operations, each of which rounds
/// its result. The compiler inlines each call of the function. Without the mark, a program and the library would each
/// contain a compiled copy of the function, and the linker would keep only one of them. If it kept the copy of the
/// program, which is compiled with the program's floating-point options, the library's answers could change.
#if defined(__GNUC__)
#define WAYWRIGHT_INLINE __attribute__((always_inline)) inline
#elif defined(_MSC_VER)
#define WAYWRIGHT_INLINE __forceinline
#else
#define WAYWRIGHT_INLINE inline
#endif

/// @}
