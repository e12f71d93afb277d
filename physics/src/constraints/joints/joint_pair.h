// SPDX-License-Identifier: MIT
//
// The two bodies of eight joints at one instant of the step, and the row types that all kinds use:
// hold two points together, hold directions together, limit or drive one angle or distance.
//
// Impulses rotate with the body that carries them: b, unless b is immovable. Impulses stored in
// world axes would lag from sub-step to sub-step and accelerate rotating bodies.
#pragma once

#include "physics/src/constraint_graph/joint_constraint_wide.h"
#include "physics/src/constraints/contact_kernel.h"
#include "physics/src/constraints/joints/angles.h"
#include "physics/src/constraints/joints/joint_step.h"
#include "physics/src/math/wide_rotation.h"

namespace jostle::physics::JOSTLE_ISA {

// The load that eight joints exerted on their bodies b in one pass, world axes.
struct JointLoad {
    Wide3 impulse;  // N s
    Wide3 angular;  // N m s
};

JOSTLE_INLINE void store3(float (*rows)[8], Wide3 v) {
    store(rows[0], v.x);
    store(rows[1], v.y);
    store(rows[2], v.z);
}
JOSTLE_INLINE WideQuat load4(const float (*rows)[8]) {
    return {load(rows[0]), load(rows[1]), load(rows[2]), load(rows[3])};
}

// A symmetric matrix.
struct WideSymmetric {
    Wide xx, yy, zz, xy, xz, yz;
};
JOSTLE_INLINE WideSymmetric operator+(const WideSymmetric& a, const WideSymmetric& b) {
    return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
}
JOSTLE_INLINE Wide3 operator*(const WideSymmetric& m, Wide3 v) {
    return {dot({m.xx, m.xy, m.xz}, v), dot({m.xy, m.yy, m.yz}, v), dot({m.xz, m.yz, m.zz}, v)};
}
// q m q^T.
JOSTLE_INLINE WideSymmetric turned_by(WideQuat q, const WideSymmetric& m) {
    const Wide3 x = x_axis(q), y = y_axis(q), z = z_axis(q);
    const Wide3 u = x * m.xx + y * m.xy + z * m.xz, v = x * m.xy + y * m.yy + z * m.yz,
                w = x * m.xz + y * m.yz + z * m.zz;
    return {u.x * x.x + v.x * y.x + w.x * z.x, u.y * x.y + v.y * y.y + w.y * z.y,
            u.z * x.z + v.z * y.z + w.z * z.z, u.x * x.y + v.x * y.y + w.x * z.y,
            u.x * x.z + v.x * y.z + w.x * z.z, u.y * x.z + v.y * y.z + w.y * z.z};
}
// Rotation since the start of the step of the axes in which a body's spin is stored.
JOSTLE_INLINE WideQuat turned_axes(Wide spins_along, WideQuat rotation) {
    const WideMask along = spins_along > splat(0);
    const Wide none = splat(0);
    return {select(along, rotation.x, none), select(along, rotation.y, none),
            select(along, rotation.z, none), select(along, rotation.w, splat(1))};
}
// [r]x m [r]x^T: the velocity change at arm r from an impulse there, through the spin.
JOSTLE_INLINE WideSymmetric across(const WideSymmetric& m, Wide3 r) {
    const Wide3 x = m * Wide3{splat(0), r.z, -r.y};  // m (r x e_x)
    const Wide3 y = m * Wide3{-r.z, splat(0), r.x};
    const Wide3 z = m * Wide3{r.y, -r.x, splat(0)};
    return {x.y * r.z - x.z * r.y, y.z * r.x - y.x * r.z, z.x * r.y - z.y * r.x,
            y.y * r.z - y.z * r.y, z.y * r.z - z.z * r.y, z.z * r.x - z.x * r.z};
}
// 1 / x, or zero if x is not above `least`.
JOSTLE_INLINE Wide inverse_above(Wide x, Wide least) {
    const WideMask solid = x > least;
    return select(solid, splat(1) / select(solid, x, splat(1)), splat(0));
}
// Solves m x = v without the immovable directions: locked axes leave zero rows. LDL^T; a pivot that
// is almost zero relative to its diagonal is rounding.
JOSTLE_INLINE Wide3 solve3(const WideSymmetric& m, Wide3 v) {
    const Wide left = splat(1e-6f);
    const Wide d0 = inverse_above(m.xx, splat(0));
    const Wide l1 = m.xy * d0, l2 = m.xz * d0;
    const Wide d1 = inverse_above(m.yy - l1 * m.xy, m.yy * left);
    const Wide under = m.yz - l1 * m.xz, l3 = under * d1;
    const Wide d2 = inverse_above((m.zz - l2 * m.xz) - l3 * under, m.zz * left);
    const Wide y = v.y - l1 * v.x, z = (v.z - l2 * v.x) - l3 * y;
    const Wide rz = z * d2, ry = y * d1 - l3 * rz;
    return {(v.x * d0 - l1 * ry) - l2 * rz, ry, rz};
}

struct JointSide {
    const float* rows[8];
    Wide state[8];  // SolverBody's row 0
    Wide3 v, w, dp;
    Wide3 inverse_mass;  // per world axis
    WideSymmetric inverse_inertia;
    WideQuat rotation;  // since the start of the step
    Wide3 turned;       // `rotation` as a rotation vector
    Wide3 arm;          // of the anchor, current
    Wide3 swept;        // displacement of the anchor by that rotation
    bool any_along;     // some lanes store the spin in axes that rotate with the body
    WideQuat along;     // rotation of these axes

    JOSTLE_INLINE void load_from(const SolverBody* bodies, const std::int32_t* index,
                                 const float (*start_arm)[8]) {
        for (int k = 0; k < 8; k++) rows[k] = bodies[index[k]].v;
        load_rows(rows, 0, state);
        v = {state[0], state[1], state[2]};
        w = {state[3], state[4], state[5]};
        Wide motion[8], inertia[8];
        load_rows(rows, 8, motion);
        load_rows(rows, 16, inertia);
        dp = {motion[0], motion[1], motion[2]};
        inverse_mass = {state[6] * inertia[6], state[6] * inertia[7], state[6] * motion[6]};
        inverse_inertia = {inertia[0], inertia[1], inertia[2], inertia[3], inertia[4], inertia[5]};
        turned = {motion[3], motion[4], motion[5]};
        rotation = from_rotation_vector(turned);
        any_along = lane_bits(motion[7] > splat(0)) != 0;
        if (any_along) {
            along = turned_axes(motion[7], rotation);
            w = rotate(along, w);
            inverse_inertia = turned_by(along, inverse_inertia);
        }
        const Wide3 start = load3(start_arm);
        swept = rotated_by(rotation, start);
        arm = start + swept;
    }
    JOSTLE_INLINE void store_to() {
        state[0] = v.x, state[1] = v.y, state[2] = v.z;
        const Wide3 spin = any_along ? rotate(conjugate(along), w) : w;
        state[3] = spin.x, state[4] = spin.y, state[5] = spin.z;
        // Bodies that joints cannot push may be in several blocks at once, so they are not written.
        alignas(32) float discarded[8];
        float* to[8];
        for (int k = 0; k < 8; k++)
            to[k] = rows[k][6] > 0 ? const_cast<float*>(rows[k]) : discarded;
        store_rows(to, state);
    }
    JOSTLE_INLINE Wide3 push(Wide3 p) const {
        return {p.x * inverse_mass.x, p.y * inverse_mass.y, p.z * inverse_mass.z};
    }
};

struct JointPair {
    JointSide a, b;
    Wide3 apart;       // from a's anchor to b's, m
    WideQuat carried;  // rotation of the joint's impulses since the start of the step

    JOSTLE_INLINE JointPair(const JointConstraintWide& block, const SolverBody* bodies) {
        a.load_from(bodies, block.a, block.arm_a);
        b.load_from(bodies, block.b, block.arm_b);
        apart = load3(block.apart) + (b.dp - a.dp) + (b.swept - a.swept);
        const WideMask by_b = b.state[6] > splat(0);
        carried = {
            select(by_b, b.rotation.x, a.rotation.x), select(by_b, b.rotation.y, a.rotation.y),
            select(by_b, b.rotation.z, a.rotation.z), select(by_b, b.rotation.w, a.rotation.w)};
    }
    JOSTLE_INLINE void store() {
        a.store_to();
        b.store_to();
    }
    // Moves a's point of application and anchor velocity to b's anchor. Rows along a's axes are
    // then rates of that point in a's frame.
    JOSTLE_INLINE void apply_at_b() { a.arm = a.arm + apart; }
    JOSTLE_INLINE Wide3 to_world(const float (*impulse)[8]) const {
        return rotate(carried, load3(impulse));
    }
    JOSTLE_INLINE void store_impulse(float (*impulse)[8], Wide3 in_world) const {
        store3(impulse, rotate(conjugate(carried), in_world));
    }

    JOSTLE_INLINE Wide3 anchor_velocity() const {
        return (b.v + cross(b.w, b.arm)) - (a.v + cross(a.w, a.arm));
    }
    JOSTLE_INLINE Wide3 spin() const { return b.w - a.w; }
    // Speed of the two ends. The limit of the position correction rises with it.
    JOSTLE_INLINE Wide pace() const {
        const Wide3 at_a = a.v + cross(a.w, a.arm), at_b = b.v + cross(b.w, b.arm);
        return root(dot(at_a, at_a)) + root(dot(at_b, at_b));
    }

    // Applies an impulse to b at its anchor and the opposite one to a.
    JOSTLE_INLINE void push(Wide3 impulse) {
        a.v = a.v - a.push(impulse);
        a.w = a.w - a.inverse_inertia * cross(a.arm, impulse);
        b.v = b.v + b.push(impulse);
        b.w = b.w + b.inverse_inertia * cross(b.arm, impulse);
    }
    JOSTLE_INLINE void apply_angular(Wide3 impulse) {
        a.w = a.w - a.inverse_inertia * impulse;
        b.w = b.w + b.inverse_inertia * impulse;
    }

    // Response of the relative motion to an impulse at the anchors, or to an angular impulse.
    JOSTLE_INLINE WideSymmetric point_matrix() const {
        WideSymmetric k = across(a.inverse_inertia, a.arm) + across(b.inverse_inertia, b.arm);
        const Wide3 mass = a.inverse_mass + b.inverse_mass;
        k.xx += mass.x;
        k.yy += mass.y;
        k.zz += mass.z;
        return k;
    }
    JOSTLE_INLINE WideSymmetric turn_matrix() const {
        return a.inverse_inertia + b.inverse_inertia;
    }
    // Relative velocity of the anchors from an angular impulse.
    JOSTLE_INLINE Wide3 parted_by(Wide3 turn) const {
        return cross(b.inverse_inertia * turn, b.arm) + cross(a.inverse_inertia * turn, a.arm);
    }
};

// Coefficients of a spring, or of the maximum stiffness of the sub-step, in eight lanes
// (constraints/softness.h).
struct WideSoft {
    Wide position_rate, velocity_scale, impulse_scale;
    Wide push_speed, push_spin;  // maxima, m/s and rad/s
};
// Rows other than springs do not correct positions in the relaxing pass.
template <bool kRelax>
JOSTLE_INLINE WideSoft rigid(const JointStep& step) {
    if constexpr (kRelax) return {splat(0), splat(1), splat(0), splat(0), splat(0)};
    return {splat(step.position_rate), splat(step.velocity_scale), splat(step.impulse_scale),
            splat(step.push_speed), splat(step.push_spin)};
}
template <bool kRelax>
JOSTLE_INLINE WideSoft spring_of(const SoftRow& row) {
    const Wide any = splat(1e30f);
    const Wide part = kRelax ? splat(1) - load(row.once) : splat(1);
    return {load(row.position_rate) * part, load(row.velocity_scale) * part,
            load(row.impulse_scale) * part, any, any};
}
// Maximum speed that an error may add to a row.
JOSTLE_INLINE Wide max_push(const WideSoft& s, Wide most) {
    return most * max(s.velocity_scale, splat(1e-6f));
}
// The speed that an error adds to a row. If it would exceed `most`, it is clamped and the row
// becomes rigid: a soft row gives up part of its load, which a clamped speed may not replace.
struct PositionCorrection {
    Wide3 push;
    Wide velocity_scale, impulse_scale;
};
JOSTLE_INLINE PositionCorrection position_correction(Wide3 error, const WideSoft& s, Wide most) {
    const Wide3 push = error * s.position_rate;
    const Wide size2 = dot(push, push), limit = max_push(s, most);
    const WideMask over = size2 > limit * limit;
    if (lane_bits(over) == 0) return {push, s.velocity_scale, s.impulse_scale};  // usual case
    const Wide part = select(over, most / root(max(size2, splat(1e-30f))), splat(1));
    return {push * part, select(over, splat(1), s.velocity_scale),
            select(over, splat(0), s.impulse_scale)};
}

// The point row: keeps the anchors together. `impulse` is accumulated in world axes.
JOSTLE_INLINE void hold_points(JointPair& pair, const WideSoft& s, Wide3& impulse) {
    const PositionCorrection m = position_correction(pair.apart, s, s.push_speed + pair.pace());
    const Wide3 want = pair.anchor_velocity() * m.velocity_scale + m.push;
    const Wide3 d = -solve3(pair.point_matrix(), want) - impulse * m.impulse_scale;
    impulse = impulse + d;
    pair.push(d);
}

// All three rotations. `error`: rotation vector from the target orientation of b to its current
// one.
JOSTLE_INLINE void hold_rotation(JointPair& pair, const WideSoft& s, Wide3 error, Wide3& impulse) {
    const PositionCorrection m = position_correction(error, s, s.push_spin);
    const Wide3 want = pair.spin() * m.velocity_scale + m.push;
    const Wide3 d = -solve3(pair.turn_matrix(), want) - impulse * m.impulse_scale;
    impulse = impulse + d;
    pair.apply_angular(d);
}

// The two rotations perpendicular to an axis.
JOSTLE_INLINE void hold_axis(JointPair& pair, const WideSoft& s, Wide3 axis, Wide3 error,
                             Wide3& impulse) {
    const Wide zero = splat(0), one = splat(1);
    const WideMask not_x = splat(0.7f) > absolute(axis.x);
    const Wide3 other{select(not_x, one, zero), select(not_x, zero, one), zero};
    const Wide3 p = normalized(cross(axis, other), other), q = cross(axis, p);
    const WideSymmetric k = pair.turn_matrix();
    const Wide3 kp = k * p, kq = k * q;
    const Wide pp = dot(p, kp), pq = dot(p, kq), qq = dot(q, kq);
    const Wide scale = inverse_above(pp * qq - pq * pq, pp * qq * splat(1e-6f));
    const PositionCorrection m = position_correction(error, s, s.push_spin);
    const Wide3 want = pair.spin() * m.velocity_scale + m.push;
    const Wide ep = dot(p, want), eq = dot(q, want);
    // The impulse of the previous step is perpendicular to the previous axis.
    impulse = impulse - axis * dot(axis, impulse);
    const Wide3 d =
        -((p * (qq * ep - pq * eq) + q * (pp * eq - pq * ep)) * scale) - impulse * m.impulse_scale;
    impulse = impulse + d;
    pair.apply_angular(d);
}

// One degree of freedom: an angle about an axis, or a length along a line.
template <bool kAngular>
struct WideRow {
    static constexpr bool angular = kAngular;
    Wide3 direction;
    Wide response;  // inverse of the speed per impulse; 0 if the impulse has no effect

    JOSTLE_INLINE WideRow(const JointPair& pair, Wide3 unit) : direction(unit) {
        const WideSymmetric k = kAngular ? pair.turn_matrix() : pair.point_matrix();
        response = inverse_above(dot(unit, k * unit), splat(0));
    }
    JOSTLE_INLINE Wide speed(const JointPair& pair) const {
        return dot(direction, kAngular ? pair.spin() : pair.anchor_velocity());
    }
    JOSTLE_INLINE void apply(JointPair& pair, Wide impulse) const {
        if constexpr (kAngular)
            pair.apply_angular(direction * impulse);
        else
            pair.push(direction * impulse);
    }
};

// An angle about an axis of bodies that a point constraint holds together. The row includes the
// immediate response of the point. Rows that alternate with it would need as many more iterations
// as the bodies' inertia about the point exceeds their own inertia.
struct HeldRow {
    static constexpr bool angular = true;
    Wide3 direction, point_response;  // of the rotation; of the point's response
    Wide response;
    Wide own;  // speed per impulse without the point
    Wide3& point;

    JOSTLE_INLINE HeldRow(const JointPair& pair, Wide3 axis, Wide3& impulse)
        : direction(axis), point(impulse) {
        const Wide3 parts = pair.parted_by(axis);
        point_response = solve3(pair.point_matrix(), parts);
        own = dot(axis, pair.turn_matrix() * axis);
        response = inverse_above(own - dot(parts, point_response), own * splat(1e-4f));
    }
    JOSTLE_INLINE Wide speed(const JointPair& pair) const { return dot(direction, pair.spin()); }
    JOSTLE_INLINE void apply(JointPair& pair, Wide impulse) const {
        const Wide3 reaction = -(point_response * impulse);
        pair.apply_angular(direction * impulse);
        pair.push(reaction);
        point = point + reaction;
    }
};

// `left`: distance to the limit; negative beyond it. The accumulated impulse may push (>= 0) only
// along `sign` times the row's direction.
template <bool kRelax, class Row>
JOSTLE_INLINE void limit_row(JointPair& pair, const JointStep& step, const Row& row, float sign,
                             Wide left, float* stored) {
    const WideMask free = left > splat(0);
    const WideSoft s = rigid<kRelax>(step);
    // The distance to the limit may be used up within the sub-step, but not exceeded.
    const Wide most = Row::angular ? s.push_spin : s.push_speed, push = left * s.position_rate;
    const WideMask over = push < -max_push(s, most), soft = ~free & ~over;
    const Wide old_impulse = load(stored);
    const Wide toward = row.speed(pair) * splat(sign);
    const Wide want = toward * select(soft, s.velocity_scale, splat(1)) +
                      select(free, left * splat(step.inverse_h), select(over, -most, push));
    const Wide now = max(
        old_impulse - want * row.response - select(soft, s.impulse_scale, splat(0)) * old_impulse,
        splat(0));
    row.apply(pair, (now - old_impulse) * splat(sign));
    store(stored, now);
}

// An angle of -pi..pi as the same angle within half a turn of `near`.
JOSTLE_INLINE Wide nearest_angle(Wide angle, Wide near) {
    const Wide half = splat(3.14159265f), turn = splat(6.28318531f), off = angle - near;
    return angle + select(off > half, -turn, select(-half > off, turn, splat(0)));
}
// The limits of a rotation (constraints/joints/angles.h), and its angle as they read it.
struct WideLimits {
    Wide lower_at, upper_at;
    WideMask ambiguous;

    JOSTLE_INLINE WideLimits(const float* lower, const float* upper)
        : lower_at(load(lower)), upper_at(load(upper)) {
        const Wide range = upper_at - lower_at;
        ambiguous =
            (range > splat(as_float(ambiguous_range))) & (splat(as_float(2 * pi + 1e-3)) > range);
    }
    JOSTLE_INLINE Wide read(Wide angle, const float* lower, const float* upper) const {
        const Wide zero = splat(0), middle = (lower_at + upper_at) * splat(0.5f);
        const Wide side =
            select(load(upper) > zero, upper_at, select(load(lower) > zero, lower_at, middle));
        return nearest_angle(angle, select(ambiguous, side, middle));
    }
    // Displacement of a spring from its rest angle. Lanes without limits have distant ones.
    JOSTLE_INLINE Wide stretch(Wide angle, Wide rest) const {
        return select(upper_at > splat(1e29f), nearest_angle(angle, rest), angle) - rest;
    }
    JOSTLE_INLINE void mark(Wide angle, float* lower, float* upper) const {
        if (lane_bits(ambiguous) == 0) return;
        const Wide margin = splat(as_float(side_margin)), least = splat(as_float(side_mark));
        store(lower, select(ambiguous & (lower_at + margin > angle), max(load(lower), least),
                            load(lower)));
        store(upper, select(ambiguous & (angle > upper_at - margin), max(load(upper), least),
                            load(upper)));
    }
};

// Pulls the row's value `error` to zero with at most `strongest` per sub-step.
template <bool kAngular>
JOSTLE_INLINE void spring_row(JointPair& pair, const WideRow<kAngular>& row, const WideSoft& s,
                              Wide error, Wide strongest, float* stored) {
    const Wide old_impulse = load(stored);
    const Wide most = kAngular ? s.push_spin : s.push_speed, push = error * s.position_rate;
    const WideMask over = absolute(push) > max_push(s, most);
    const Wide want = row.speed(pair) * select(over, splat(1), s.velocity_scale) +
                      select(over, max(min(push, most), -most), push);
    const Wide desired =
        -(want * row.response) - select(over, splat(0), s.impulse_scale) * old_impulse;
    const Wide now = max(min(old_impulse + desired, strongest), -strongest);
    const Wide d = select(absolute(old_impulse + desired) > strongest, now - old_impulse, desired);
    store(stored, now);
    row.apply(pair, d);
}

// The same for a row with the point's response: the spring has the stiffness that it has without
// the point.
JOSTLE_INLINE void spring_row(JointPair& pair, const HeldRow& row, const WideSoft& s, Wide error,
                              Wide strongest, float* stored) {
    const Wide old_impulse = load(stored);
    const Wide soft = row.own * s.impulse_scale;
    const Wide want =
        row.speed(pair) * s.velocity_scale + error * s.position_rate + soft * old_impulse;
    const Wide held = inverse_above(row.response, splat(0));
    const Wide desired =
        old_impulse - want * inverse_above(held * s.velocity_scale + soft, splat(0));
    const Wide now = max(min(desired, strongest), -strongest);
    store(stored, now);
    row.apply(pair, now - old_impulse);
}

// Drives the row's speed to the target with at most `most` per sub-step.
template <class Row>
JOSTLE_INLINE void motor_row(JointPair& pair, const Row& row, Wide speed, Wide most,
                             float* stored) {
    const Wide old_impulse = load(stored);
    const Wide now = max(min(old_impulse - (row.speed(pair) - speed) * row.response, most), -most);
    row.apply(pair, now - old_impulse);
    store(stored, now);
}

}  // namespace jostle::physics::JOSTLE_ISA
