# 64-bit Windows, by mingw-w64 with POSIX threads. The programs need only the DLLs of Windows.
set(CMAKE_SYSTEM_NAME Windows)
set(waywright_triplet x86_64-w64-mingw32)
set(CMAKE_CXX_COMPILER ${waywright_triplet}-g++-posix)
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static")
include(${CMAKE_CURRENT_LIST_DIR}/gnu_cross.cmake)
