// SPDX-License-Identifier: MIT
//
// Every thread that steps runs with denormal floats flushed to zero and rounding to nearest:
// denormals would cost a hundred times as much, and a host program may have changed either. A
// portable build (jostle/physics/arithmetic.h) keeps denormals: WebAssembly cannot flush them, and
// its bits are the same there. The scope restores what it found.
#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace jostle::physics {

#if defined(JOSTLE_UNFUSED)
inline constexpr bool flushes_denormals = false;
#else
inline constexpr bool flushes_denormals = true;
#endif

class FpModeScope {
public:
    FpModeScope() : saved_(read()) { write(step_mode(saved_)); }
    ~FpModeScope() { write(saved_); }
    FpModeScope(const FpModeScope&) = delete;
    FpModeScope& operator=(const FpModeScope&) = delete;

private:
#if defined(__SSE2__)
    static std::uint64_t read() {
        return _mm_getcsr();
    }
    static void write(std::uint64_t mode) {
        _mm_setcsr(static_cast<unsigned>(mode));
    }
    // Flush-to-zero 0x8000, denormals-are-zero 0x0040, rounding bits 0x6000 cleared.
    static std::uint64_t step_mode(std::uint64_t mode) {
        return (mode & ~0xe040ull) | (flushes_denormals ? 0x8040 : 0);
    }
#elif defined(__aarch64__)
    static std::uint64_t read() {
        std::uint64_t mode;
        asm volatile("mrs %0, fpcr" : "=r"(mode));
        return mode;
    }
    static void write(std::uint64_t mode) {
        asm volatile("msr fpcr, %0" ::"r"(mode));
    }
    // FZ is bit 24, rounding mode bits 22 and 23.
    static std::uint64_t step_mode(std::uint64_t mode) {
        return (mode & ~(7ull << 22)) | (flushes_denormals ? 1ull << 24 : 0);
    }
#else
    static std::uint64_t read() {
        return 0;
    }
    static void write(std::uint64_t) {}
    static std::uint64_t step_mode(std::uint64_t mode) {
        return mode;
    }
#endif
    std::uint64_t saved_;
};

}  // namespace jostle::physics
