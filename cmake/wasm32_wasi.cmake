# Toolchain for WebAssembly with the WASI system interface: clang 19 and Debian's libraries. The programs run in Node,
# as in scripts/determinism-check (tests/determinism/run_wasi.mjs). Supports only the solver (JOSTLE_SOLVER_ONLY) as a
# portable build (JOSTLE_FUSED=OFF).
set(CMAKE_SYSTEM_NAME WASI)
set(CMAKE_SYSTEM_VERSION 1)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
# The solver throws no exceptions. 128-bit SIMD is part of the WebAssembly standard since 2021.
set(CMAKE_CXX_FLAGS_INIT "-fno-exceptions -msimd128")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-Wl,-z,stack-size=1048576")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_HAVE_LIBC_PTHREAD TRUE)  # no library to link: there are no threads
