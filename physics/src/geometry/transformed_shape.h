// SPDX-License-Identifier: MIT
//
// A shape where it stands: what collision, bounds and ray casts work on. They have never heard of a
// body.
#pragma once

#include "jostle/physics/geometry.h"
#include "jostle/physics/transform.h"

namespace jostle::physics {

struct TransformedShape {
    const Geometry* geometry = nullptr;
    Vec3 position;  // of the shape's origin, m
    Mat3 axes;      // columns: the shape's axes
};

inline TransformedShape transformed_shape(const Geometry& geometry, const Transform& pose) {
    return {&geometry, pose.position, to_matrix(pose.rotation)};
}

}  // namespace jostle::physics
