// SPDX-License-Identifier: MIT
//
// Eight floats at a time, with the same bits whatever the machine. Nothing here reduces across
// lanes, so lane k of a result depends on lane k of the inputs alone; together with
// -ffp-contract=off that makes a run's hash independent of the instruction set. min and max are
// compares because minps and its scalar relatives disagree about NaN and -0.
//
// GCC and clang vector extensions: the compiler splits a Wide into what the target has (two SSE
// registers, one AVX).
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

namespace jostle::physics {

#define JOSTLE_INLINE inline __attribute__((always_inline))

typedef float Wide __attribute__((vector_size(32)));
typedef std::int32_t WideMask __attribute__((vector_size(32)));
typedef float Quad __attribute__((vector_size(16)));

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
JOSTLE_INLINE Wide select(WideMask m, Wide a, Wide b) {
    return m ? a : b;
}
JOSTLE_INLINE Wide max(Wide a, Wide b) {
    return select(a > b, a, b);
}
JOSTLE_INLINE Wide min(Wide a, Wide b) {
    return select(a < b, a, b);
}
JOSTLE_INLINE Wide root(Wide a) {
    Wide r{};
    for (int i = 0; i < 8; i++) r[i] = std::sqrt(a[i]);
    return r;
}
// One bit per lane: lane k sets bit k.
JOSTLE_INLINE unsigned lane_bits(WideMask m) {
    unsigned r = 0;
    for (int i = 0; i < 8; i++) r |= static_cast<unsigned>(m[i] & 1) << i;
    return r;
}

struct Wide3 {
    Wide x, y, z;
};
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
JOSTLE_INLINE Wide dot(Wide3 a, Wide3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
JOSTLE_INLINE Wide3 cross(Wide3 a, Wide3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Turns a 4x4 block on its side.
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

// Reads one 32-byte row of eight bodies and turns it on its side: out[k] holds float k of all
// eight. Rows are 16-byte aligned at least.
JOSTLE_INLINE void load_rows(const float* const rows[8], Wide out[8]) {
    for (int half = 0; half < 2; half++) {
        Quad q[8];
        for (int k = 0; k < 8; k++)
            q[k] = *static_cast<const Quad*>(static_cast<const void*>(rows[k] + 4 * half));
        transpose4(q[0], q[1], q[2], q[3]);
        transpose4(q[4], q[5], q[6], q[7]);
        for (int k = 0; k < 4; k++)
            out[4 * half + k] = __builtin_shufflevector(q[k], q[k + 4], 0, 1, 2, 3, 4, 5, 6, 7);
    }
}

JOSTLE_INLINE void store_rows(float* const rows[8], const Wide in[8]) {
    for (int half = 0; half < 2; half++) {
        Quad q[8];
        for (int k = 0; k < 4; k++) {
            q[k] = __builtin_shufflevector(in[4 * half + k], in[4 * half + k], 0, 1, 2, 3);
            q[k + 4] = __builtin_shufflevector(in[4 * half + k], in[4 * half + k], 4, 5, 6, 7);
        }
        transpose4(q[0], q[1], q[2], q[3]);
        transpose4(q[4], q[5], q[6], q[7]);
        for (int k = 0; k < 8; k++)
            *static_cast<Quad*>(static_cast<void*>(rows[k] + 4 * half)) = q[k];
    }
}

}  // namespace jostle::physics
