# Toolchain for 64-bit ARM on any Debian machine; the programs run there or with qemu user mode emulation.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)  # independent of the libraries of the target machine
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static)
