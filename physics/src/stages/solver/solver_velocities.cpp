// SPDX-License-Identifier: MIT
#include "physics/src/stages/solver/solver_velocities.h"

#include "jostle/base/check.h"

namespace jostle::physics {
namespace {

Mat3 stored_inverse_inertia(const SolverBody& hot) {
    const float* i = hot.inertia;
    return {{double{i[0]}, double{i[3]}, double{i[4]}},
            {double{i[3]}, double{i[1]}, double{i[5]}},
            {double{i[4]}, double{i[5]}, double{i[2]}}};
}

}  // namespace

Vec3 center_now(const BodyStore& bodies, const SolverScratch& scratch, std::uint32_t awake_index) {
    ASSERT(awake_index + 1 < scratch.hot.size());
    return bodies.awake[awake_index].center + to_vec3(scratch.hot[awake_index + 1].dp);
}

BodyWarm motion_now(const BodyStore& bodies, const SolverScratch& scratch,
                    std::uint32_t awake_index) {
    ASSERT(awake_index + 1 < scratch.hot.size());
    const SolverBody& hot = scratch.hot[awake_index + 1];
    BodyWarm now = bodies.awake[awake_index];
    const Quat turn = from_rotation_vector(to_vec3(hot.dr));
    now.center = center_now(bodies, scratch, awake_index);
    now.rotation = normalized(turn * now.rotation);
    now.axes = to_matrix(now.rotation);
    now.v = to_vec3(hot.v);
    now.w = scratch.spin_axes[awake_index + 1] == SpinAxes::body ? rotate(turn, to_vec3(hot.w))
                                                                 : to_vec3(hot.w);
    return now;
}

Mat3 solver_inverse_inertia(const SolverScratch& scratch, std::uint32_t awake_index) {
    ASSERT(awake_index + 1 < scratch.hot.size());
    const SolverBody& hot = scratch.hot[awake_index + 1];
    const Mat3 stored = stored_inverse_inertia(hot);
    if (scratch.spin_axes[awake_index + 1] != SpinAxes::body) return stored;
    const Mat3 turn = to_matrix(from_rotation_vector(to_vec3(hot.dr)));
    return turn * stored * transpose(turn);
}

void apply_solver_impulse(const BodyStore& bodies, SolverScratch& scratch,
                          std::uint32_t awake_index, Vec3 impulse, Vec3 angular_impulse) {
    ASSERT(awake_index + 1 < scratch.hot.size());
    SolverBody& hot = scratch.hot[awake_index + 1];
    const BodyCold& cold = bodies.cold[bodies.awake[awake_index].body];
    const Vec3 change = scaled(impulse, free_directions(cold)) * cold.inverse_mass;
    Vec3 about = angular_impulse;
    if (scratch.spin_axes[awake_index + 1] == SpinAxes::body)
        about = inverse_rotate(from_rotation_vector(to_vec3(hot.dr)), about);
    const Vec3 spin = stored_inverse_inertia(hot) * about;
    for (int k = 0; k < 3; k++) {
        const auto dv = static_cast<float>(change[k]), dw = static_cast<float>(spin[k]);
        hot.v[k] += dv;
        hot.w[k] += dw;
        hot.free[k] += dv;
        hot.free[3 + k] += dw;
    }
}

}  // namespace jostle::physics
