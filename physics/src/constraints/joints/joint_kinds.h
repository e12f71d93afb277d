// SPDX-License-Identifier: MIT
//
// One kernel struct per joint kind. warm_start() applies the impulses of the previous sub-step, and
// solve() updates them and returns the load that the joint exerted on b, in world axes. Own: the
// kind-specific data of a block.
#pragma once

#include "jostle/physics/joint_defs.h"
#include "physics/src/constraints/joints/axes_kernel.h"
#include "physics/src/constraints/joints/gear_kernel.h"
#include "physics/src/constraints/joints/joint_pair.h"

namespace jostle::physics::JOSTLE_ISA {

template <class Kind>
struct JointKernel;

template <>
struct JointKernel<BallJoint> {
    using Own = JointAngularWide;
    JOSTLE_INLINE static void warm_start(JointPair& pair, JointConstraintWide& block,
                                         JointAngularWide&, unsigned) {
        pair.push(pair.to_world(block.point));
    }
    template <bool kRelax>
    JOSTLE_INLINE static JointLoad solve(JointPair& pair, const JointStep& step,
                                         JointConstraintWide& block, JointAngularWide&,
                                         unsigned uses) {
        Wide3 point = pair.to_world(block.point);
        if ((uses & uses_batch) == 0) hold_points(pair, rigid<kRelax>(step), point);
        pair.store_impulse(block.point, point);
        return {point, Wide3{}};
    }
};

// Friction against all rotation.
JOSTLE_INLINE void rub(JointPair& pair, JointAngularWide& t, Wide3& friction) {
    const Wide3 stop = friction - solve3(pair.turn_matrix(), pair.spin());
    const Wide size = root(dot(stop, stop)), most = load(t.motor_most);
    const WideMask slips = size > most;
    const Wide share = select(slips, most / select(slips, size, splat(1)), splat(1));
    pair.apply_angular(stop * share - friction);
    friction = stop * share;
    pair.store_impulse(t.friction, friction);
}
// A spring towards an orientation with a maximum torque. The error is the shorter rotation from
// that orientation to b's.
template <bool kRelax>
JOSTLE_INLINE void drive_turn(JointPair& pair, JointAngularWide& t, Wide3& impulse, Wide3& point) {
    const WideQuat q = pair.b.rotation * load4(t.drive) * conjugate(pair.a.rotation);
    const Wide sign = select(splat(0) > q.w, splat(-1), splat(1));
    const Wide3 axis = Wide3{q.x, q.y, q.z} * sign;
    const Wide sine = root(dot(axis, axis));
    const WideMask turned = sine > splat(1e-6f);
    const Wide scale =
        select(turned, splat(2) * arc_tangent(sine, q.w * sign) / select(turned, sine, splat(1)),
               splat(2));
    // The point responds immediately (HeldRow), here to a rotation about each world axis.
    const Wide one = splat(1), zero = splat(0);
    const Wide3 units[] = {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
    const WideSymmetric points = pair.point_matrix(), own = pair.turn_matrix();
    Wide3 parts[3], reactions[3];
    for (int k = 0; k < 3; k++) {
        parts[k] = pair.parted_by(units[k]);
        reactions[k] = solve3(points, parts[k]);
    }
    const WideSoft s = spring_of<kRelax>(t.spring_soft);
    const auto held = [&](int i, int k, Wide m) {
        return (m - dot(parts[i], reactions[k])) * s.velocity_scale + m * s.impulse_scale;
    };
    const WideSymmetric matrix{held(0, 0, own.xx), held(1, 1, own.yy), held(2, 2, own.zz),
                               held(0, 1, own.xy), held(0, 2, own.xz), held(1, 2, own.yz)};
    const Wide3 want = pair.spin() * s.velocity_scale + axis * (scale * s.position_rate) +
                       (own * impulse) * s.impulse_scale;
    Wide3 target = impulse - solve3(matrix, want);
    const Wide size = root(dot(target, target)), most = load(t.drive_most);
    const WideMask strong = size > most;
    target = target * select(strong, most / select(strong, size, splat(1)), splat(1));
    const Wide3 change = target - impulse;
    const Wide3 reaction =
        -(reactions[0] * change.x + reactions[1] * change.y + reactions[2] * change.z);
    pair.apply_angular(change);
    pair.push(reaction);
    point = point + reaction;
    impulse = target;
    pair.store_impulse(t.angular, impulse);
}

// A ball joint with a drive or friction: see constraint_graph/joint_memory.h.
struct DrivenBall {};
template <>
struct JointKernel<DrivenBall> {
    using Own = JointAngularWide;
    JOSTLE_INLINE static void warm_start(JointPair& pair, JointConstraintWide& block,
                                         JointAngularWide& t, unsigned) {
        pair.push(pair.to_world(block.point));
        pair.apply_angular(pair.to_world(t.angular) + pair.to_world(t.friction));
    }
    template <bool kRelax>
    JOSTLE_INLINE static JointLoad solve(JointPair& pair, const JointStep& step,
                                         JointConstraintWide& block, JointAngularWide& t,
                                         unsigned uses) {
        Wide3 driven = pair.to_world(t.angular), friction = pair.to_world(t.friction);
        Wide3 point = pair.to_world(block.point);
        if ((uses & uses_drive) != 0) drive_turn<kRelax>(pair, t, driven, point);
        if ((uses & uses_motor) != 0) rub(pair, t, friction);
        if ((uses & uses_batch) == 0) hold_points(pair, rigid<kRelax>(step), point);
        pair.store_impulse(block.point, point);
        return {point, driven + friction};
    }
};

template <>
struct JointKernel<HingeJoint> {
    using Own = JointAngularWide;
    JOSTLE_INLINE static Wide along_axis(const JointAngularWide& t) {
        return load(t.lower) - load(t.upper) + load(t.spring) + load(t.motor);
    }
    JOSTLE_INLINE static void warm_start(JointPair& pair, JointConstraintWide& block,
                                         JointAngularWide& t, unsigned) {
        const Wide3 axis = z_axis(pair.a.rotation * load4(t.frame_a));
        pair.push(pair.to_world(block.point));
        pair.apply_angular(pair.to_world(t.angular) + axis * along_axis(t));
    }
    template <bool kRelax>
    JOSTLE_INLINE static JointLoad solve(JointPair& pair, const JointStep& step,
                                         JointConstraintWide& block, JointAngularWide& t,
                                         unsigned uses) {
        const WideQuat frame_a = pair.a.rotation * load4(t.frame_a);
        const WideQuat frame_b = pair.b.rotation * load4(t.frame_b);
        const Wide3 axis = z_axis(frame_a);
        Wide3 angular = pair.to_world(t.angular), point = pair.to_world(block.point);
        if ((uses & ~uses_batch) != 0) {
            const HeldRow row(pair, axis, point);
            const Wide3 x = x_axis(frame_b);
            const WideLimits limits(t.lower_at, t.upper_at);
            const Wide angle = limits.read(
                arc_tangent(dot(x, y_axis(frame_a)), dot(x, x_axis(frame_a))), t.lower, t.upper);
            // The weakest row first, so that the row that must hold is solved last.
            if ((uses & uses_spring) != 0)
                spring_row(pair, row, spring_of<kRelax>(t.spring_soft),
                           limits.stretch(angle, load(t.spring_at)), load(t.drive_most), t.spring);
            if ((uses & uses_motor) != 0)
                motor_row(pair, row, load(t.motor_speed), load(t.motor_most), t.motor);
            if ((uses & uses_limit) != 0) {
                limit_row<kRelax>(pair, step, row, 1, angle - load(t.lower_at), t.lower);
                limit_row<kRelax>(pair, step, row, -1, load(t.upper_at) - angle, t.upper);
                limits.mark(angle, t.lower, t.upper);
                jostle::physics::JOSTLE_ISA::store(
                    t.margin, min(angle - load(t.lower_at), load(t.upper_at) - angle));
            }
        }
        hold_axis(pair, rigid<kRelax>(step), axis, cross(axis, z_axis(frame_b)), angular);
        if ((uses & uses_batch) == 0) hold_points(pair, rigid<kRelax>(step), point);
        pair.store_impulse(t.angular, angular);
        pair.store_impulse(block.point, point);
        return {point, angular + axis * along_axis(t)};
    }
};

template <>
struct JointKernel<ConeTwistJoint> {
    using Own = JointAngularWide;
    struct Axes {
        Wide3 swing;        // axis about which b's x axis is rotated away from a's
        Wide3 twist;        // times b's spin relative to a: the rate of the twist angle
        Wide sine, cosine;  // of the swing angle

        JOSTLE_INLINE Axes(WideQuat frame_a, WideQuat frame_b) {
            const Wide3 a = x_axis(frame_a), b = x_axis(frame_b), away = cross(a, b);
            sine = root(dot(away, away));
            cosine = dot(a, b);
            swing = normalized(away, y_axis(frame_a));
            // At a swing of 180 degrees the twist is undefined.
            twist = (a + b) * (splat(1) / max(splat(1) + cosine, splat(0.05f)));
        }
        JOSTLE_INLINE Wide3 total(const JointAngularWide& t, Wide3 friction) const {
            return twist * (load(t.lower) - load(t.upper)) - swing * load(t.swing) + friction;
        }
    };
    JOSTLE_INLINE static void warm_start(JointPair& pair, JointConstraintWide& block,
                                         JointAngularWide& t, unsigned uses) {
        const Axes axes(pair.a.rotation * load4(t.frame_a), pair.b.rotation * load4(t.frame_b));
        pair.push(pair.to_world(block.point));
        const Wide3 total = axes.total(t, pair.to_world(t.friction));
        pair.apply_angular((uses & uses_drive) != 0 ? total + pair.to_world(t.angular) : total);
    }
    template <bool kRelax>
    JOSTLE_INLINE static JointLoad solve(JointPair& pair, const JointStep& step,
                                         JointConstraintWide& block, JointAngularWide& t,
                                         unsigned uses) {
        const WideQuat frame_a = pair.a.rotation * load4(t.frame_a);
        const WideQuat frame_b = pair.b.rotation * load4(t.frame_b);
        const Axes axes(frame_a, frame_b);
        Wide3 friction = pair.to_world(t.friction), point = pair.to_world(block.point);
        Wide3 driven{splat(0), splat(0), splat(0)};
        Wide margin = splat(1e30f);
        if ((uses & uses_drive) != 0) {
            driven = pair.to_world(t.angular);
            drive_turn<kRelax>(pair, t, driven, point);
        }
        if ((uses & uses_motor) != 0) rub(pair, t, friction);
        if ((uses & uses_limit) != 0) {
            const WideQuat q = conjugate(frame_a) * frame_b;
            // q and -q are the same rotation. Use the one of less than 180 degrees.
            const Wide sign = select(splat(0) > q.w, splat(-1), splat(1));
            const WideLimits limits(t.lower_at, t.upper_at);
            const Wide twist =
                limits.read(splat(2) * arc_tangent(q.x * sign, q.w * sign), t.lower, t.upper);
            const HeldRow row(pair, axes.twist, point);
            limit_row<kRelax>(pair, step, row, 1, twist - load(t.lower_at), t.lower);
            limit_row<kRelax>(pair, step, row, -1, load(t.upper_at) - twist, t.upper);
            limits.mark(twist, t.lower, t.upper);
            margin = min(twist - load(t.lower_at), load(t.upper_at) - twist);
        }
        const Wide swing = arc_tangent(axes.sine, axes.cosine);
        jostle::physics::JOSTLE_ISA::store(t.margin, min(margin, load(t.swing_at) - swing));
        limit_row<kRelax>(pair, step, HeldRow(pair, axes.swing, point), -1,
                          load(t.swing_at) - swing, t.swing);
        if ((uses & uses_batch) == 0) hold_points(pair, rigid<kRelax>(step), point);
        pair.store_impulse(block.point, point);
        const Wide3 total = axes.total(t, friction);
        return {point, (uses & uses_drive) != 0 ? total + driven : total};
    }
};

template <bool kRelax>
JOSTLE_INLINE WideSoft soft_or_rigid(const JointStep& step, const SoftRow& row) {
    const WideSoft spring = spring_of<kRelax>(row), stiff = rigid<kRelax>(step);
    const WideMask applied = load(row.impulse_scale) > splat(0);
    return {select(applied, spring.position_rate, stiff.position_rate),
            select(applied, spring.velocity_scale, stiff.velocity_scale),
            select(applied, spring.impulse_scale, stiff.impulse_scale),
            select(applied, spring.push_speed, stiff.push_speed),
            select(applied, spring.push_spin, stiff.push_spin)};
}

template <>
struct JointKernel<FixedJoint> {
    using Own = JointAngularWide;
    JOSTLE_INLINE static void warm_start(JointPair& pair, JointConstraintWide& block,
                                         JointAngularWide& t, unsigned) {
        pair.push(pair.to_world(block.point));
        pair.apply_angular(pair.to_world(t.angular));
    }
    template <bool kRelax>
    JOSTLE_INLINE static JointLoad solve(JointPair& pair, const JointStep& step,
                                         JointConstraintWide& block, JointAngularWide& t,
                                         unsigned uses) {
        // The shorter rotation from a's frame to b's. frame_b contains that rotation at the start.
        const WideQuat q = pair.b.rotation * load4(t.frame_b) * conjugate(pair.a.rotation);
        const Wide sign = select(splat(0) > q.w, splat(-2), splat(2));
        Wide3 angular = pair.to_world(t.angular), point = pair.to_world(block.point);
        hold_rotation(pair, soft_or_rigid<kRelax>(step, t.spring_soft), Wide3{q.x, q.y, q.z} * sign,
                      angular);
        if ((uses & uses_batch) == 0)
            hold_points(pair, soft_or_rigid<kRelax>(step, t.point_soft), point);
        pair.store_impulse(t.angular, angular);
        pair.store_impulse(block.point, point);
        return {point, angular};
    }
};

template <>
struct JointKernel<DistanceJoint> {
    using Own = JointAngularWide;
    // From a's anchor to b's. Up if the anchors coincide.
    JOSTLE_INLINE static Wide3 line_of(const JointPair& pair) {
        return normalized(pair.apart, {splat(0), splat(1), splat(0)});
    }
    JOSTLE_INLINE static Wide along(const JointAngularWide& t) {
        return load(t.spring) + load(t.lower) - load(t.upper);
    }
    JOSTLE_INLINE static void warm_start(JointPair& pair, JointConstraintWide&, JointAngularWide& t,
                                         unsigned) {
        pair.push(line_of(pair) * along(t));
    }
    template <bool kRelax>
    JOSTLE_INLINE static JointLoad solve(JointPair& pair, const JointStep& step,
                                         JointConstraintWide&, JointAngularWide& t, unsigned uses) {
        const Wide3 line = line_of(pair);
        const WideRow<false> row(pair, line);
        const Wide now = root(dot(pair.apart, pair.apart));
        // A rod is a spring with the maximum stiffness of the sub-step, a row that pulls and
        // pushes.
        if ((uses & uses_spring) != 0)
            spring_row(pair, row, soft_or_rigid<kRelax>(step, t.spring_soft),
                       now - load(t.spring_at), splat(1e30f), t.spring);
        if ((uses & uses_limit) != 0) {
            limit_row<kRelax>(pair, step, row, 1, now - load(t.lower_at), t.lower);
            limit_row<kRelax>(pair, step, row, -1, load(t.upper_at) - now, t.upper);
        }
        return {line * along(t), Wide3{}};
    }
};

template <>
struct JointKernel<VelocityRow> {
    using Own = VelocityRowWide;
    // About the centres of mass.
    struct Jacobian {
        Wide3 linear_a, angular_a, linear_b, angular_b;

        JOSTLE_INLINE Jacobian(const JointPair& pair, const VelocityRowWide& t) {
            const Wide turns = load(t.turns);
            linear_a = turned(pair.a, t.linear_a, turns);
            linear_b = turned(pair.b, t.linear_b, turns);
            angular_a = turned(pair.a, t.angular_a, turns) + cross(pair.a.arm, linear_a);
            angular_b = turned(pair.b, t.angular_b, turns) + cross(pair.b.arm, linear_b);
        }
        JOSTLE_INLINE static Wide3 turned(const JointSide& side, const float (*at_start)[8],
                                          Wide turns) {
            const Wide3 v = load3(at_start);
            return v + rotated_by(side.rotation, v) * turns;
        }
        JOSTLE_INLINE Wide rate(const JointPair& pair) const {
            return (dot(linear_a, pair.a.v) + dot(angular_a, pair.a.w)) +
                   (dot(linear_b, pair.b.v) + dot(angular_b, pair.b.w));
        }
        // Rate of change per unit impulse.
        JOSTLE_INLINE Wide effective(const JointPair& pair) const {
            return (dot(linear_a, pair.a.push(linear_a)) +
                    dot(angular_a, pair.a.inverse_inertia * angular_a)) +
                   (dot(linear_b, pair.b.push(linear_b)) +
                    dot(angular_b, pair.b.inverse_inertia * angular_b));
        }
        JOSTLE_INLINE void apply(JointPair& pair, Wide impulse) const {
            pair.a.v = pair.a.v + pair.a.push(linear_a) * impulse;
            pair.a.w = pair.a.w + pair.a.inverse_inertia * angular_a * impulse;
            pair.b.v = pair.b.v + pair.b.push(linear_b) * impulse;
            pair.b.w = pair.b.w + pair.b.inverse_inertia * angular_b * impulse;
        }
    };
    JOSTLE_INLINE static void warm_start(JointPair& pair, JointConstraintWide&, VelocityRowWide& t,
                                         unsigned) {
        Jacobian(pair, t).apply(pair, load(t.impulse));
    }
    template <bool kRelax>
    JOSTLE_INLINE static JointLoad solve(JointPair& pair, const JointStep&, JointConstraintWide&,
                                         VelocityRowWide& t, unsigned) {
        const Jacobian jacobian(pair, t);
        const Wide softness = load(t.softness), old = load(t.impulse);
        const Wide target = kRelax ? load(t.speed) : load(t.speed) - load(t.bias);
        const Wide response = inverse_above(jacobian.effective(pair) + softness, splat(0));
        const Wide error = jacobian.rate(pair) + softness * old - target;
        const Wide now = max(min(old - error * response, load(t.upper)), load(t.lower));
        jacobian.apply(pair, now - old);
        store(t.impulse, now);
        return {jacobian.linear_b * now,
                (jacobian.angular_b - cross(pair.b.arm, jacobian.linear_b)) * now};
    }
};

// Fields of JointAngularWide in use: point_soft, motor_most (of the point), spring_soft (of the
// spin).
template <>
struct JointKernel<GrabJoint> {
    using Own = JointAngularWide;
    JOSTLE_INLINE static void warm_start(JointPair& pair, JointConstraintWide& block,
                                         JointAngularWide& t, unsigned) {
        pair.push(pair.to_world(block.point));
        pair.apply_angular(pair.to_world(t.angular));
    }
    template <bool kRelax>
    JOSTLE_INLINE static JointLoad solve(JointPair& pair, const JointStep&,
                                         JointConstraintWide& block, JointAngularWide& t,
                                         unsigned uses) {
        Wide3 angular = pair.to_world(t.angular), point = pair.to_world(block.point);
        if ((uses & uses_spring) != 0) {
            const Wide zero = splat(0);
            hold_rotation(pair, spring_of<kRelax>(t.spring_soft), {zero, zero, zero}, angular);
            pair.store_impulse(t.angular, angular);
        }
        const Wide3 old = point;
        Wide3 target = point;
        JointPair tried = pair;
        hold_points(tried, spring_of<kRelax>(t.point_soft), target);
        const Wide size = root(dot(target, target)), most = load(t.motor_most);
        const WideMask strong = size > most;
        point = target * select(strong, most / select(strong, size, splat(1)), splat(1));
        pair.push(point - old);
        pair.store_impulse(block.point, point);
        return {point, angular};
    }
};

template <>
struct JointKernel<GearJoint> : GearTag {};
template <>
struct JointKernel<RackJoint> : GearTag {};
template <>
struct JointKernel<PulleyJoint> : GearTag {};

template <>
struct JointKernel<SliderJoint> : AxesKernel {};
template <>
struct JointKernel<SixDofJoint> : AxesKernel {};
template <>
struct JointKernel<WheelJoint> : AxesKernel {};
template <>
struct JointKernel<PathJoint> : AxesKernel {};

}  // namespace jostle::physics::JOSTLE_ISA
