// SPDX-License-Identifier: MIT
#include "jostle/client/pose_error.h"

#include <algorithm>
#include <cmath>

namespace jostle::client {
namespace {

using Quaternion = std::array<double, 4>;

constexpr double half_life_s = 0.1, longest_walk_s = 3;
constexpr double least_speed = 1.1, least_spin = 1.5, share_of_pace = 0.35;
constexpr double nothing_m = 1e-5, nothing_rad = 1e-5;

Quaternion product(const Quaternion& a, const Quaternion& b) {
    return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
            a[3] * b[1] + a[1] * b[3] + a[2] * b[0] - a[0] * b[2],
            a[3] * b[2] + a[2] * b[3] + a[0] * b[1] - a[1] * b[0],
            a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

double length_of(const std::array<double, 3>& v) {
    return std::hypot(v[0], v[1], v[2]);
}

// Of a rotation with w >= 0.
double angle_of(const Quaternion& q) {
    return 2 * std::atan2(std::hypot(q[0], q[1], q[2]), q[3]);
}

// The same axis, another angle.
Quaternion turned_to(const Quaternion& q, double angle) {
    const double length = std::hypot(q[0], q[1], q[2]);
    if (length == 0) return {0, 0, 0, 1};
    const double scale = std::sin(angle / 2) / length;
    return {q[0] * scale, q[1] * scale, q[2] * scale, std::cos(angle / 2)};
}

double speed_of_walk(const BodySpeed& pace) {
    return std::max(least_speed, share_of_pace * pace.speed);
}

double spin_of_walk(const BodySpeed& pace) {
    return std::max(least_spin, share_of_pace * pace.spin);
}

double left_of(double error, double most_speed, double seconds) {
    return std::max(error * std::exp2(-seconds / half_life_s), error - most_speed * seconds);
}

}  // namespace

PoseError pose_error(const wire::Pose& shown, const wire::Pose& right) {
    PoseError error;
    for (std::size_t k = 0; k < 3; k++) error.position[k] = shown.position[k] - right.position[k];
    const Quaternion& q = right.rotation;
    error.rotation = product(shown.rotation, {-q[0], -q[1], -q[2], q[3]});
    if (error.rotation[3] < 0)
        for (double& c : error.rotation) c = -c;  // the shorter way
    return error;
}

wire::Pose apply_error(const wire::Pose& right, const PoseError& error) {
    if (error.none()) return right;
    wire::Pose shown;
    for (std::size_t k = 0; k < 3; k++) shown.position[k] = right.position[k] + error.position[k];
    shown.rotation = product(error.rotation, right.rotation);
    double norm = 0;
    for (const double c : shown.rotation) norm += c * c;
    for (double& c : shown.rotation) c /= std::sqrt(norm);
    return shown;
}

PoseError decayed(const PoseError& error, const BodySpeed& pace, double seconds) {
    if (error.none()) return error;
    PoseError left;
    const double distance = length_of(error.position);
    const double still = left_of(distance, speed_of_walk(pace), seconds);
    if (still > nothing_m)
        for (std::size_t k = 0; k < 3; k++) left.position[k] = error.position[k] * still / distance;
    const double angle = left_of(angle_of(error.rotation), spin_of_walk(pace), seconds);
    if (angle > nothing_rad) left.rotation = turned_to(error.rotation, angle);
    return left;
}

PoseError smoothable_error(const PoseError& error, const BodySpeed& pace) {
    PoseError kept = error;
    if (length_of(error.position) > longest_walk_s * speed_of_walk(pace)) kept = {};
    return kept;
}

}  // namespace jostle::client
