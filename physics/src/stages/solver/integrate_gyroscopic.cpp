// SPDX-License-Identifier: MIT
#include "physics/src/stages/solver/integrate_gyroscopic.h"

#include "jostle/base/check.h"
#include "physics/src/constraints/free_motion.h"
#include "physics/src/stages/solver/gather_bodies.h"
#include "physics/src/stages/step_scratch.h"

namespace jostle::physics {
namespace {

const BodyCold& cold_of(const BodyStore& bodies, std::uint32_t hot_index) {
    ASSERT(hot_index > 0 && hot_index <= bodies.awake.size());
    return bodies.cold[bodies.awake[hot_index - 1].body];
}

EulerStep euler_step_of(const BodyStore& bodies, const GyroscopicBody& g, std::uint32_t hot_index,
                        Vec3 start, double h) {
    return g.principal ? euler_step(PrincipalRatios{g.bend}, start, h)
                       : euler_step(cold_of(bodies, hot_index), start, h);
}

// The change is not an impulse, so it is also added to the motion without contacts.
void add_spin(SolverBody& hot, Vec3 change) {
    for (int k = 0; k < 3; k++) {
        hot.w[k] += as_float(change[k]);
        hot.free[3 + k] += as_float(change[k]);
    }
}

void integrate_without_joints(const BodyStore& bodies, SolverScratch& scratch,
                              std::uint32_t hot_index, double h) {
    SolverBody& hot = scratch.hot[hot_index];
    const GyroscopicBody& g = scratch.gyroscopic[hot_index];
    const Vec3 start = transposed_times(g.axes, to_vec3(hot.w));
    add_spin(hot, g.axes * (euler_step_of(bodies, g, hot_index, start, h).w - start));
}

// The second half of begin_gyroscopic(): the joints have constrained the mean spin, which rotates
// the body to its exact pose.
void integrate_with_joints(const BodyStore& bodies, SolverScratch& scratch, std::uint32_t hot_index,
                           double h) {
    SolverBody& hot = scratch.hot[hot_index];
    GyroscopicBody& g = scratch.gyroscopic[hot_index];
    const Vec3 mean = to_vec3(hot.w), own = transposed_times(g.axes, mean);
    g.now = normalized(g.now * from_rotation_vector(own * h));
    if (scratch.spin_axes[hot_index] == SpinAxes::world_by_substeps) {
        g.axes = to_matrix(g.now);
        put_inertia(hot, g.axes * cold_of(bodies, hot_index).inverse_inertia * transpose(g.axes));
    }
    const Vec3 w = g.axes * (own + g.half_change);
    const Vec3 turn = rotation_vector_between(g.start, g.now, to_vec3(hot.dr) + mean * h) - w * h;
    for (int k = 0; k < 3; k++) hot.dr[k] = as_float(turn[k]);
    add_spin(hot, w - mean);
}

}  // namespace

void begin_gyroscopic(StepContext& step, std::span<const std::uint32_t> jointed, double h) {
    SolverScratch& scratch = step.scratch.solver;
    for (const std::uint32_t index : jointed) {
        if (scratch.spin_axes[index] == SpinAxes::world) continue;
        SolverBody& hot = scratch.hot[index];
        GyroscopicBody& g = scratch.gyroscopic[index];
        const Vec3 start = transposed_times(g.axes, to_vec3(hot.w));
        const EulerStep change = euler_step_of(step.world.bodies, g, index, start, h);
        g.half_change = (change.w - start) * 0.5;
        add_spin(hot, g.axes * g.half_change);
    }
}

void integrate_gyroscopic(StepContext& step, std::span<const std::uint32_t> bodies, double h) {
    SolverScratch& scratch = step.scratch.solver;
    const BodyStore& store = step.world.bodies;
    for (const std::uint32_t index : bodies) {
        if (scratch.spin_axes[index] == SpinAxes::world) continue;
        if (cold_of(store, index).first_joint != none)
            integrate_with_joints(store, scratch, index, h);
        else
            integrate_without_joints(store, scratch, index, h);
    }
}

}  // namespace jostle::physics
