// SPDX-License-Identifier: MIT
//
// SIMD arithmetic on eight floats with the same bits on every machine. No operation reduces across
// lanes, so lane k of a result depends on lane k of the inputs only. Together with
// -ffp-contract=off this makes the state hash independent of the instruction set: fused operations
// are written explicitly with fma(), and a portable build fuses none. min and max are comparisons
// because minps and its scalar counterparts differ for NaN and -0.
//
// Uses GCC and clang vector extensions: the compiler maps a Wide to the target's registers (two SSE
// registers, one AVX register). Included by one source per instruction set
// (constraints/kernels_*.cpp). Each source defines its own namespace, because code built for one
// CPU must not be linked into the path of another. One of them defines JOSTLE_TWO_BLOCKS: sixteen
// lanes, which are two adjacent blocks of eight, for the passes over contacts only.
#pragma once

#include <cstdint>

#if defined(__AVX2__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

#include "physics/src/math/fused.h"

#ifndef JOSTLE_ISA
#define JOSTLE_ISA baseline
#endif

namespace jostle::physics::JOSTLE_ISA {

#if defined(JOSTLE_SCALAR) || defined(JOSTLE_SMALL)
#define JOSTLE_INLINE inline  // force-inlining takes minutes to compile and produces large code
#else
#define JOSTLE_INLINE inline __attribute__((always_inline))
#endif

// For loops over the points of a manifold, whose values should stay in registers.
#if defined(__clang__) || defined(JOSTLE_SCALAR)
#define JOSTLE_UNROLL
#else
#define JOSTLE_UNROLL _Pragma("GCC unroll 4")
#endif

#if defined(JOSTLE_TWO_BLOCKS)
inline constexpr int lane_count = 16;
#else
inline constexpr int lane_count = 8;
#endif

#if defined(JOSTLE_SCALAR)
// Plain loops over eight floats, to verify that the results do not depend on the vector unit.
struct alignas(32) Wide {
    float lane[8];
    float& operator[](int i) { return lane[i]; }
    float operator[](int i) const { return lane[i]; }
};
struct alignas(32) WideMask {
    std::int32_t lane[8];
    std::int32_t operator[](int i) const { return lane[i]; }
};
#define JOSTLE_LANES(Result, Arguments, op, value)     \
    JOSTLE_INLINE Result operator op Arguments {       \
        Result r;                                      \
        for (int i = 0; i < 8; i++) r.lane[i] = value; \
        return r;                                      \
    }
JOSTLE_LANES(Wide, (Wide a, Wide b), +, a[i] + b[i])
JOSTLE_LANES(Wide, (Wide a, Wide b), -, a[i] - b[i])
JOSTLE_LANES(Wide, (Wide a, Wide b), *, a[i] * b[i])
JOSTLE_LANES(Wide, (Wide a, Wide b), /, a[i] / b[i])
JOSTLE_LANES(Wide, (Wide a), -, -a[i])
JOSTLE_LANES(WideMask, (Wide a, Wide b), <, a[i] < b[i] ? -1 : 0)
JOSTLE_LANES(WideMask, (Wide a, Wide b), >, a[i] > b[i] ? -1 : 0)
JOSTLE_LANES(WideMask, (Wide a, Wide b), >=, a[i] >= b[i] ? -1 : 0)
JOSTLE_LANES(WideMask, (WideMask a, WideMask b), &, a[i] & b[i])
JOSTLE_LANES(WideMask, (WideMask a, WideMask b), |, a[i] | b[i])
JOSTLE_LANES(WideMask, (WideMask a), ~, ~a[i])
#undef JOSTLE_LANES
JOSTLE_INLINE Wide& operator+=(Wide& a, Wide b) {
    return a = a + b;
}
JOSTLE_INLINE Wide& operator-=(Wide& a, Wide b) {
    return a = a - b;
}
JOSTLE_INLINE Wide select(WideMask m, Wide a, Wide b) {
    Wide r;
    for (int i = 0; i < 8; i++) r.lane[i] = m[i] != 0 ? a[i] : b[i];
    return r;
}
#else
typedef float Wide __attribute__((vector_size(4 * lane_count)));
typedef std::int32_t WideMask __attribute__((vector_size(4 * lane_count)));
typedef float Quad __attribute__((vector_size(16)));

JOSTLE_INLINE Wide select(WideMask m, Wide a, Wide b) {
    return m ? a : b;
}
#if !defined(JOSTLE_TWO_BLOCKS)
JOSTLE_INLINE Quad low_half(Wide w) {
    return __builtin_shufflevector(w, w, 0, 1, 2, 3);
}
JOSTLE_INLINE Quad high_half(Wide w) {
    return __builtin_shufflevector(w, w, 4, 5, 6, 7);
}
#endif
#endif

#if defined(JOSTLE_TWO_BLOCKS)
JOSTLE_INLINE Wide splat(float f) {
    return _mm512_set1_ps(f);
}
// Two rows of eight floats, kApart floats from each other. p is 32-byte aligned.
template <int kApart>
JOSTLE_INLINE Wide load_two(const float* p) {
    return _mm512_insertf32x8(_mm512_castps256_ps512(_mm256_load_ps(p)), _mm256_load_ps(p + kApart),
                              1);
}
template <int kApart>
JOSTLE_INLINE void store_two(float* p, Wide w) {
    _mm256_store_ps(p, _mm512_castps512_ps256(w));
    _mm256_store_ps(p + kApart, _mm512_extractf32x8_ps(w, 1));
}
#else
JOSTLE_INLINE Wide splat(float f) {
    return Wide{f, f, f, f, f, f, f, f};
}
// p is 32-byte aligned.
JOSTLE_INLINE Wide load(const float* p) {
    return *static_cast<const Wide*>(static_cast<const void*>(p));
}
JOSTLE_INLINE void store(float* p, Wide w) {
    *static_cast<Wide*>(static_cast<void*>(p)) = w;
}
#endif
// a > b ? a : b, which matches the x86 maximum instruction for NaN and signed zeros.
JOSTLE_INLINE Wide max(Wide a, Wide b) {
#if defined(JOSTLE_TWO_BLOCKS)
    return _mm512_max_ps(a, b);
#elif defined(__AVX2__) && !defined(JOSTLE_SCALAR)
    return _mm256_max_ps(a, b);
#else
    return select(a > b, a, b);
#endif
}
JOSTLE_INLINE Wide min(Wide a, Wide b) {
#if defined(JOSTLE_TWO_BLOCKS)
    return _mm512_min_ps(a, b);
#elif defined(__AVX2__) && !defined(JOSTLE_SCALAR)
    return _mm256_min_ps(a, b);
#else
    return select(a < b, a, b);
#endif
}
JOSTLE_INLINE Wide root(Wide a) {
#if defined(JOSTLE_TWO_BLOCKS)
    return _mm512_sqrt_ps(a);
#elif defined(__AVX2__) && !defined(JOSTLE_SCALAR)
    return _mm256_sqrt_ps(a);
#else
    Wide r{};
    for (int i = 0; i < 8; i++) r[i] = __builtin_sqrtf(a[i]);
    return r;
#endif
}
// a b + c with a single rounding on every machine, in one instruction where available. In a
// portable build it is rounded twice on every machine.
JOSTLE_INLINE Wide fma(Wide a, Wide b, Wide c) {
#if defined(JOSTLE_UNFUSED)
    return a * b + c;
#elif defined(JOSTLE_TWO_BLOCKS)
    return _mm512_fmadd_ps(a, b, c);
#elif defined(__FMA__) && !defined(JOSTLE_SCALAR)
    return _mm256_fmadd_ps(a, b, c);
#elif defined(__aarch64__) && !defined(JOSTLE_SCALAR)
    const auto half = [&](Quad x, Quad y, Quad z) { return static_cast<Quad>(vfmaq_f32(z, x, y)); };
    const Quad low = half(low_half(a), low_half(b), low_half(c)),
               high = half(high_half(a), high_half(b), high_half(c));
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#else
    Wide r{};
    for (int i = 0; i < 8; i++) r[i] = fused_multiply_add(a[i], b[i], c[i]);
    return r;
#endif
}
// c - a b, with the same rounding as fma().
JOSTLE_INLINE Wide fnma(Wide a, Wide b, Wide c) {
#if defined(JOSTLE_UNFUSED)
    return c - a * b;
#elif defined(JOSTLE_TWO_BLOCKS)
    return _mm512_fnmadd_ps(a, b, c);
#elif defined(__FMA__) && !defined(JOSTLE_SCALAR)
    return _mm256_fnmadd_ps(a, b, c);
#else
    return fma(-a, b, c);
#endif
}
// One bit per lane: lane k sets bit k.
JOSTLE_INLINE unsigned lane_bits(WideMask m) {
#if defined(JOSTLE_TWO_BLOCKS)
    return _mm512_movepi32_mask(reinterpret_cast<__m512i>(m));
#elif defined(__AVX2__)
    return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<Wide>(m)));
#else
    unsigned r = 0;
    for (int i = 0; i < 8; i++) r |= (m[i] != 0 ? 1u : 0u) << i;
    return r;
#endif
}

struct Wide3 {
    Wide x, y, z;
};
JOSTLE_INLINE Wide absolute(Wide a) {
    return max(a, -a);
}
JOSTLE_INLINE Wide3 select(WideMask m, Wide3 a, Wide3 b) {
    return {select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z)};
}
JOSTLE_INLINE Wide3 operator+(Wide3 a, Wide3 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
JOSTLE_INLINE Wide3 operator-(Wide3 a, Wide3 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
JOSTLE_INLINE Wide3 operator-(Wide3 a) {
    return {-a.x, -a.y, -a.z};
}
JOSTLE_INLINE Wide3 operator*(Wide3 a, Wide s) {
    return {a.x * s, a.y * s, a.z * s};
}
// a s + c.
JOSTLE_INLINE Wide3 fma(Wide3 a, Wide s, Wide3 c) {
    return {fma(a.x, s, c.x), fma(a.y, s, c.y), fma(a.z, s, c.z)};
}
JOSTLE_INLINE Wide dot(Wide3 a, Wide3 b) {
    return fma(a.z, b.z, fma(a.y, b.y, a.x * b.x));
}
JOSTLE_INLINE Wide3 cross(Wide3 a, Wide3 b) {
    return {fnma(a.z, b.y, a.y * b.z), fnma(a.x, b.z, a.z * b.x), fnma(a.y, b.x, a.x * b.y)};
}

#if defined(JOSTLE_SCALAR)
JOSTLE_INLINE void load_rows(const float* const rows[8], int at, Wide out[8]) {
    for (int k = 0; k < 8; k++)
        for (int lane = 0; lane < 8; lane++) out[k][lane] = rows[lane][at + k];
}
JOSTLE_INLINE void store_rows(float* const rows[8], const Wide in[8]) {
    for (int k = 0; k < 8; k++)
        for (int lane = 0; lane < 8; lane++) rows[lane][k] = in[k][lane];
}
#elif defined(JOSTLE_TWO_BLOCKS)
// Transposes a 4x4 block in each quarter of the registers.
JOSTLE_INLINE void transpose4(Wide& a, Wide& b, Wide& c, Wide& d) {
    const Wide ab_low = _mm512_unpacklo_ps(a, b), ab_high = _mm512_unpackhi_ps(a, b);
    const Wide cd_low = _mm512_unpacklo_ps(c, d), cd_high = _mm512_unpackhi_ps(c, d);
    a = _mm512_shuffle_ps(ab_low, cd_low, 0x44);
    b = _mm512_shuffle_ps(ab_low, cd_low, 0xee);
    c = _mm512_shuffle_ps(ab_high, cd_high, 0x44);
    d = _mm512_shuffle_ps(ab_high, cd_high, 0xee);
}

// Same as for eight lanes below. A register holds two complete rows; the columns combine low and
// high halves of two others. Lanes 4q + k of a column are its rows k, k + 4, k + 8, k + 12.
JOSTLE_INLINE void load_rows(const float* const rows[16], int at, Wide out[8]) {
    for (int k = 0; k < 4; k++) {
        const Wide near = _mm512_insertf32x8(_mm512_castps256_ps512(_mm256_load_ps(rows[k] + at)),
                                             _mm256_load_ps(rows[k + 8] + at), 1);
        const Wide far =
            _mm512_insertf32x8(_mm512_castps256_ps512(_mm256_load_ps(rows[k + 4] + at)),
                               _mm256_load_ps(rows[k + 12] + at), 1);
        // Quarters of `near`: row k low and high, row k + 8 low and high.
        out[k] = __builtin_shufflevector(near, far, 0, 1, 2, 3, 16, 17, 18, 19, 8, 9, 10, 11, 24,
                                         25, 26, 27);
        out[4 + k] = __builtin_shufflevector(near, far, 4, 5, 6, 7, 20, 21, 22, 23, 12, 13, 14, 15,
                                             28, 29, 30, 31);
    }
    transpose4(out[0], out[1], out[2], out[3]);
    transpose4(out[4], out[5], out[6], out[7]);
}

JOSTLE_INLINE void store_rows(float* const rows[16], const Wide in[8]) {
    Wide low[4] = {in[0], in[1], in[2], in[3]}, high[4] = {in[4], in[5], in[6], in[7]};
    transpose4(low[0], low[1], low[2], low[3]);
    transpose4(high[0], high[1], high[2], high[3]);
    for (int k = 0; k < 4; k++) {
        const Wide near = __builtin_shufflevector(low[k], high[k], 0, 1, 2, 3, 16, 17, 18, 19, 8, 9,
                                                  10, 11, 24, 25, 26, 27);
        const Wide far = __builtin_shufflevector(low[k], high[k], 4, 5, 6, 7, 20, 21, 22, 23, 12,
                                                 13, 14, 15, 28, 29, 30, 31);
        _mm256_store_ps(rows[k], _mm512_castps512_ps256(near));
        _mm256_store_ps(rows[k + 4], _mm512_castps512_ps256(far));
        _mm256_store_ps(rows[k + 8], _mm512_extractf32x8_ps(near, 1));
        _mm256_store_ps(rows[k + 12], _mm512_extractf32x8_ps(far, 1));
    }
}
#else
// Transposes a 4x4 block in each half of the registers.
template <class V>
JOSTLE_INLINE void transpose4(V& a, V& b, V& c, V& d);

template <>
JOSTLE_INLINE void transpose4(Quad& a, Quad& b, Quad& c, Quad& d) {
    const Quad ab_low = __builtin_shufflevector(a, b, 0, 4, 1, 5);
    const Quad ab_high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    const Quad cd_low = __builtin_shufflevector(c, d, 0, 4, 1, 5);
    const Quad cd_high = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    a = __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5);
    b = __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7);
    c = __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5);
    d = __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7);
}

#if defined(__AVX2__)
template <>
JOSTLE_INLINE void transpose4(Wide& a, Wide& b, Wide& c, Wide& d) {
    const __m256 ab_low = _mm256_unpacklo_ps(a, b), ab_high = _mm256_unpackhi_ps(a, b);
    const __m256 cd_low = _mm256_unpacklo_ps(c, d), cd_high = _mm256_unpackhi_ps(c, d);
    a = _mm256_shuffle_ps(ab_low, cd_low, 0x44);
    b = _mm256_shuffle_ps(ab_low, cd_low, 0xee);
    c = _mm256_shuffle_ps(ab_high, cd_high, 0x44);
    d = _mm256_shuffle_ps(ab_high, cd_high, 0xee);
}
#endif

JOSTLE_INLINE Quad load_quad(const float* p) {
    return *static_cast<const Quad*>(static_cast<const void*>(p));
}

JOSTLE_INLINE void store_quad(float* p, Quad q) {
    *static_cast<Quad*>(static_cast<void*>(p)) = q;
}

// Loads and transposes eight 32-byte rows that start at float `at` of each pointer: out[k] holds
// float k of all rows. Rows are at least 16-byte aligned. Halves of two rows share a register, so
// that every shuffle stays within a half.
JOSTLE_INLINE void load_rows(const float* const rows[8], int at, Wide out[8]) {
    for (int half = 0; half < 8; half += 4) {
#if defined(__AVX2__)
        for (int k = 0; k < 4; k++)
            out[half + k] =
                _mm256_insertf128_ps(_mm256_castps128_ps256(load_quad(rows[k] + at + half)),
                                     load_quad(rows[k + 4] + at + half), 1);
        transpose4(out[half], out[half + 1], out[half + 2], out[half + 3]);
#else
        Quad q[8];
        for (int k = 0; k < 8; k++) q[k] = load_quad(rows[k] + at + half);
        transpose4(q[0], q[1], q[2], q[3]);
        transpose4(q[4], q[5], q[6], q[7]);
        for (int k = 0; k < 4; k++)
            out[half + k] = __builtin_shufflevector(q[k], q[k + 4], 0, 1, 2, 3, 4, 5, 6, 7);
#endif
    }
}

JOSTLE_INLINE void store_rows(float* const rows[8], const Wide in[8]) {
    for (int half = 0; half < 8; half += 4) {
#if defined(__AVX2__)
        Wide w[4] = {in[half], in[half + 1], in[half + 2], in[half + 3]};
        transpose4(w[0], w[1], w[2], w[3]);
        for (int k = 0; k < 4; k++) {
            store_quad(rows[k] + half, _mm256_castps256_ps128(w[k]));
            store_quad(rows[k + 4] + half, _mm256_extractf128_ps(w[k], 1));
        }
#else
        Quad q[8];
        for (int k = 0; k < 4; k++) {
            const Wide w = in[half + k];
            q[k] = low_half(w);
            q[k + 4] = high_half(w);
        }
        transpose4(q[0], q[1], q[2], q[3]);
        transpose4(q[4], q[5], q[6], q[7]);
        for (int k = 0; k < 8; k++) store_quad(rows[k] + half, q[k]);
#endif
    }
}

#endif

}  // namespace jostle::physics::JOSTLE_ISA
