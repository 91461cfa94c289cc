# 32 bits. SSE2 computes in doubles. The x87 unit, which GCC uses by default, has more digits and rounds twice.
set(waywright_triplet i686-linux-gnu)
set(CMAKE_CXX_FLAGS_INIT "-msse2 -mfpmath=sse")
include(${CMAKE_CURRENT_LIST_DIR}/gnu_cross.cmake)
