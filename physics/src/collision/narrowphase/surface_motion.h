// SPDX-License-Identifier: MIT
#pragma once

#include "jostle/physics/vec3.h"

namespace jostle::physics {

// The motion of a shape relative to a surface that does not rotate while its contacts are valid.
struct SurfaceMotion {
    // m, world: from the pose of the narrow-phase test back to the start and on to the end.
    Vec3 to_start, to_end;
    Vec3 turn;        // rad, world: maximum rotation to either pose
    Vec3 center;      // m, world: centre of that rotation
    double near = 0;  // m
};

}  // namespace jostle::physics
