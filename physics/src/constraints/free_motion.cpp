// SPDX-License-Identifier: MIT
#include "constraints/free_motion.h"

namespace jostle::physics {

Vec3 acceleration_of(const BodyWarm& warm, const BodyCold& cold, Vec3 gravity) {
    const Vec3 a = gravity * cold.gravity_scale + warm.force * cold.inverse_mass;
    return cold.locks == 0 ? a : scaled(a, free_directions(cold));
}

double damping_factor(double damping, double dt) {
    const double c = damping * dt;
    return c < 1 ? (1 - 0.5 * c) / (1 + 0.5 * c) : 1 / (1 + c);
}

namespace {

// With locked turns the spin keeps to the directions that are left; no gyroscopic term couples into
// a locked one.
FreeSpin locked_spin(const BodyWarm& warm, const BodyCold& cold, double dt) {
    const Vec3 w = warm.w + world_inverse_inertia(warm, cold) * warm.torque * dt;
    if (w == Vec3{} && warm.w == Vec3{}) return {warm.rotation, w};
    const Vec3 mean = (warm.w + w) * 0.5;
    return {normalized(from_rotation_vector(mean * dt) * warm.rotation), w};
}

}  // namespace

FreeSpin free_spin(const BodyWarm& warm, const BodyCold& cold, double dt) {
    if ((cold.locks & (lock_turn_x | lock_turn_y | lock_turn_z)) != 0)
        return locked_spin(warm, cold, dt);
    if (cold.isotropic) {
        const Vec3 w = warm.w + cold.inverse_inertia * warm.torque * dt;
        if (w == Vec3{} && warm.w == Vec3{}) return {warm.rotation, w};
        const Vec3 mean = (warm.w + w) * 0.5;
        return {normalized(from_rotation_vector(mean * dt) * warm.rotation), w};
    }
    if (warm.w == Vec3{} && warm.torque == Vec3{}) return {warm.rotation, {}};
    const auto spin_at = [&](Quat rotation, Vec3 momentum) {
        const Mat3 axes = to_matrix(rotation);
        return axes * (cold.inverse_inertia * transposed_times(axes, momentum));
    };
    const Vec3 start = warm.axes * (cold.inertia * transposed_times(warm.axes, warm.w));
    const Vec3 middle = start + warm.torque * (0.5 * dt), end = start + warm.torque * dt;
    // Fixed-point iteration for the spin at the middle of the step; each round gains a factor of
    // about dt |w| / 2.
    Vec3 w = warm.w;
    for (int round = 0; round < 4; round++)
        w = spin_at(normalized(from_rotation_vector(w * (0.5 * dt)) * warm.rotation), middle);
    const Quat rotation = normalized(from_rotation_vector(w * dt) * warm.rotation);
    return {rotation, spin_at(rotation, end)};
}

FreeMotion free_motion(const BodyWarm& warm, const BodyCold& cold, Vec3 gravity, double dt) {
    if (cold.type == BodyType::kinematic)
        return {warm.v * dt,
                warm.w == Vec3{} ? warm.rotation
                                 : normalized(from_rotation_vector(warm.w * dt) * warm.rotation),
                warm.v, warm.w};
    const Vec3 v1 = (warm.v + acceleration_of(warm, cold, gravity) * dt);
    const FreeSpin spin = free_spin(warm, cold, dt);
    if (cold.linear_damping == 0 && cold.angular_damping == 0)
        return {(warm.v + v1) * (0.5 * dt), spin.rotation, v1, spin.w};
    const Vec3 v = v1 * damping_factor(cold.linear_damping, dt);
    return {(warm.v + v) * (0.5 * dt), spin.rotation, v,
            spin.w * damping_factor(cold.angular_damping, dt)};
}

}  // namespace jostle::physics
