// SPDX-License-Identifier: MIT
//
// The matrix of a batch of joint groups (constraints/joints/joint_batches.h) and its factor, eight
// groups at a time, one per lane.
#pragma once

#include "physics/src/constraints/joints/joint_batches.h"
#include "physics/src/constraints/joints/joint_pair.h"

namespace jostle::physics::JOSTLE_ISA {

struct WideMatrix {  // row-major
    Wide m[9];
};
JOSTLE_INLINE WideMatrix load9(const WideValue* from) {
    WideMatrix to;
    for (int k = 0; k < 9; k++) to.m[k] = load(from[k].lane);
    return to;
}
JOSTLE_INLINE Wide3 operator*(const WideMatrix& m, Wide3 v) {
    return {fma(m.m[0], v.x, fma(m.m[1], v.y, m.m[2] * v.z)),
            fma(m.m[3], v.x, fma(m.m[4], v.y, m.m[5] * v.z)),
            fma(m.m[6], v.x, fma(m.m[7], v.y, m.m[8] * v.z))};
}
JOSTLE_INLINE Wide3 transposed_times(const WideMatrix& m, Wide3 v) {
    return {fma(m.m[0], v.x, fma(m.m[3], v.y, m.m[6] * v.z)),
            fma(m.m[1], v.x, fma(m.m[4], v.y, m.m[7] * v.z)),
            fma(m.m[2], v.x, fma(m.m[5], v.y, m.m[8] * v.z))};
}
JOSTLE_INLINE WideSymmetric load_symmetric(const float (*rows)[8]) {
    return {load(rows[0]), load(rows[1]), load(rows[2]),
            load(rows[3]), load(rows[4]), load(rows[5])};
}
JOSTLE_INLINE WideSymmetric load_symmetric(const WideValue* from) {
    return load_symmetric(reinterpret_cast<const float(*)[8]>(from));
}

// The inverse of a pivot block. `before`: its diagonal before the elimination. A remaining pivot
// below the fraction `left` of it may be rounding: that row depends on earlier rows and is skipped.
JOSTLE_INLINE WideSymmetric inverse_of(const WideMatrix& pivot, Wide3 before) {
    const Wide left = splat(1e-5f);
    const Wide xx = pivot.m[0], xy = pivot.m[3], yy = pivot.m[4], xz = pivot.m[6], yz = pivot.m[7],
               zz = pivot.m[8];
    const Wide d0 = inverse_above(xx, before.x * left);
    const Wide l1 = xy * d0, l2 = xz * d0;
    const Wide d1 = inverse_above(fnma(l1, xy, yy), before.y * left);
    const Wide under = fnma(l1, xz, yz), l3 = under * d1;
    const Wide d2 = inverse_above(fnma(l3, under, fnma(l2, xz, zz)), before.z * left);
    const Wide u = l1 * l3 - l2;
    const Wide ud = u * d2, ld = l3 * d2;
    return {fma(u, ud, fma(l1 * l1, d1, d0)), fma(l3, ld, d1), d2, -(fma(u, ld, l1 * d1)), ud, -ld};
}

// m^-1 + [later]x I^-1 [sooner]x^T: the velocity change at the later joint from an impulse at the
// sooner joint.
JOSTLE_INLINE void add_response(const BatchBody& body, Wide3 later, Wide3 sooner, float sign,
                                WideValue* to) {
    const WideSymmetric inertia = load_symmetric(body.inverse_inertia);
    const Wide3 mass = load3(body.inverse_mass);
    const Wide zero = splat(0);
    // Columns of I^-1 [sooner]x, and the velocities that these spins cause at `later`.
    const Wide3 turns[3] = {inertia * Wide3{zero, sooner.z, -sooner.y},
                            inertia * Wide3{-sooner.z, zero, sooner.x},
                            inertia * Wide3{sooner.y, -sooner.x, zero}};
    const Wide one = splat(sign);
    for (int column = 0; column < 3; column++) {
        Wide3 v = cross(turns[column], later);
        if (column == 0) v.x = v.x + mass.x;
        if (column == 1) v.y = v.y + mass.y;
        if (column == 2) v.z = v.z + mass.z;
        store(to[column].lane, fma(v.x, one, load(to[column].lane)));
        store(to[3 + column].lane, fma(v.y, one, load(to[3 + column].lane)));
        store(to[6 + column].lane, fma(v.z, one, load(to[6 + column].lane)));
    }
}

JOSTLE_INLINE void store9(WideValue* to, Wide3 x, Wide3 y, Wide3 z) {
    const Wide all[9] = {x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z};
    for (int k = 0; k < 9; k++) store(to[k].lane, all[k]);
}

// The diagonal blocks of a hub, -W.
JOSTLE_INLINE void add_hub(const BatchView& batch, const JointHub& hub) {
    const BatchBody& body = batch.bodies[hub.body];
    const Wide3 mass = load3(body.inverse_mass);
    const WideSymmetric i = load_symmetric(body.inverse_inertia);
    const Wide zero = splat(0);
    store9(batch.values + hub.at, {-mass.x, zero, zero}, {zero, -mass.y, zero},
           {zero, zero, -mass.z});
    store9(batch.values + hub.angular_at, {-i.xx, -i.xy, -i.xz}, {-i.xy, -i.yy, -i.yz},
           {-i.xz, -i.yz, -i.zz});
}

// J W of a joint and its hub: the velocity change at the joint from an impulse on the hub.
JOSTLE_INLINE void add_hub_block(const BatchView& batch, const JointHubBlock& coupling) {
    const BatchBody& body = batch.bodies[batch.hubs[coupling.hub].body];
    const BatchJoint& joint = batch.joints[coupling.joint];
    const Wide3 lever = load3(coupling.body_b ? joint.lever_b : joint.lever_a);
    const Wide one = splat(coupling.body_b ? 1.0f : -1.0f), zero = splat(0);
    const Wide3 mass = load3(body.inverse_mass) * one;
    store9(batch.values + coupling.at, {mass.x, zero, zero}, {zero, mass.y, zero},
           {zero, zero, mass.z});
    const WideSymmetric i = load_symmetric(body.inverse_inertia);
    const Wide3 x = cross({i.xx, i.xy, i.xz}, lever) * one,
                y = cross({i.xy, i.yy, i.yz}, lever) * one,
                z = cross({i.xz, i.yz, i.zz}, lever) * one;
    WideValue* const to = batch.values + coupling.angular_at;
    if (coupling.angular_later)
        store9(to, x, y, z);
    else
        store9(to, {x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z});
}

// The body in whose axes the joint's impulse is stored: b, unless b cannot be pushed.
JOSTLE_INLINE const BatchBody& carrier_of(const BatchView& batch, int joint) {
    const JointEnds& ends = batch.ends[joint];
    return batch.bodies[batch.pushed[ends.b] != 0 ? ends.b : ends.a];
}

JOSTLE_INLINE void find_rows(const BatchBody& body, const SolverBody* bodies,
                             const float* rows[8]) {
    for (int k = 0; k < 8; k++) rows[k] = bodies[body.hot[k]].v;
}

// Loads the current motion of the bodies.
JOSTLE_INLINE void load_motion(BatchBody& body, const SolverBody* bodies) {
    const float* rows[8];
    find_rows(body, bodies, rows);
    Wide state[8], motion[8], inertia[8];
    load_rows(rows, 0, state);
    load_rows(rows, 8, motion);
    load_rows(rows, 16, inertia);
    store3(body.inverse_mass, {state[6] * inertia[6], state[6] * inertia[7], state[6] * motion[6]});
    store3(body.moved, {motion[0], motion[1], motion[2]});
    const WideQuat q = from_rotation_vector({motion[3], motion[4], motion[5]});
    WideSymmetric i{inertia[0], inertia[1], inertia[2], inertia[3], inertia[4], inertia[5]};
    store(body.spins_along, motion[7]);
    body.any_along = lane_bits(motion[7] > splat(0)) != 0;
    if (body.any_along) i = turned_by(turned_axes(motion[7], q), i);
    const Wide parts[6] = {i.xx, i.yy, i.zz, i.xy, i.xz, i.yz};
    for (int k = 0; k < 6; k++) store(body.inverse_inertia[k], parts[k]);
    store(body.rotation[0], q.x);
    store(body.rotation[1], q.y);
    store(body.rotation[2], q.z);
    store(body.rotation[3], q.w);
}

// Both bodies receive the force midway across the remaining gap between the ends, which conserves
// angular momentum.
JOSTLE_INLINE void load_levers(BatchJoint& joint, const BatchBody& a, const BatchBody& b) {
    const Wide3 arm_a = load3(joint.arm_a), arm_b = load3(joint.arm_b);
    const Wide3 swept_a = rotated_by(load4(a.rotation), arm_a);
    const Wide3 swept_b = rotated_by(load4(b.rotation), arm_b);
    const Wide3 gap = load3(joint.apart) + (load3(b.moved) - load3(a.moved)) + (swept_b - swept_a);
    store3(joint.gap, gap);
    store3(joint.lever_a, arm_a + swept_a + gap * splat(0.5f));
    store3(joint.lever_b, arm_b + swept_b - gap * splat(0.5f));
}

// The column is copied. L = column D^-1 overwrites it.
JOSTLE_INLINE void eliminate(const BatchView& batch, int k) {
    WideValue* const stored = batch.inverse + 6 * k;
    const Wide3 before{load(stored[0].lane), load(stored[1].lane), load(stored[2].lane)};
    WideMatrix pivot = load9(batch.values + batch.diagonal[k]);
    WideSymmetric inverse;
    if (batch.negative[k] == 0) {
        inverse = inverse_of(pivot, before);
    } else {
        for (Wide& value : pivot.m) value = -value;
        inverse = inverse_of(pivot, -before);
        inverse = {-inverse.xx, -inverse.yy, -inverse.zz, -inverse.xy, -inverse.xz, -inverse.yz};
    }
    const Wide parts[6] = {inverse.xx, inverse.yy, inverse.zz, inverse.xy, inverse.xz, inverse.yz};
    for (int i = 0; i < 6; i++) store(stored[i].lane, parts[i]);
    const BlockLdl::Below* const below = batch.below + batch.first_below[k];
    const int count = batch.first_below[k + 1] - batch.first_below[k];
    for (int i = 0; i < count; i++) {
        WideValue* const lower = batch.values + below[i].at;
        const WideMatrix column = load9(lower);
        for (int v = 0; v < 9; v++) store(batch.column[9 * i + v].lane, column.m[v]);
        for (int row = 0; row < 3; row++) {
            const Wide3 l =
                inverse * Wide3{column.m[3 * row], column.m[3 * row + 1], column.m[3 * row + 2]};
            store(lower[3 * row].lane, l.x);
            store(lower[3 * row + 1].lane, l.y);
            store(lower[3 * row + 2].lane, l.z);
        }
    }
    for (int u = batch.first_update[k]; u < batch.first_update[k + 1]; u++) {
        const BlockLdl::Update& update = batch.updates[u];
        const WideMatrix lower = load9(batch.values + below[update.i].at);
        const WideMatrix column = load9(batch.column + 9 * update.j);
        WideValue* const to = batch.values + update.at;
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++) {
                Wide s = load(to[3 * r + c].lane);
                for (int t = 0; t < 3; t++) s = fnma(lower.m[3 * r + t], column.m[3 * c + t], s);
                store(to[3 * r + c].lane, s);
            }
    }
}

// Adds the geometric stiffness: tension at an arm straightens, compression destabilises. Minus the
// derivative of the torque.
JOSTLE_INLINE void stiffen(BatchBody& body, Wide3 impulse, Wide3 arm) {
    const Wide along = dot(impulse, arm), half = splat(-0.5f);
    const Wide parts[6] = {along - arm.x * impulse.x,
                           along - arm.y * impulse.y,
                           along - arm.z * impulse.z,
                           (arm.x * impulse.y + arm.y * impulse.x) * half,
                           (arm.x * impulse.z + arm.z * impulse.x) * half,
                           (arm.y * impulse.z + arm.z * impulse.y) * half};
    for (int k = 0; k < 6; k++) store(body.stiffness[k], load(body.stiffness[k]) + parts[k]);
}

// Inverse by cofactors, with the determinants of the leading blocks.
struct WideInverse {
    WideSymmetric inverse;
    Wide d2, d3;
};
JOSTLE_INLINE WideInverse inverse_of(const WideSymmetric& m) {
    const Wide c0 = m.yy * m.zz - m.yz * m.yz, c1 = m.xz * m.yz - m.xy * m.zz,
               c2 = m.xy * m.yz - m.xz * m.yy, d2 = m.xx * m.yy - m.xy * m.xy;
    const Wide d3 = m.xx * c0 + m.xy * c1 + m.xz * c2;
    const Wide s = inverse_above(d3, splat(0));
    return {{c0 * s, (m.xx * m.zz - m.xz * m.xz) * s, d2 * s, c1 * s, c2 * s,
             (m.xy * m.xz - m.xx * m.yz) * s},
            d2,
            d3};
}

// A light body between joints under high load oscillates faster than the sub-step resolves. Its
// rotation is then implicit in the joint load (M. Tournier et al., "Stable constrained dynamics",
// 2015), by just as much as stability requires (S. Andrews et al., "Geometric stiffness for
// real-time constrained multibody dynamics", 2017). Half of the trace, or of the norm, of I^-1 K
// bounds the squared oscillation rate.
JOSTLE_INLINE void stiffen_inertia(BatchBody& body, const JointStep& step) {
    const WideSymmetric i = load_symmetric(body.inverse_inertia);
    const WideSymmetric k = load_symmetric(body.stiffness);
    const Wide3 x = i * Wide3{k.xx, k.xy, k.xz}, y = i * Wide3{k.xy, k.yy, k.yz},
                z = i * Wide3{k.xz, k.yz, k.zz};
    const Wide trace = (x.x + y.y + z.z) * splat(0.5f);
    const Wide norm = root((dot(x, x) + dot(y, y) + dot(z, z)) * splat(0.5f));
    const Wide swing2 = max(trace, norm) * splat(step.h);  // (rad per sub-step)^2
    WideMask fast = swing2 > splat(1);
    store(body.stiff, splat(0));
    if (lane_bits(fast) == 0) return;
    const WideInverse inertia = inverse_of(i);
    const Wide part = (splat(1) - inverse_above(swing2, splat(0))) * splat(step.h);
    const WideSymmetric sum{inertia.inverse.xx + k.xx * part, inertia.inverse.yy + k.yy * part,
                            inertia.inverse.zz + k.zz * part, inertia.inverse.xy + k.xy * part,
                            inertia.inverse.xz + k.xz * part, inertia.inverse.yz + k.yz * part};
    const WideInverse stiff = inverse_of(sum);
    fast = fast & (inertia.d3 > splat(0)) & (sum.xx > splat(0)) & (stiff.d2 > splat(0)) &
           (stiff.d3 > splat(0));
    const Wide parts[6] = {stiff.inverse.xx, stiff.inverse.yy, stiff.inverse.zz,
                           stiff.inverse.xy, stiff.inverse.xz, stiff.inverse.yz};
    for (int n = 0; n < 6; n++)
        store(body.inverse_inertia[n], select(fast, parts[n], load(body.inverse_inertia[n])));
    const Wide scaled[6] = {k.xx, k.yy, k.zz, k.xy, k.xz, k.yz};
    for (int n = 0; n < 6; n++) store(body.stiffness[n], scaled[n] * part);
    store(body.stiff, select(fast, splat(1), splat(0)));
}

inline void factor_batch(const BatchView& batch, const SolverBody* bodies, const JointStep& step) {
    for (int k = 0; k < batch.body_count; k++) {
        load_motion(batch.bodies[k], bodies);
        for (float(&row)[8] : batch.bodies[k].stiffness) store(row, splat(0));
    }
    for (int k = 0; k < batch.value_count; k++) batch.values[k] = {};
    for (int k = 0; k < batch.joint_count; k++) {
        BatchJoint& joint = batch.joints[k];
        BatchBody &a = batch.bodies[batch.ends[k].a], &b = batch.bodies[batch.ends[k].b];
        load_levers(joint, a, b);
        const Wide3 impulse = rotate(load4(carrier_of(batch, k).rotation), load3(joint.impulse));
        stiffen(a, -impulse, load3(joint.lever_a));
        stiffen(b, impulse, load3(joint.lever_b));
    }
    for (int k = 0; k < batch.body_count; k++)
        if (batch.pushed[k] != 0) stiffen_inertia(batch.bodies[k], step);
    for (int k = 0; k < batch.system_block_count; k++) {
        const JointSystemBlock& c = batch.system_blocks[k];
        const BatchJoint &later = batch.joints[c.later], &sooner = batch.joints[c.sooner];
        add_response(batch.bodies[c.body], load3(c.later_b ? later.lever_b : later.lever_a),
                     load3(c.sooner_b ? sooner.lever_b : sooner.lever_a),
                     c.later_b == c.sooner_b ? 1.0f : -1.0f, batch.values + c.at);
    }
    for (int k = 0; k < batch.hub_count; k++) add_hub(batch, batch.hubs[k]);
    for (int k = 0; k < batch.hub_block_count; k++) add_hub_block(batch, batch.hub_blocks[k]);
    for (int k = 0; k < batch.node_count; k++) {
        // The diagonal before the elimination, stored where its inverse will be written.
        WideValue* const diagonal = batch.values + batch.diagonal[k];
        if (batch.compliance > 0)
            for (int n = 0; n < 9; n += 4)
                store(diagonal[n].lane, load(diagonal[n].lane) * splat(1 + batch.compliance));
        WideValue* const stored = batch.inverse + 6 * k;
        stored[0] = diagonal[0], stored[1] = diagonal[4], stored[2] = diagonal[8];
    }
    for (int k = 0; k < batch.node_count; k++) eliminate(batch, k);
}

}  // namespace jostle::physics::JOSTLE_ISA
