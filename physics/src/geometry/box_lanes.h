// SPDX-License-Identifier: MIT
//
// Four boxes in SIMD layout, in single precision. Each is at least as large as its double-precision
// original, so that a tree or a grid can reject four boxes at a time. The remaining ones are tested
// exactly, so results do not depend on single precision.
#pragma once

#include <cstdint>

#include "jostle/base/check.h"
#include "jostle/physics/aabb.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace jostle::physics {

// 16-byte vectors, which all x86-64 and ARM64 processors support.
typedef float Float4 __attribute__((vector_size(16)));
typedef std::int32_t Mask4 __attribute__((vector_size(16)));

inline Float4 splat4(float f) {
    return Float4{f, f, f, f};
}
inline Float4 larger4(Float4 a, Float4 b) {
    return a > b ? a : b;
}
inline Float4 smaller4(Float4 a, Float4 b) {
    return a < b ? a : b;
}
// Returns a mask with bit k set for lane k.
inline unsigned lanes_set(Mask4 mask) {
#if defined(__SSE2__)
    return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
#else
    return (mask[0] != 0 ? 1u : 0u) | (mask[1] != 0 ? 2u : 0u) | (mask[2] != 0 ? 4u : 0u) |
           (mask[3] != 0 ? 8u : 0u);
#endif
}
// Reciprocal square root estimates differ between processor vendors, so an exact square root is
// required.
inline Float4 root4(Float4 a) {
#if defined(__SSE2__)
    return reinterpret_cast<Float4>(_mm_sqrt_ps(reinterpret_cast<__m128>(a)));
#else
    Float4 r;
    for (int k = 0; k < 4; k++) r[k] = __builtin_sqrtf(a[k]);
    return r;
#endif
}

// Larger than the coordinates of any shape.
inline constexpr double lanes_far = 1e30;

// Conversions to float that round down and up.
inline float float_below(double d) {
    const float f = static_cast<float>(clamp(d, -lanes_far, lanes_far));
    return f - (f < 0 ? -f : f) * 1.2e-7f - 1e-37f;
}
inline float float_above(double d) {
    return -float_below(-d);
}

struct BoxLanes {
    Float4 low[3], high[3];

    void put(int lane, const Aabb& box) {
        ASSERT(lane >= 0 && lane < 4);
        for (int k = 0; k < 3; k++) {
            low[k][lane] = float_below(box.low[k]);
            high[k][lane] = float_above(box.high[k]);
        }
    }
    // An empty box, which nothing overlaps and no ray hits.
    void put_empty(int lane) {
        ASSERT(lane >= 0 && lane < 4);
        for (int k = 0; k < 3; k++) {
            low[k][lane] = static_cast<float>(lanes_far);
            high[k][lane] = -static_cast<float>(lanes_far);
        }
    }
};

// Returns which of the four boxes overlap the box that fills all four lanes of `one`.
inline unsigned overlapping(const BoxLanes& one, const BoxLanes& boxes) {
    Mask4 meets = (boxes.low[0] <= one.high[0]) & (boxes.high[0] >= one.low[0]);
    for (int k = 1; k < 3; k++)
        meets &= (boxes.low[k] <= one.high[k]) & (boxes.high[k] >= one.low[k]);
    return lanes_set(meets);
}
inline BoxLanes broadcast(const Aabb& box) {
    BoxLanes lanes;
    for (int k = 0; k < 3; k++) {
        lanes.low[k] = splat4(float_below(box.low[k]));
        lanes.high[k] = splat4(float_above(box.high[k]));
    }
    return lanes;
}

// Tests a segment against four boxes: which it may enter within [0, limit], and approximately
// where. Boxes are enlarged by more than the rounding error of single precision.
class RayOverlap {
public:
    RayOverlap(Vec3 origin, Vec3 motion) {
        for (int k = 0; k < 3; k++) {
            const double m = motion[k];
            const double least = 1 / lanes_far;
            const double per = absolute(m) < least ? lanes_far : 1 / m;
            origin_[k] = splat4(static_cast<float>(origin[k]));
            slack_[k] = splat4(static_cast<float>(1e-6 * (absolute(origin[k]) + absolute(m))));
            per_[k] = splat4(static_cast<float>(per));
        }
    }
    unsigned operator()(const BoxLanes& boxes, double limit, Float4& enters) const {
        Float4 enter = splat4(0), leave = splat4(float_above(limit));
        for (int k = 0; k < 3; k++) {
            const Float4 one = ((boxes.low[k] - slack_[k]) - origin_[k]) * per_[k];
            const Float4 other = ((boxes.high[k] + slack_[k]) - origin_[k]) * per_[k];
            enter = larger4(enter, smaller4(one, other));
            leave = smaller4(leave, larger4(one, other));
        }
        enters = enter;
        return lanes_set((enter <= leave) & (boxes.low[0] <= boxes.high[0]));
    }

private:
    Float4 origin_[3], slack_[3], per_[3];
};

}  // namespace jostle::physics
