// SPDX-License-Identifier: MIT
//
// Rigid transforms.
#pragma once

#include "jostle/physics/quat.h"

namespace jostle::physics {

/// The pose of a frame in its parent frame. Positions are doubles, so a world may extend over
/// millions of metres.
struct Transform {
    Vec3 position = {};  ///< m
    Quat rotation = {};  ///< unit quaternion

    bool operator==(const Transform&) const = default;
};

/// Transforms a point from the frame to its parent.
inline Vec3 apply(const Transform& t, Vec3 p) {
    return t.position + rotate(t.rotation, p);
}
/// Transforms a point from the parent to the frame.
inline Vec3 apply_inverse(const Transform& t, Vec3 p) {
    return inverse_rotate(t.rotation, p - t.position);
}
/// Returns the pose of frame b, given in frame a, in a's parent.
inline Transform compose(const Transform& a, const Transform& b) {
    return {apply(a, b.position), a.rotation * b.rotation};
}
/// Returns true if all components are finite.
inline bool is_finite(const Transform& t) {
    return is_finite(t.position) && is_finite(t.rotation);
}

}  // namespace jostle::physics
