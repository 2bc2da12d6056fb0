# SPDX-License-Identifier: MIT
# Toolchain: WebAssembly with 128-bit SIMD by Emscripten (Debian: emscripten). Exceptions are those of WebAssembly, so
# that a failed allocation is an error of shd and does not abort.
find_program(SHD_EMCC emcc REQUIRED)
file(REAL_PATH ${SHD_EMCC} shd_emcc)
get_filename_component(shd_emscripten ${shd_emcc} DIRECTORY)
include(${shd_emscripten}/cmake/Modules/Platform/Emscripten.cmake)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES SHD_WASM_THREADS)
set(CMAKE_C_FLAGS_INIT "-msimd128 -fwasm-exceptions")
if(SHD_WASM_THREADS)
  string(APPEND CMAKE_C_FLAGS_INIT " -pthread")
endif()
set(CMAKE_CXX_FLAGS_INIT "${CMAKE_C_FLAGS_INIT}")
set(hwy_DIR ${CMAKE_CURRENT_LIST_DIR}/../../tests/arm CACHE PATH "The headers of Highway alone")
set(CLI11_DIR ${CMAKE_CURRENT_LIST_DIR} CACHE PATH "The headers of CLI11 alone")
