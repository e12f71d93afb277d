// SPDX-License-Identifier: MIT
#pragma once

#include "jostle/physics/vec3.h"

namespace jostle::physics {

// How a shape moves against a surface that does not turn while its contacts hold.
struct SurfaceMotion {
    Vec3 to_start, to_end;  // m, world: from where it is looked at, back and on
    Vec3 turn;              // rad, world: at most, to either ...
    Vec3 center;            // m, world: ... about this point
    double near = 0;        // m
};

}  // namespace jostle::physics
