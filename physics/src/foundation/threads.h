// SPDX-License-Identifier: MIT
//
// Threads and what guards what they share, for the solver's few uses of them. WebAssembly has none
// unless it is built with them; its standard library then lacks the types, too.
#pragma once

#if defined(__wasm__) && !defined(__wasm_atomics__)
#define JOSTLE_NO_THREADS
#else
#include <mutex>
#include <thread>
#endif

namespace jostle::physics {

#if defined(JOSTLE_NO_THREADS)
struct Mutex {};
struct MutexLock {
    explicit MutexLock(Mutex&) {}
};
inline void yield_thread() {}
#else
using Mutex = std::mutex;
using MutexLock = std::lock_guard<std::mutex>;
inline void yield_thread() {
    std::this_thread::yield();
}
#endif

}  // namespace jostle::physics
