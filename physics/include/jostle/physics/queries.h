// SPDX-License-Identifier: MIT
//
// Questions to a world between steps. Answers do not depend on the broad phase's internals: ties go
// to the lower id.
#pragma once

#include "jostle/physics/geometry.h"
#include "jostle/physics/ids.h"
#include "jostle/physics/transform.h"

namespace jostle::physics {

struct Ray {
    Vec3 origin;  // m
    Vec3 motion;  // m: the ray ends at origin + motion
};

struct RayHit {
    ShapeId shape;
    BodyId body;
    double fraction = 0;  // 0..1 of the motion; 0 when the origin is inside the shape
    Vec3 point;           // m, world
    Vec3 normal;  // unit, out of the shape; opposite to the motion when the origin is inside
};

}  // namespace jostle::physics
