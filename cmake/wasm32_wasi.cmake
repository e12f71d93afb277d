# Toolchain: WebAssembly, with the system interface of WASI, by clang 19 and Debian's libraries for it. What is built runs in Node,
# as scripts/determinism-check does it (tests/determinism/run_wasi.mjs). Only the solver (JOSTLE_SOLVER_ONLY), and only as
# a portable build (JOSTLE_FUSED=OFF).
set(CMAKE_SYSTEM_NAME WASI)
set(CMAKE_SYSTEM_VERSION 1)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
# The solver throws nothing. Four lanes at a time are of the standard since 2021.
set(CMAKE_CXX_FLAGS_INIT "-fno-exceptions -msimd128")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-Wl,-z,stack-size=1048576")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_HAVE_LIBC_PTHREAD TRUE)  # nothing to link for threads: there are none
