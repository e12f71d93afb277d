// SPDX-License-Identifier: MIT
//
// Euler's equations of gyroscopic bodies in a sub-step, eight bodies at a time. A body's spin is
// first transformed to its "own" axes: those that rotate with it and were the world's at the start
// of the step. Its inertia is constant in them.
#pragma once

#include "physics/src/constraint_graph/gyroscopic_wide.h"
#include "physics/src/constraint_graph/solver_body.h"
#include "physics/src/constraints/joints/joint_pair.h"
#include "physics/src/math/wide_rotation.h"

namespace jostle::physics::JOSTLE_ISA {

// Adding this to a float of moderate size rounds it to an integer.
constexpr float round_to_integer = 12582912;  // 1.5 * 2^23

// The change of the spin of free bodies in h, in their principal axes, by the midpoint rule, which
// conserves energy and |L|. Each iteration reduces the error to a quarter or less, however thin the
// body is, because no principal moment is less than the difference of the other two.
JOSTLE_INLINE Wide3 euler_change(Wide3 bend, Wide3 w, float h) {
    constexpr int max_rounds = 16;
    const Wide estimated = min(root(dot(w, w)) * splat(4 * h), splat(4000));
    const WideMask fast = estimated > splat(1);  // false for NaN, which quarantine handles
    const Wide whole = (estimated + splat(round_to_integer)) - splat(round_to_integer);
    const Wide parts = select(fast, whole + splat(1), splat(1));
    const Wide length = splat(h) / parts;
    Wide3 now = w;
    for (Wide part = splat(0);; part = part + splat(1)) {
        const WideMask active = parts > part;
        if (lane_bits(active) == 0) break;
        Wide3 end = now;
        WideMask open = active;
        for (int round = 0; round < max_rounds; round++) {
            const Wide3 mean = (now + end) * splat(0.5f);
            const Wide3 next{fnma(bend.x * length, mean.y * mean.z, now.x),
                             fnma(bend.y * length, mean.z * mean.x, now.y),
                             fnma(bend.z * length, mean.x * mean.y, now.z)};
            const Wide3 step = next - end;
            const WideMask moved = dot(step, step) > dot(next, next) * splat(1e-14f);
            end = select(open, next, end);
            open = open & moved;
            if (lane_bits(open) == 0) break;
        }
        now = end;
    }
    return now - w;
}

// Returns the rotation vector of q that is nearest to `expected`, so that the number of full turns
// matches the motion.
JOSTLE_INLINE Wide3 rotation_vector_of(WideQuat q, Wide3 expected) {
    constexpr float full_turn = 6.28318531f;
    const Wide3 v{q.x, q.y, q.z};
    const Wide sine = root(dot(v, v));
    const WideMask turned = sine > splat(1e-9f);
    const Wide3 axis =
        select(turned, v * (splat(1) / select(turned, sine, splat(1))), normalized(expected, v));
    const Wide angle = splat(2) * arc_tangent(sine, q.w);
    const Wide rounds =
        ((dot(expected, axis) - angle) * splat(1 / full_turn) + splat(round_to_integer)) -
        splat(round_to_integer);
    return axis * (angle + rounds * splat(full_turn));
}

// The bodies of a block.
struct GyroscopicLanes {
    const float* rows[8];
    Wide state[8];  // SolverBody's row 0
    WideMask by_substeps;
    WideQuat turned;

    JOSTLE_INLINE GyroscopicLanes(const GyroscopicWide& block, const SolverBody* bodies) {
        for (int k = 0; k < 8; k++) rows[k] = bodies[block.hot[k]].v;
        load_rows(rows, 0, state);
        by_substeps = load(block.by_substeps) > splat(0);
        turned = load4(block.turned);
    }
    JOSTLE_INLINE Wide3 spin() const { return {state[3], state[4], state[5]}; }
    JOSTLE_INLINE Wide3 to_own(Wide3 w) const {
        return select(by_substeps, rotate(conjugate(turned), w), w);
    }
    JOSTLE_INLINE Wide3 from_own(Wide3 w) const {
        return select(by_substeps, rotate(turned, w), w);
    }
    // Writes one row of the bodies, but not of unused lanes.
    JOSTLE_INLINE void store_row(const GyroscopicWide& block, int row, const Wide values[8]) {
        alignas(32) float discarded[8];
        float* to[8];
        for (int k = 0; k < 8; k++)
            to[k] = block.hot[k] != 0 ? const_cast<float*>(rows[k]) + row : discarded;
        store_rows(to, values);
    }
    // The change is not an impulse, so it is also added to the velocities without contacts.
    JOSTLE_INLINE void add_spin(const GyroscopicWide& block, Wide3 change) {
        Wide free[8];
        load_rows(rows, 24, free);
        const Wide parts[] = {change.x, change.y, change.z};
        for (int k = 0; k < 3; k++) {
            state[3 + k] = state[3 + k] + parts[k];
            free[3 + k] = free[3 + k] + parts[k];
        }
        store_row(block, 0, state);
        store_row(block, 24, free);
    }
};

// The change of the spin in a sub-step, in the axes of the start of the step.
JOSTLE_INLINE Wide3 change_of(const GyroscopicWide& block, Wide3 own, float h) {
    const WideQuat axes = load4(block.principal);
    return rotate(axes, euler_change(load3(block.bend), rotate(conjugate(axes), own), h));
}

// All of the change, for bodies without joints.
inline void spin_freely_range(const GyroscopicRange& range, SolverBody* bodies, float h) {
    for (int k = range.begin; k < range.end; k++) {
        const GyroscopicWide& block = range.blocks[k];
        GyroscopicLanes now(block, bodies);
        now.add_spin(block, change_of(block, now.spin(), h));
    }
}

// Half of the change. The joints then constrain the mean spin of the sub-step.
inline void begin_gyroscopic_range(const GyroscopicRange& range, SolverBody* bodies, float h) {
    for (int k = range.begin; k < range.end; k++) {
        GyroscopicWide& block = range.blocks[k];
        GyroscopicLanes now(block, bodies);
        const Wide3 half = change_of(block, now.to_own(now.spin()), h) * splat(0.5f);
        store3(block.half_change, half);
        now.add_spin(block, now.from_own(half));
    }
}

// The other half. The mean spin rotates the body to its exact pose.
inline void end_gyroscopic_range(const GyroscopicRange& range, SolverBody* bodies, float h) {
    for (int k = range.begin; k < range.end; k++) {
        GyroscopicWide& block = range.blocks[k];
        GyroscopicLanes now(block, bodies);
        const Wide3 mean = now.spin(), own = now.to_own(mean);
        now.turned = now.turned * from_rotation_vector(own * splat(h));
        store(block.turned[0], now.turned.x);
        store(block.turned[1], now.turned.y);
        store(block.turned[2], now.turned.z);
        store(block.turned[3], now.turned.w);
        const Wide3 w = now.from_own(own + load3(block.half_change));
        Wide motion[8];
        load_rows(now.rows, 8, motion);
        // The pass that moves the bodies adds h w.
        const Wide3 turn = rotation_vector_of(now.turned, Wide3{motion[3], motion[4], motion[5]} +
                                                              mean * splat(h)) -
                           w * splat(h);
        motion[3] = turn.x, motion[4] = turn.y, motion[5] = turn.z;
        now.store_row(block, 8, motion);
        now.add_spin(block, w - mean);
        if (lane_bits(now.by_substeps) == 0) continue;
        const Wide3 i = load3(block.inverse_moments);
        const WideSymmetric inertia = turned_by(now.turned * load4(block.principal),
                                                {i.x, i.y, i.z, splat(0), splat(0), splat(0)});
        Wide row[8];
        load_rows(now.rows, 16, row);
        const Wide parts[] = {inertia.xx, inertia.yy, inertia.zz,
                              inertia.xy, inertia.xz, inertia.yz};
        for (int part = 0; part < 6; part++)
            row[part] = select(now.by_substeps, parts[part], row[part]);
        now.store_row(block, 16, row);
    }
}

}  // namespace jostle::physics::JOSTLE_ISA
