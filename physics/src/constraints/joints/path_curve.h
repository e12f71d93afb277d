// SPDX-License-Identifier: MIT
//
// The curve of a path joint in a's frame. Between two points it is a cubic (Catmull-Rom, uniform)
// or a straight line. The parameter k + t is between points k and k + 1.
#pragma once

#include <vector>

#include "jostle/physics/joint_defs.h"

namespace jostle::physics {

struct PathPoint {
    double at = 0;         // parameter
    Vec3 position;         // m
    Quat rotation;         // x along the curve, y towards its centre of curvature
    double curvature = 0;  // 1/m
    double travel = 0;     // m, from the first point
};

// The same without the travel, which takes an integral over all pieces.
struct CurvePoint {
    Vec3 position, tangent;  // m; unit
    double curvature = 0;    // 1/m
};
CurvePoint curve_point_at(const PathJoint& path, double at);
// The parameter of the point of the curve nearest to `point`, near the parameter `guess`. The
// parameter of a closed path counts laps: it is not reduced to the pieces.
double follow_path(const PathJoint& path, Vec3 point, double guess);
// Travel at the first point of each piece, and at the end, m.
std::vector<double> piece_travels(const PathJoint& path);
// Travel at a parameter that may count laps.
double travel_at(const PathJoint& path, const std::vector<double>& travels, double at);

double path_speed_at(const PathJoint& path, double at);  // m per unit of the parameter
// Sum of the jumps of curvature at the points between two parameters, 1/m. A polyline has kinks
// there, of infinite curvature.
double curvature_jumps(const PathJoint& path, double from, double to);

// The point of the curve nearest to `point`: near the parameter `guess`, or on the whole curve.
PathPoint nearest_path_point(const PathJoint& path, Vec3 point, double guess);
PathPoint nearest_path_point(const PathJoint& path, Vec3 point);
PathPoint path_point_at(const PathJoint& path, double at);
// Parameter difference from `previous` to `at`, the shorter direction on a closed path.
double parameter_step(const PathJoint& path, double previous, double at);
// A parameter that counts laps, reduced to the pieces.
double parameter_within(const PathJoint& path, double at);
double length_of(const PathJoint& path);  // m

}  // namespace jostle::physics
