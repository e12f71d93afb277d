// SPDX-License-Identifier: MIT
//
// Floating-point mode of threads that step: denormal floats are flushed to zero and rounding is to
// nearest. Denormals would be a hundred times slower, and the host program may have changed either
// setting. A portable build (jostle/physics/arithmetic.h) preserves denormals, because WebAssembly
// cannot flush them and must give the same bits.
//
// FpModeScope restores the previous mode.
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
    // Sets flush-to-zero 0x8000 and denormals-are-zero 0x0040, clears the rounding bits 0x6000.
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
    // FZ is bit 24; the rounding mode is in bits 22 and 23.
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
