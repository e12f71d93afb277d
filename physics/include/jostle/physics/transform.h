// SPDX-License-Identifier: MIT
//
// Transform: where a frame is in its parent. Positions are double, so a world may be millions of
// metres wide.
#pragma once

#include "jostle/physics/quat.h"

namespace jostle::physics {

struct Transform {
    Vec3 position = {};  // m
    Quat rotation = {};

    bool operator==(const Transform&) const = default;
};

inline Vec3 apply(const Transform& t, Vec3 p) {
    return t.position + rotate(t.rotation, p);
}
inline Vec3 apply_inverse(const Transform& t, Vec3 p) {
    return inverse_rotate(t.rotation, p - t.position);
}
// The frame b, given in a, as seen from a's parent.
inline Transform compose(const Transform& a, const Transform& b) {
    return {apply(a, b.position), a.rotation * b.rotation};
}
inline bool is_finite(const Transform& t) {
    return is_finite(t.position) && is_finite(t.rotation);
}

}  // namespace jostle::physics
