# No cross compiler: clang 14 with its own standard library (libc++).
set(CMAKE_CXX_COMPILER clang++-14)
set(CMAKE_CXX_FLAGS_INIT "-stdlib=libc++")
