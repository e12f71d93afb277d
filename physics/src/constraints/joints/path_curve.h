// SPDX-License-Identifier: MIT
//
// The curve of a path joint in a's frame. Between two points it is a cubic (Catmull-Rom, uniform)
// or a straight line. The parameter k + t is between points k and k + 1.
#pragma once

#include "jostle/physics/joint_defs.h"

namespace jostle::physics {

struct PathPoint {
    double at = 0;         // parameter
    Vec3 position;         // m
    Quat rotation;         // x along the curve, y towards its centre of curvature
    double curvature = 0;  // 1/m
    double travel = 0;     // m, from the first point
};

// The point of the curve nearest to `point`: near the parameter `guess`, or on the whole curve.
PathPoint nearest_path_point(const PathJoint& path, Vec3 point, double guess);
PathPoint nearest_path_point(const PathJoint& path, Vec3 point);
PathPoint path_point_at(const PathJoint& path, double at);
// Parameter difference from `previous` to `at`, the shorter direction on a closed path.
double parameter_step(const PathJoint& path, double previous, double at);
double length_of(const PathJoint& path);  // m

}  // namespace jostle::physics
