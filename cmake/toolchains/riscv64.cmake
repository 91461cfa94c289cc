set(waywright_triplet riscv64-linux-gnu)
include(${CMAKE_CURRENT_LIST_DIR}/gnu_cross.cmake)
