# Big endian.
set(waywright_triplet s390x-linux-gnu)
include(${CMAKE_CURRENT_LIST_DIR}/gnu_cross.cmake)
