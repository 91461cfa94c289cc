# A GCC cross compiler as Debian packages it. Requires: the file that includes this one sets waywright_triplet and all
# other differences. CMAKE_FIND_ROOT_PATH may name further folders with packages for the target.

string(REGEX MATCH "^[^-]+" CMAKE_SYSTEM_PROCESSOR ${waywright_triplet})
if(NOT CMAKE_SYSTEM_NAME)
  set(CMAKE_SYSTEM_NAME Linux)
endif()
if(NOT CMAKE_CXX_COMPILER)
  set(CMAKE_CXX_COMPILER ${waywright_triplet}-g++)
endif()

list(APPEND CMAKE_FIND_ROOT_PATH /usr/${waywright_triplet})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
