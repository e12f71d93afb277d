// SPDX-License-Identifier: MIT
//
// Threads and mutexes, with single-threaded replacements. WebAssembly has no threads unless built
// with them, and its standard library then lacks the types as well.
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
