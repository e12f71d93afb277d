// SPDX-License-Identifier: MIT
//
// The passes over batches of joint groups (constraints/joints/joint_batches.h), eight groups at a
// time, one per lane.
#pragma once

#include "physics/src/constraints/joints/batch_matrix.h"

namespace jostle::physics::JOSTLE_ISA {

JOSTLE_INLINE Wide3 unknown_at(const BatchView& batch, int position) {
    const WideValue* const at = batch.unknown + 3 * position;
    return {load(at[0].lane), load(at[1].lane), load(at[2].lane)};
}
JOSTLE_INLINE void set_unknown(const BatchView& batch, int position, Wide3 to) {
    WideValue* const at = batch.unknown + 3 * position;
    store(at[0].lane, to.x);
    store(at[1].lane, to.y);
    store(at[2].lane, to.z);
}

// Solves with the factor. The unknowns contain the right-hand sides on entry.
JOSTLE_INLINE void substitute(const BatchView& batch) {
    for (int k = 0; k < batch.node_count; k++) {
        const Wide3 x = unknown_at(batch, k);
        for (int i = batch.first_below[k]; i < batch.first_below[k + 1]; i++) {
            const BlockLdl::Below& below = batch.below[i];
            set_unknown(batch, below.position,
                        unknown_at(batch, below.position) - load9(batch.values + below.at) * x);
        }
    }
    for (int k = batch.node_count - 1; k >= 0; k--) {
        Wide3 y = load_symmetric(batch.inverse + 6 * k) * unknown_at(batch, k);
        for (int i = batch.first_below[k]; i < batch.first_below[k + 1]; i++) {
            const BlockLdl::Below& below = batch.below[i];
            y = y -
                transposed_times(load9(batch.values + below.at), unknown_at(batch, below.position));
        }
        set_unknown(batch, k, y);
    }
}

// Adds the impulses of the batch's joints to their blocks: accumulated ones, and the impulses that
// acted.
JOSTLE_INLINE void store_batch_impulse(const BatchView& batch, BatchJoint& joint, WideQuat carried,
                                       Wide3 impulse, bool acted) {
    alignas(32) float stored[3][8], world[3][8];
    const Wide3 own = rotate(conjugate(carried), impulse);
    store3(joint.impulse, load3(joint.impulse) + own);
    store3(stored, own);
    store3(world, impulse);
    for (int lane = 0; lane < batch.groups; lane++) {
        JointConstraintWide& to = batch.blocks[joint.block[lane]];
        const int at = joint.lane[lane];
        for (int axis = 0; axis < 3; axis++) {
            to.point[axis][at] += stored[axis][lane];
            if (acted) to.force[axis][at] += world[axis][lane];
        }
    }
}

enum class BatchPass { first, again, relax };

// Once per sub-step: solves (I + h K) w' = I w, where `stiffness` already contains h K.
JOSTLE_INLINE Wide3 implicit_turn(const BatchBody& body) {
    const Wide3 w =
        load_symmetric(body.inverse_inertia) * (load_symmetric(body.stiffness) * load3(body.w));
    return select(load(body.stiff) > splat(0), -w, Wide3{splat(0), splat(0), splat(0)});
}

// The axes in which a body's spin is stored.
JOSTLE_INLINE WideQuat axes_of(const BatchBody& body) {
    return turned_axes(load(body.spins_along), load4(body.rotation));
}
// Projects the velocities onto the point constraints. All passes except the relaxing one also
// correct position errors.
template <BatchPass kPass>
void solve_batch(const BatchView& batch, SolverBody* bodies, const JointStep& step) {
    for (int k = 0; k < batch.body_count; k++) {
        BatchBody& body = batch.bodies[k];
        const float* rows[8];
        find_rows(body, bodies, rows);
        Wide state[8];
        load_rows(rows, 0, state);
        store3(body.v, {state[0], state[1], state[2]});
        const Wide3 spin{state[3], state[4], state[5]};
        store3(body.w, body.any_along ? rotate(axes_of(body), spin) : spin);
        if constexpr (kPass == BatchPass::first) {
            const Wide3 change = implicit_turn(body);
            store3(body.turned, change);
            store3(body.w, load3(body.w) + change);
        }
    }
    for (int k = 0; k < batch.joint_count; k++) {
        const JointEnds& ends = batch.ends[k];
        const BatchBody &a = batch.bodies[ends.a], &b = batch.bodies[ends.b];
        BatchJoint& joint = batch.joints[k];
        const Wide3 at_a = load3(a.v) + cross(load3(a.w), load3(joint.lever_a));
        const Wide3 at_b = load3(b.v) + cross(load3(b.w), load3(joint.lever_b));
        Wide3 want = at_b - at_a;
        if constexpr (kPass != BatchPass::relax) {
            const Wide3 push = load3(joint.gap) * splat(step.direct_rate);
            const Wide most =
                splat(step.push_speed) + root(dot(at_a, at_a)) + root(dot(at_b, at_b));
            const Wide size2 = dot(push, push);
            const WideMask over = size2 > most * most;
            want = want + push * select(over, most / root(max(size2, splat(1e-30f))), splat(1));
        }
        set_unknown(batch, batch.position[k], -want);
    }
    for (int k = 0; k < batch.node_count; k++)
        if (batch.negative[k] != 0) set_unknown(batch, k, Wide3{splat(0), splat(0), splat(0)});
    substitute(batch);
    for (int k = 0; k < batch.body_count; k++) {
        BatchBody& body = batch.bodies[k];
        store3(body.v, Wide3{splat(0), splat(0), splat(0)});
        store3(body.w, Wide3{splat(0), splat(0), splat(0)});
    }
    for (int k = 0; k < batch.joint_count; k++) {
        const JointEnds& ends = batch.ends[k];
        BatchBody &a = batch.bodies[ends.a], &b = batch.bodies[ends.b];
        BatchJoint& joint = batch.joints[k];
        const Wide3 impulse = unknown_at(batch, batch.position[k]);
        store3(a.v, load3(a.v) - impulse);
        store3(a.w, load3(a.w) - cross(load3(joint.lever_a), impulse));
        store3(b.v, load3(b.v) + impulse);
        store3(b.w, load3(b.w) + cross(load3(joint.lever_b), impulse));
        store_batch_impulse(batch, joint, load4(carrier_of(batch, k).rotation), impulse,
                            kPass == BatchPass::relax);
    }
    for (int k = 0; k < batch.body_count; k++) {
        if (batch.pushed[k] == 0) continue;
        BatchBody& body = batch.bodies[k];
        const float* rows[8];
        find_rows(body, bodies, rows);
        const Wide3 mass = load3(body.inverse_mass), p = load3(body.v);
        const Wide3 v{mass.x * p.x, mass.y * p.y, mass.z * p.z};
        Wide3 w = load_symmetric(body.inverse_inertia) * load3(body.w);
        if constexpr (kPass == BatchPass::first) w = w + load3(body.turned);
        if (body.any_along) w = rotate(conjugate(axes_of(body)), w);
        alignas(32) float discarded[sizeof(SolverBody) / sizeof(float)];
        float* to[8];
        for (int lane = 0; lane < 8; lane++)
            to[lane] = rows[lane][6] > 0 ? const_cast<float*>(rows[lane]) : discarded;
        // Joint impulses count as non-contact changes: see SolverBody::free.
        constexpr int changed[] = {0, 24};
        for (const int row : changed) {
            Wide state[8];
            load_rows(rows, row, state);
            state[0] = state[0] + v.x, state[1] = state[1] + v.y, state[2] = state[2] + v.z;
            state[3] = state[3] + w.x, state[4] = state[4] + w.y, state[5] = state[5] + w.z;
            float* at[8];
            for (int lane = 0; lane < 8; lane++) at[lane] = to[lane] + row;
            store_rows(at, state);
        }
    }
}

}  // namespace jostle::physics::JOSTLE_ISA
