# SPDX-License-Identifier: MIT
# Toolchain: 64-bit ARM on Linux by Debian's cross compiler (g++-aarch64-linux-gnu). Programs are static, so that
# qemu-user runs them without libraries of that machine.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(hwy_DIR ${CMAKE_CURRENT_LIST_DIR} CACHE PATH "The headers of Highway alone")
