# WebAssembly, by Debian's package of Emscripten, without threads and with exceptions. Node reads the program's file and
# the files that the program names.
set(EMSCRIPTEN_ROOT_PATH /usr/share/emscripten)
set(CMAKE_CXX_FLAGS_INIT "-fexceptions")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-sALLOW_MEMORY_GROWTH=1 -sNODERAWFS=1 -sEXIT_RUNTIME=1")
include(${EMSCRIPTEN_ROOT_PATH}/cmake/Modules/Platform/Emscripten.cmake)
