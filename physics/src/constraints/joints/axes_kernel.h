// SPDX-License-Identifier: MIT
//
// Sliders, six-dofs and wheels: six axes, each locked, or with a limit, a spring, a motor and
// friction (axes_layout.h). The locked translations are solved together, and so are the locked
// rotations, so that six locked axes are as good as a fixed joint. Each free axis is a separate
// row.
#pragma once

#include "physics/src/constraints/joints/joint_pair.h"

namespace jostle::physics::JOSTLE_ISA {

// Three rows, some of them locked. `impulse` is along the rows and zero for free ones.
template <bool kAngular>
JOSTLE_INLINE void hold_locked(JointPair& pair, const WideSoft& s, const Wide3* rows, Wide3 locked,
                               Wide3 error, Wide most, Wide3& impulse) {
    const auto masked = [&](Wide3 v) -> Wide3 {
        return {v.x * locked.x, v.y * locked.y, v.z * locked.z};
    };
    const WideSymmetric k = kAngular ? pair.turn_matrix() : pair.point_matrix();
    const Wide3 kx = k * rows[0], ky = k * rows[1], kz = k * rows[2];
    const WideSymmetric m{dot(rows[0], kx) * locked.x,
                          dot(rows[1], ky) * locked.y,
                          dot(rows[2], kz) * locked.z,
                          dot(rows[0], ky) * locked.x * locked.y,
                          dot(rows[0], kz) * locked.x * locked.z,
                          dot(rows[1], kz) * locked.y * locked.z};
    const PositionCorrection correction = position_correction(masked(error), s, most);
    const Wide3 speed = kAngular ? pair.spin() : pair.anchor_velocity();
    const Wide3 along{dot(rows[0], speed), dot(rows[1], speed), dot(rows[2], speed)};
    const Wide3 want = masked(along) * correction.velocity_scale + correction.push;
    const Wide3 d = -masked(solve3(m, want)) - impulse * correction.impulse_scale;
    impulse = impulse + d;
    const Wide3 total = rows[0] * d.x + rows[1] * d.y + rows[2] * d.z;
    if constexpr (kAngular)
        pair.apply_angular(total);
    else
        pair.push(total);
}

struct AxesKernel {
    using Own = JointAxesWide;

    // The current poses of the bodies. GimbalRows and GimbalAngles (axes_layout.h) define the
    // rotations.
    struct Axes {
        Wide3 along[3];  // a's axes, world
        Wide3 about[3];  // the rows of the rotations, world
        Wide offset[3], angle[3];

        JOSTLE_INLINE Axes(JointPair& pair, const JointAxesWide& t) {
            const WideQuat start = load4(t.frame_a), frame = pair.a.rotation * start;
            along[0] = x_axis(frame), along[1] = y_axis(frame), along[2] = z_axis(frame);
            for (int k = 0; k < 3; k++) offset[k] = dot(along[k], pair.apart);
            // b's frame relative to a's, so that small angles keep their precision.
            const WideQuat since = conjugate(pair.a.rotation) * pair.b.rotation;
            const Wide3 turned = rotate(conjugate(start), {since.x, since.y, since.z});
            const WideQuat q = WideQuat{turned.x, turned.y, turned.z, since.w} * load4(t.turn);
            const Wide xx = splat(1) - splat(2) * (q.y * q.y + q.z * q.z);
            const Wide xy = splat(2) * (q.x * q.y - q.z * q.w);
            const Wide3 last{splat(2) * (q.x * q.z + q.y * q.w), splat(2) * (q.y * q.z - q.x * q.w),
                             splat(1) - splat(2) * (q.x * q.x + q.y * q.y)};
            angle[0] = arc_tangent(-last.y, last.z);
            angle[1] = arc_tangent(last.x, root(xx * xx + xy * xy));
            angle[2] = arc_tangent(-xy, xx);
            const Wide3 middle =
                normalized({splat(0), last.z, -last.y}, {splat(0), splat(1), splat(0)});
            const Wide cosine = root(last.y * last.y + last.z * last.z);
            const Wide share = splat(1) / max(cosine, splat(0.05f));
            about[0] = to_world(cross(middle, last) * share);
            about[1] = to_world(middle);
            about[2] = to_world(Wide3{splat(0), -middle.z, middle.y} * share);
        }
        // The first axis follows an arc that curves towards the second: computes b's position along
        // it and distance from it.
        JOSTLE_INLINE void bend(Wide curvature) {
            const Wide u = offset[0], n = offset[1], one = splat(1);
            const Wide c = one - curvature * n, s = curvature * u;
            const Wide size = root(c * c + s * s), share = one / max(size, splat(1e-6f));
            const Wide3 x = (along[0] * c + along[1] * s) * share;
            along[1] = (along[1] * c - along[0] * s) * share;
            along[0] = x;
            const WideMask bent = curvature > splat(1e-6f);
            offset[0] = select(bent, arc_tangent(s, c) / select(bent, curvature, one), u);
            offset[1] = (n + n - curvature * (u * u + n * n)) / (one + size);
        }
        JOSTLE_INLINE Wide3 to_world(Wide3 v) const {
            return along[0] * v.x + along[1] * v.y + along[2] * v.z;
        }
        JOSTLE_INLINE Wide3 along_axes(Wide3 v) const {
            return {dot(along[0], v), dot(along[1], v), dot(along[2], v)};
        }
    };

    static JOSTLE_INLINE Wide3 locked(const JointAxesWide& t, int first) {
        return {load(t.locked[first]), load(t.locked[first + 1]), load(t.locked[first + 2])};
    }
    // Selects the body that the point impulse rotates with.
    static JOSTLE_INLINE void set_carrier(JointPair& pair, const JointAxesWide& t) {
        const WideMask by_a = load(t.by_a) > splat(0);
        pair.carried = {select(by_a, pair.a.rotation.x, pair.carried.x),
                        select(by_a, pair.a.rotation.y, pair.carried.y),
                        select(by_a, pair.a.rotation.z, pair.carried.z),
                        select(by_a, pair.a.rotation.w, pair.carried.w)};
    }
    // The stored impulse along the axes that are now locked. The axes have rotated slightly since
    // it was stored.
    static JOSTLE_INLINE Wide3 point_impulse(const JointPair& pair, const Axes& axes,
                                             const JointConstraintWide& block,
                                             const JointAxesWide& t) {
        const Wide3 v = axes.along_axes(pair.to_world(block.point)), held = locked(t, 0);
        return {v.x * held.x, v.y * held.y, v.z * held.z};
    }
    static JOSTLE_INLINE Wide free_impulse(const JointAxisWide& t) {
        return load(t.lower) - load(t.upper) + load(t.spring) + load(t.motor) + load(t.friction);
    }
    static JOSTLE_INLINE Wide3 free_impulse(const JointAxesWide& t, unsigned uses, int first) {
        const auto of = [&](int k) {
            return (uses >> 4 * k & 15) != 0 ? free_impulse(t.axes[k]) : splat(0);
        };
        return {of(first), of(first + 1), of(first + 2)};
    }

    static void warm_start(JointPair& pair, JointConstraintWide& block, JointAxesWide& t,
                           unsigned uses) {
        pair.apply_at_b();
        set_carrier(pair, t);
        Axes axes(pair, t);
        if ((uses & uses_curve) != 0) axes.bend(load(t.curvature));
        const Wide3 point = point_impulse(pair, axes, block, t) + free_impulse(t, uses, 0);
        const Wide3 turns = load3(t.turns) + free_impulse(t, uses, 3);
        pair.push(axes.to_world(point));
        pair.apply_angular(axes.about[0] * turns.x + axes.about[1] * turns.y +
                           axes.about[2] * turns.z);
    }

    // The weakest row first, so that the row that must hold is solved last.
    template <bool kRelax, bool kAngular>
    static JOSTLE_INLINE void solve_free(JointPair& pair, const JointStep& step, Wide3 direction,
                                         Wide at, JointAxisWide& t, unsigned uses) {
        if (uses == 0) return;
        const WideRow<kAngular> row(pair, direction);
        const WideLimits limits(t.lower_at, t.upper_at);
        if constexpr (kAngular) at = limits.read(at, t.lower, t.upper);
        if ((uses & uses_spring) != 0) {
            const Wide rest = load(t.spring_at);
            spring_row(pair, row, spring_of<kRelax>(t.soft),
                       kAngular ? limits.stretch(at, rest) : at - rest, load(t.spring_most),
                       t.spring);
        }
        if ((uses & uses_friction) != 0)
            motor_row(pair, row, splat(0), load(t.friction_most), t.friction);
        if ((uses & uses_motor) != 0)
            motor_row(pair, row, load(t.motor_speed), load(t.motor_most), t.motor);
        if ((uses & uses_limit) != 0) {
            limit_row<kRelax>(pair, step, row, 1, at - load(t.lower_at), t.lower);
            limit_row<kRelax>(pair, step, row, -1, load(t.upper_at) - at, t.upper);
            if constexpr (kAngular) limits.mark(at, t.lower, t.upper);
        }
    }

    template <bool kRelax>
    static JointLoad solve(JointPair& pair, const JointStep& step, JointConstraintWide& block,
                           JointAxesWide& t, unsigned uses) {
        pair.apply_at_b();
        set_carrier(pair, t);
        Axes axes(pair, t);
        if ((uses & uses_curve) != 0) axes.bend(load(t.curvature));
        for (int k = 0; k < 3; k++)
            solve_free<kRelax, true>(pair, step, axes.about[k], axes.angle[k], t.axes[k + 3],
                                     uses >> 4 * (k + 3) & 15);
        for (int k = 0; k < 3; k++)
            solve_free<kRelax, false>(pair, step, axes.along[k], axes.offset[k], t.axes[k],
                                      uses >> 4 * k & 15);
        const WideSoft s = rigid<kRelax>(step);
        Wide3 turns = load3(t.turns), point = point_impulse(pair, axes, block, t);
        hold_locked<true>(pair, s, axes.about, locked(t, 3),
                          {axes.angle[0], axes.angle[1], axes.angle[2]}, s.push_spin, turns);
        hold_locked<false>(pair, s, axes.along, locked(t, 0),
                           {axes.offset[0], axes.offset[1], axes.offset[2]},
                           s.push_speed + pair.pace(), point);
        store3(t.turns, turns);
        const Wide3 held = axes.to_world(point);
        pair.store_impulse(block.point, held);
        turns = turns + free_impulse(t, uses, 3);
        return {held + axes.to_world(free_impulse(t, uses, 0)),
                axes.about[0] * turns.x + axes.about[1] * turns.y + axes.about[2] * turns.z};
    }
};

}  // namespace jostle::physics::JOSTLE_ISA
