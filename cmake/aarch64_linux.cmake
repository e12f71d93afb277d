# Toolchain: 64-bit ARM from any Debian machine; what is built runs there or under qemu's user mode.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)   # so that it needs none of the other machine's libraries
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static)
