// SPDX-License-Identifier: MIT
#include "physics/src/constraints/joints/axes_layout.h"

#include "jostle/base/check.h"
#include "jostle/physics/quat.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

constexpr double min_cosine =
    0.05;  // lower bound of the middle angle's cosine where rows divide by it

// Cycles the axes x, y, z to y, z, x `count` times.
constexpr Quat cycled(int count) {
    constexpr Quat turns[] = {{0, 0, 0, 1}, {0.5, 0.5, 0.5, 0.5}, {-0.5, -0.5, -0.5, 0.5}};
    return turns[count];
}

}  // namespace

GimbalAngles gimbal_angles(Quat frame_a, Quat frame_b) {
    const Mat3 a = to_matrix(frame_a), b = to_matrix(frame_b);
    const double xx = dot(a.x, b.x), xy = dot(a.x, b.y);
    return {arc_tangent(-dot(a.y, b.z), dot(a.z, b.z)),
            arc_tangent(dot(a.x, b.z), square_root(xx * xx + xy * xy)), arc_tangent(-xy, xx)};
}

GimbalRows gimbal_rows(Quat frame_a, Quat frame_b) {
    const Vec3 first = rotate(frame_a, {1, 0, 0}), last = rotate(frame_b, {0, 0, 1});
    const Vec3 across = cross(last, first);
    const double cosine = length(across);
    const Vec3 middle = cosine > 1e-12 ? across * (1 / cosine) : rotate(frame_a, Vec3{0, 1, 0});
    const double share = 1 / maximum(cosine, min_cosine);
    ASSERT(is_unit(first, 1e-5) && is_unit(last, 1e-5));
    return {cross(middle, last) * share, middle, cross(first, middle) * share};
}

AxesLayout layout_of(const SliderJoint& slider) {
    AxesLayout layout;
    layout.axes[2] = {.free = true,
                      .limit = slider.limit,
                      .spring = slider.spring,
                      .spring_target = slider.spring_travel,
                      .motor = {slider.motor.enabled, slider.motor.speed, slider.motor.max_force},
                      .friction = slider.friction_force,
                      .spring_max_force = slider.spring_max_force};
    layout.slots[2] = 0;
    return layout;
}

int middle_turn(const SixDofAxes& axes) {
    if (!axes.rotation_y.free) return 1;
    if (!axes.rotation_z.free) return 2;
    return axes.rotation_x.free ? 1 : 0;
}

AxesLayout layout_of(const SixDofJoint& six) {
    const JointAxis* axes[] = {&six.axes->x,          &six.axes->y,          &six.axes->z,
                               &six.axes->rotation_x, &six.axes->rotation_y, &six.axes->rotation_z};
    const int first = (middle_turn(*six.axes) + 2) % 3;
    AxesLayout layout;
    layout.turn_a = layout.turn_b = cycled(first);
    for (int k = 0; k < 3; k++)
        for (int turns = 0; turns < 6; turns += 3) {
            const int own = (first + k) % 3 + turns;
            layout.axes[static_cast<std::size_t>(k + turns)] = *axes[own];
            layout.slots[static_cast<std::size_t>(k + turns)] = own;
            ASSERT(own >= 0 && own < 6);
        }
    return layout;
}

AxesLayout layout_of(const WheelJoint& wheel) {
    AxesLayout layout;
    // The suspension and the steering axis use the first axis; the spin axis is the last one.
    constexpr double half = 0.70710678118654752;
    const Quat upright{0, 0, half, half};
    layout.turn_a = upright;
    layout.turn_b = upright;
    layout.axes[0] = {.free = true,
                      .limit = wheel.travel,
                      .spring = wheel.suspension,
                      .spring_target = wheel.suspension_target};
    layout.slots[0] = 0;
    if (wheel.free_steering)
        layout.axes[3] = {.free = true, .limit = wheel.steering_limit};
    else
        layout.turn_a = from_axis_angle({0, 1, 0}, wheel.steering) * upright;
    layout.slots[3] = 1;
    layout.axes[5] = {.free = true,
                      .motor = {wheel.motor.enabled, wheel.motor.speed, wheel.motor.max_torque},
                      .friction = wheel.friction_torque};
    layout.slots[5] = 2;
    return layout;
}

AxesLayout layout_at(const PathJoint& path, const PathPoint& path_point) {
    AxesLayout layout;
    layout.turn_a = path_point.rotation;
    JointLimit limit = path.limit;
    if (!path.closed) {
        const double end = length_of(path);
        ASSERT(end > 0);
        limit.lower = limit.enabled ? minimum(limit.lower, end) : 0;
        limit.upper = limit.enabled ? minimum(limit.upper, end) : end;
        limit.enabled = true;
    } else {
        limit.enabled = false;
    }
    limit.lower -= path_point.travel;
    limit.upper -= path_point.travel;
    layout.axes[0] = {.free = true,
                      .limit = limit,
                      .spring = path.spring,
                      .spring_target = path.spring_travel - path_point.travel,
                      .motor = {path.motor.enabled, path.motor.speed, path.motor.max_force},
                      .friction = path.friction_force};
    layout.slots[0] = 0;
    for (std::size_t k = 3; k < 6; k++) layout.axes[k].free = true;
    return layout;
}

AxesPose pose_of(const AxesLayout& layout, const Transform& frame_a, const Transform& frame_b) {
    const Quat a = frame_a.rotation * layout.turn_a, b = frame_b.rotation * layout.turn_b;
    return {inverse_rotate(a, frame_b.position - frame_a.position), gimbal_angles(a, b)};
}

double locked_error(const AxesLayout& layout, const AxesPose& pose) {
    const double offset[] = {pose.offset.x, pose.offset.y, pose.offset.z};
    double sum = 0;
    for (std::size_t k = 0; k < 3; k++)
        if (!layout.axes[k].free) sum += offset[k] * offset[k];
    return square_root(sum);
}

}  // namespace jostle::physics
