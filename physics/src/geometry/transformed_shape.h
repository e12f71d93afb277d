// SPDX-License-Identifier: MIT
//
// A shape with its world pose: the input of collision, bounds and ray casts, which do not depend on
// bodies.
#pragma once

#include "jostle/physics/geometry.h"
#include "jostle/physics/transform.h"

namespace jostle::physics {

struct TransformedShape {
    const Geometry* geometry = nullptr;
    Vec3 position;  // of the shape's origin, m
    Mat3 axes;      // columns: the axes of the shape
};

inline TransformedShape transformed_shape(const Geometry& geometry, const Transform& pose) {
    return {&geometry, pose.position, to_matrix(pose.rotation)};
}

}  // namespace jostle::physics
