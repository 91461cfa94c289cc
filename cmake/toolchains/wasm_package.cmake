# WebAssembly for the package in bindings/wasm, by Debian's package of Emscripten: without threads, with the exceptions of
# WebAssembly. The other toolchain for WebAssembly takes exceptions through JavaScript, which costs time in each call.
set(EMSCRIPTEN_ROOT_PATH /usr/share/emscripten)
set(CMAKE_CXX_FLAGS_INIT "-fwasm-exceptions")
include(${EMSCRIPTEN_ROOT_PATH}/cmake/Modules/Platform/Emscripten.cmake)
