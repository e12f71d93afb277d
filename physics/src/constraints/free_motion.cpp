// SPDX-License-Identifier: MIT
#include "physics/src/constraints/free_motion.h"

#include <cmath>

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {

Vec3 acceleration_of(const BodyWarm& warm, const BodyCold& cold, Vec3 gravity) {
    const Vec3 a = gravity * cold.gravity_scale + warm.force * cold.inverse_mass;
    return cold.locks == 0 ? a : scaled(a, free_directions(cold));
}

double damping_factor(double damping, double dt) {
    ASSERT(damping >= 0);
    const double c = damping * dt;
    return c < 1 ? (1 - 0.5 * c) / (1 + 0.5 * c) : 1 / (1 + c);
}

namespace {

// One step of Newton's method for end = begin - h bend(mean), where bend() is quadratic in the mean
// of the two spins. Returns the correction of `end`.
Vec3 midpoint_correction(Vec3 bend, Vec3 begin, Vec3 end, double h) {
    const Vec3 m = (begin + end) * 0.5, c = bend * (0.5 * h);
    const Vec3 residual = begin - end - scaled(bend, {m.y * m.z, m.z * m.x, m.x * m.y}) * h;
    // Rows of the derivative.
    const Vec3 x{1, c.x * m.z, c.x * m.y}, y{c.y * m.z, 1, c.y * m.x}, z{c.z * m.y, c.z * m.x, 1};
    const Vec3 yz = cross(y, z);
    const double determinant = dot(x, yz);
    if (!(determinant > 0.1)) return residual;  // too fast for the most parts
    return (yz * residual.x + cross(z, x) * residual.y + cross(x, y) * residual.z) *
           (1 / determinant);
}

// The inertia is constant in the body's axes. The midpoint rule conserves energy and |L| and, with
// the Cayley map for the rotation, L itself. `h |w|` is at most a quarter, so the derivative is
// regular, however thin the body is: no principal moment is less than the difference of the other
// two.
EulerStep principal_step(Vec3 bend, Vec3 w, double dt) {
    // A NaN spin uses one part; quarantine handles it after the step.
    const double estimated_parts = length(w) * absolute(dt) * 4;
    const int parts =
        estimated_parts >= 1 ? static_cast<int>(minimum(estimated_parts, 4000)) + 1 : 1;
    const double h = dt / parts;
    ASSERT(parts >= 1);
    EulerStep result{.rotation = {}, .w = w};
    for (int part = 0; part < parts; part++) {
        const Vec3 begin = result.w;
        Vec3 end = begin;
        for (int round = 0; round < 30; round++) {
            const Vec3 correction = midpoint_correction(bend, begin, end, h);
            end += correction;
            // Each round squares the error.
            if (length_squared(correction) <= 1e-16 * length_squared(end)) break;
        }
        const Vec3 half = (begin + end) * (0.25 * h);
        result.rotation = normalized(result.rotation * Quat{half.x, half.y, half.z, 1});
        result.w = end;
    }
    return result;
}

}  // namespace

Vec3 bend_of(const PrincipalAxes& axes) {
    const Vec3& i = axes.moments;
    return {(i.z - i.y) / i.x, (i.x - i.z) / i.y, (i.y - i.x) / i.z};
}

EulerStep euler_step(const BodyCold& cold, Vec3 w, double dt) {
    const PrincipalAxes& axes = cold.principal;
    const Vec3 bend = bend_of(axes);
    if (axes.frame == Quat{}) return principal_step(bend, w, dt);
    const EulerStep own = principal_step(bend, inverse_rotate(axes.frame, w), dt);
    return {axes.frame * own.rotation * conjugate(axes.frame), rotate(axes.frame, own.w)};
}

Vec3 rotation_vector_between(Quat from, Quat to, Vec3 expected) {
    const Quat rotation = to * conjugate(from);
    const Vec3 v{rotation.x, rotation.y, rotation.z};
    const double l = length(v);
    ASSERT(!(l > 1 + 1e-6));
    const Vec3 axis = l > 1e-12 ? v * (1 / l) : normalized(expected);
    const double angle = 2 * arc_tangent(l, rotation.w), round = 2 * pi;
    return axis * (angle + round * std::floor((dot(expected, axis) - angle) / round + 0.5));
}

bool is_gyroscopic(const BodyWarm& warm, const BodyCold& cold, double dt, double turn) {
    return !cold.isotropic && cold.type == BodyType::dynamic &&
           (cold.locks & (lock_rotation_x | lock_rotation_y | lock_rotation_z)) == 0 &&
           length_squared(warm.w) * dt * dt > turn * turn;
}

namespace {

// With locked rotations the spin stays in the free directions. No gyroscopic term couples into a
// locked one.
FreeSpin locked_spin(const BodyWarm& warm, const BodyCold& cold, double dt) {
    const Vec3 w = warm.w + world_inverse_inertia(warm, cold) * warm.torque * dt;
    ASSERT(cold.type == BodyType::dynamic);
    if (w == Vec3{} && warm.w == Vec3{}) return {warm.rotation, w};
    const Vec3 mean = (warm.w + w) * 0.5;
    return {normalized(from_rotation_vector(mean * dt) * warm.rotation), w};
}

}  // namespace

FreeSpin free_spin(const BodyWarm& warm, const BodyCold& cold, double dt) {
    if ((cold.locks & (lock_rotation_x | lock_rotation_y | lock_rotation_z)) != 0)
        return locked_spin(warm, cold, dt);
    if (cold.isotropic) {
        const Vec3 w = warm.w + cold.inverse_inertia * warm.torque * dt;
        if (w == Vec3{} && warm.w == Vec3{}) return {warm.rotation, w};
        const Vec3 mean = (warm.w + w) * 0.5;
        return {normalized(from_rotation_vector(mean * dt) * warm.rotation), w};
    }
    if (warm.w == Vec3{} && warm.torque == Vec3{}) return {warm.rotation, {}};
    // Half of the torque before the free rotation, half after it.
    const double half = 0.5 * dt;
    const Vec3 start = transposed_times(warm.axes, warm.w) +
                       cold.inverse_inertia * transposed_times(warm.axes, warm.torque) * half;
    const EulerStep step = euler_step(cold, start, dt);
    const Quat rotation = normalized(warm.rotation * step.rotation);
    Vec3 w = rotate(rotation, step.w);
    if (warm.torque != Vec3{}) {
        const Mat3 axes = to_matrix(rotation);
        w += axes * (cold.inverse_inertia * transposed_times(axes, warm.torque)) * half;
    }
    return {rotation, w};
}

FreeMotion free_motion(const BodyWarm& warm, const BodyCold& cold, Vec3 gravity, double dt) {
    if (cold.type == BodyType::kinematic)
        return {warm.v * dt,
                warm.w == Vec3{} ? warm.rotation
                                 : normalized(from_rotation_vector(warm.w * dt) * warm.rotation),
                warm.v, warm.w};
    const Vec3 v1 = (warm.v + acceleration_of(warm, cold, gravity) * dt);
    ASSERT(cold.type == BodyType::dynamic && dt > 0);
    const FreeSpin spin = free_spin(warm, cold, dt);
    if (cold.linear_damping == 0 && cold.angular_damping == 0)
        return {(warm.v + v1) * (0.5 * dt), spin.rotation, v1, spin.w};
    const Vec3 v = v1 * damping_factor(cold.linear_damping, dt);
    return {(warm.v + v) * (0.5 * dt), spin.rotation, v,
            spin.w * damping_factor(cold.angular_damping, dt)};
}

}  // namespace jostle::physics
