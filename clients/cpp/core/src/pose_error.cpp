// SPDX-License-Identifier: MIT
#include "jostle/client/pose_error.h"

#include <algorithm>
#include <cmath>

namespace jostle::client {
namespace {

using Quaternion = std::array<double, 4>;

constexpr double half_life_s = 0.1, correction_time_max_s = 3;
constexpr double correction_speed_min = 1.1, correction_spin_min = 1.5,
                 correction_speed_ratio = 0.35;
constexpr double negligible_m = 1e-5, negligible_rad = 1e-5;

Quaternion product(const Quaternion& a, const Quaternion& b) {
    return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
            a[3] * b[1] + a[1] * b[3] + a[2] * b[0] - a[0] * b[2],
            a[3] * b[2] + a[2] * b[3] + a[0] * b[1] - a[1] * b[0],
            a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

double length_of(const std::array<double, 3>& v) {
    return std::hypot(v[0], v[1], v[2]);
}

// Angle of a rotation with w >= 0.
double angle_of(const Quaternion& q) {
    return 2 * std::atan2(std::hypot(q[0], q[1], q[2]), q[3]);
}

// The same axis with another angle.
Quaternion turned_to(const Quaternion& q, double angle) {
    const double length = std::hypot(q[0], q[1], q[2]);
    if (length == 0) return {0, 0, 0, 1};
    const double scale = std::sin(angle / 2) / length;
    return {q[0] * scale, q[1] * scale, q[2] * scale, std::cos(angle / 2)};
}

double correction_speed(const BodySpeed& body_speed) {
    return std::max(correction_speed_min, correction_speed_ratio * body_speed.speed);
}

double correction_spin(const BodySpeed& body_speed) {
    return std::max(correction_spin_min, correction_speed_ratio * body_speed.spin);
}

double remaining_error(double error, double max_speed, double seconds) {
    return std::max(error * std::exp2(-seconds / half_life_s), error - max_speed * seconds);
}

}  // namespace

PoseError pose_error(const snapshot::Pose& rendered, const snapshot::Pose& target) {
    PoseError error;
    for (std::size_t k = 0; k < 3; k++)
        error.position[k] = rendered.position[k] - target.position[k];
    const Quaternion& q = target.rotation;
    error.rotation = product(rendered.rotation, {-q[0], -q[1], -q[2], q[3]});
    if (error.rotation[3] < 0)
        for (double& c : error.rotation) c = -c;  // the shorter arc
    return error;
}

snapshot::Pose apply_error(const snapshot::Pose& target, const PoseError& error) {
    if (error.none()) return target;
    snapshot::Pose rendered;
    for (std::size_t k = 0; k < 3; k++)
        rendered.position[k] = target.position[k] + error.position[k];
    rendered.rotation = product(error.rotation, target.rotation);
    double norm = 0;
    for (const double c : rendered.rotation) norm += c * c;
    for (double& c : rendered.rotation) c /= std::sqrt(norm);
    return rendered;
}

PoseError decayed(const PoseError& error, const BodySpeed& body_speed, double seconds) {
    if (error.none()) return error;
    PoseError rest;
    const double distance = length_of(error.position);
    const double remaining = remaining_error(distance, correction_speed(body_speed), seconds);
    if (remaining > negligible_m)
        for (std::size_t k = 0; k < 3; k++)
            rest.position[k] = error.position[k] * remaining / distance;
    const double angle =
        remaining_error(angle_of(error.rotation), correction_spin(body_speed), seconds);
    if (angle > negligible_rad) rest.rotation = turned_to(error.rotation, angle);
    return rest;
}

PoseError smoothable_error(const PoseError& error, const BodySpeed& body_speed) {
    PoseError result = error;
    if (length_of(error.position) > correction_time_max_s * correction_speed(body_speed))
        result = {};
    return result;
}

}  // namespace jostle::client
