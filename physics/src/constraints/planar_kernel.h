// SPDX-License-Identifier: MIT
//
// The contact passes of planar worlds: bodies have three degrees of freedom, manifolds two points
// and one friction direction. The two normal impulses of a manifold are solved together as a linear
// complementarity problem (Catto, "Box2D" block solver, 2009). Same blocks, same order and same
// rules as contact_kernel.h. Out-of-plane data is neither loaded nor computed.
#pragma once

#include "physics/src/constraints/contact_kernel.h"

namespace jostle::physics::JOSTLE_ISA {

struct PlanarSide {
    const float* rows[lane_count];
    Wide state[8];  // row 0
    Wide vx, vy, w;
};

JOSTLE_INLINE void load_planar(PlanarSide& s, const SolverBody* bodies, const std::int32_t* index) {
    for (int k = 0; k < lane_count; k++) s.rows[k] = bodies[index[side_index(k)]].v;
    load_rows(s.rows, 0, s.state);
    s.vx = s.state[0];
    s.vy = s.state[1];
    s.w = s.state[5];
}
JOSTLE_INLINE void store_planar(PlanarSide& s) {
    s.state[0] = s.vx;
    s.state[1] = s.vy;
    s.state[5] = s.w;
    store_rows(const_cast<float* const*>(s.rows), s.state);
}

// Two bodies, the normal (nx, ny), the tangent (tx, ty) and the arms of the manifold's centre.
template <PairKind kPair>
struct PlanarBodies {
    PlanarSide a, b;
    Wide nx, ny, tx, ty, ax, ay, bx, by;
    Wide z_sign;  // +1 or -1: sign of the second tangent along z

    JOSTLE_INLINE PlanarBodies(const ContactConstraintWide& m, const SolverBody* bodies) {
        load_planar(a, bodies, m.a);
        if constexpr (kPair != PairKind::static_) load_planar(b, bodies, m.b);
        nx = load(m.normal[0]);
        ny = load(m.normal[1]);
        tx = load(m.tangent[0]);
        ty = load(m.tangent[1]);
        ax = load(m.arm_a[0]);
        ay = load(m.arm_a[1]);
        bx = load(m.arm_b[0]);
        by = load(m.arm_b[1]);
        z_sign = nx * ty - ny * tx;
    }
    JOSTLE_INLINE void relative(Wide vax, Wide vay, Wide wa, Wide vbx, Wide vby, Wide wb, Wide& ux,
                                Wide& uy, Wide& w) const {
        ux = -(vax - wa * ay);
        uy = -(vay + wa * ax);
        w = -wa;
        if constexpr (kPair != PairKind::static_) {
            ux += vbx - wb * by;
            uy += vby + wb * bx;
            w += wb;
        }
    }
    // Applies impulse (px, py) at the centre and l about z: negative to a, positive to b.
    JOSTLE_INLINE void apply(Wide px, Wide py, Wide l) {
        a.vx -= px * a.state[6];
        a.vy -= py * a.state[6];
        a.w -= (ax * py - ay * px + l) * a.state[7];
        if constexpr (kPair == PairKind::dynamic) {
            b.vx += px * b.state[6];
            b.vy += py * b.state[6];
            b.w += (bx * py - by * px + l) * b.state[7];
        }
    }
    JOSTLE_INLINE void store() {
        store_planar(a);
        if constexpr (kPair == PairKind::dynamic) store_planar(b);
    }
};

template <PairKind kPair>
void warm_start_planar(ContactConstraintWide& m, const RollingWide* rolling, SolverBody* bodies) {
    PlanarBodies<kPair> pair(m, bodies);
    const Wide l0 = load(m.lambda[0]), l1 = load(m.lambda[1]), f = load(m.friction[0]);
    const Wide total = l0 + l1;
    // A point at x along the tangent: its moment about the centre is x (t x n) lambda.
    Wide l = -(load(m.x[0]) * l0 + load(m.x[1]) * l1) * pair.z_sign;
    if (rolling != nullptr) l += load<RollingWide>(rolling->roll[1]) * pair.z_sign;
    pair.apply(pair.nx * total + pair.tx * f, pair.ny * total + pair.ty * f, l);
    pair.store();
}

template <PairKind kPair, bool kRelax, bool kLast>
PairReport solve_planar(ContactConstraintWide& m, ContactConstraintWideMeta& meta,
                        RollingWide* rolling, SolverBody* bodies, const ContactSettings& set) {
    PlanarBodies<kPair> pair(m, bodies);
    const Wide zero = splat(0);
    // The motion of the bodies since the start of the step.
    const auto motion = [](const PlanarSide& s, Wide& dx, Wide& dy, Wide& dr) {
        Wide t[8];
        load_rows(s.rows, 8, t);
        dx = t[0];
        dy = t[1];
        dr = t[5];
    };
    Wide dax, day, dar, dbx = zero, dby = zero, dbr = zero, mx, my, rotated;
    motion(pair.a, dax, day, dar);
    if constexpr (kPair != PairKind::static_) motion(pair.b, dbx, dby, dbr);
    pair.relative(dax, day, dar, dbx, dby, dbr, mx, my, rotated);
    // The arm of a kinematic body in the middle of the sub-step, as in PairBodies::follow().
    const Wide bx = pair.bx + (dax - dbx), by = pair.by + (day - dby);
    if constexpr (kPair == PairKind::kinematic) {
        const Wide ahead = splat(kRelax ? -0.5f * set.h : 0.5f * set.h);
        pair.bx = fma(pair.a.vx - pair.b.vx, ahead, bx);
        pair.by = fma(pair.a.vy - pair.b.vy, ahead, by);
    }
    Wide ux, uy, w;
    const auto velocities = [&] {
        if constexpr (kPair == PairKind::static_)
            pair.relative(pair.a.vx, pair.a.vy, pair.a.w, zero, zero, zero, ux, uy, w);
        else
            pair.relative(pair.a.vx, pair.a.vy, pair.a.w, pair.b.vx, pair.b.vy, pair.b.w, ux, uy,
                          w);
    };
    const auto pressing = [&] { return load(m.lambda[0]) + load(m.lambda[1]); };
    // Solves friction and rolling resistance of some lanes and returns the lanes that slip.
    const auto solve_friction = [&](WideMask of) {
        velocities();
        const Wide limit = load(m.mu) * pressing();
        Wide u1 = pair.tx * ux + pair.ty * uy;
        if (rolling != nullptr) u1 += load<RollingWide>(rolling->surface[0]);
        const Wide old = load(m.friction[0]), unclamped = old - load(m.friction_mass[0]) * u1;
        const Wide now = select(of, max(-limit, min(unclamped, limit)), old);
        store(m.friction[0], now);
        pair.apply(pair.tx * (now - old), pair.ty * (now - old), zero);
        if (rolling != nullptr) {
            // Rolling resistance: about z.
            velocities();
            const Wide k = load(m.g[5]), hold = load<RollingWide>(rolling->rolling) * pressing();
            const Wide old_roll = load<RollingWide>(rolling->roll[1]);
            const Wide new_roll = select(
                of, max(-hold, min(old_roll - pair.z_sign * w / max(k, splat(1e-30f)), hold)),
                old_roll);
            store<RollingWide>(rolling->roll[1], new_roll);
            pair.apply(zero, zero, pair.z_sign * (new_roll - old_roll));
        }
        return absolute(unclamped) > limit;
    };
    // Before the normals and, where the limit was not the load, after them, as in solve_block().
    WideMask slips = zero > zero;
    const Wide pressed = pressing();
    if constexpr (kRelax) slips = solve_friction(zero >= zero);

    const Wide s0 = pair.nx * mx + pair.ny * my, s2 = pair.z_sign * rotated;

    velocities();
    const Wide u0 = pair.nx * ux + pair.ny * uy, u2 = pair.z_sign * w;
    const Wide x0 = load(m.x[0]), x1 = load(m.x[1]);
    const Wide gap0 = load(m.gap[0]) + s0 - x0 * s2, gap1 = load(m.gap[1]) + s0 - x1 * s2;
    const Wide g00 = load(m.g[0]), g02 = load(m.g[2]), g22 = load(m.g[5]);
    const auto k_of = [&](Wide p, Wide q) { return g00 - (p + q) * g02 + p * q * g22; };
    const Wide k00 = k_of(x0, x0), k01 = k_of(x0, x1), k11 = k_of(x1, x1);
    const Wide old0 = load(m.lambda[0]), old1 = load(m.lambda[1]);

    Wide slop = splat(set.slop), push_speed = splat(set.push_speed);
    if (!kRelax && any_unusual(meta)) {
        const WideScale scale = scale_of(meta, set.gravity_ratio);
        slop = slop * scale.length;
        push_speed = push_speed * scale.speed;
    }
    // The target impulse of each point, with softness added to its effective mass.
    const auto preference = [&](Wide gap, Wide old, Wide mean_impulse, Wide k, Wide vn,
                                Wide& target, Wide& soft_mass) {
        const WideMask apart = gap > zero;
        if constexpr (kRelax) {
            const Wide bias = select(apart, gap * splat(set.inverse_h), zero);
            target = vn + bias;
            soft_mass = k;
        } else {
            const Wide push = max((gap + slop) * splat(set.bias_rate), -push_speed);
            const Wide bias = select(apart, gap * splat(set.inverse_h), push);
            // now = old - scale (vn + bias) / k - impulse_scale (old - mean_impulse), expressed
            // with a larger mass.
            const Wide scale = select(apart, splat(1), splat(set.mass_scale));
            const Wide impulse_scale = select(apart, zero, splat(set.impulse_scale));
            soft_mass = k / scale;
            target = vn + bias + soft_mass * impulse_scale * (old - mean_impulse);
        }
    };
    Wide t0, t1, m00, m11;
    preference(gap0, old0, load(m.mean_impulse[0]), k00, u0 - x0 * u2, t0, m00);
    preference(gap1, old1, load(m.mean_impulse[1]), k11, u0 - x1 * u2, t1, m11);
    // K (new - old) + t = 0 where new > 0: both points, one of them, the other, or none.
    const Wide b0 = t0 - m00 * old0 - k01 * old1, b1 = t1 - k01 * old0 - m11 * old1;
    const Wide det = m00 * m11 - k01 * k01;
    const WideMask regular = det > splat(1e-5f) * m00 * m11;
    const Wide both0 = (k01 * b1 - m11 * b0) / det, both1 = (k01 * b0 - m00 * b1) / det;
    const Wide only0 = max(-b0 / m00, zero), only1 = max(-b1 / m11, zero);
    const WideMask both = regular & (both0 >= zero) & (both1 >= zero);
    // A single point is a solution if the other point then separates.
    const WideMask first = (only0 > zero) & (k01 * only0 + b1 >= zero);
    const WideMask second = (only1 > zero) & (k01 * only1 + b0 >= zero);
    Wide new0 = select(both, both0, select(first, only0, zero));
    Wide new1 = select(both, both1, select(first, zero, select(second, only1, zero)));
    // Nearly singular: the two points coincide and share the impulse.
    const WideMask shared = ~regular & ~first & ~second;
    new0 = select(shared, only0 * splat(0.5f), new0);
    new1 = select(shared, only1 * splat(0.5f), new1);
    store(m.lambda[0], new0);
    store(m.lambda[1], new1);
    const Wide d0 = new0 - old0, d1 = new1 - old1, total = d0 + d1;
    pair.apply(pair.nx * total, pair.ny * total, -(x0 * d0 + x1 * d1) * pair.z_sign);
    if constexpr (kRelax) {
        WideMask again = slips & (pressing() > pressed);
        if constexpr (kPair != PairKind::dynamic) {
            const Wide limit = splat(1 + limit_tolerance) * (load(m.mu) * pressing());
            again = again |
                    (is_pushed_out(min(gap0, gap1), set) & (absolute(load(m.friction[0])) > limit));
        }
        if (lane_bits(again) != 0) solve_friction(again);
    }
    pair.store();

    PairReport report;
    if constexpr (kLast && kPair == PairKind::kinematic) {
        store(m.arm_b[0], bx);
        store(m.arm_b[1], by);
    }
    if constexpr (kLast) {
        store(m.gap[0], gap0);
        store(m.gap[1], gap1);
        const Wide sum = new0 + new1;
        Wide points = select(gap0 < splat(0.5f * no_point), splat(1), zero) +
                      select(gap1 < splat(0.5f * no_point), splat(1), zero);
        const Wide mean = sum / max(points, splat(1));
        const Wide lambda[2] = {new0, new1};
        for (int i = 0; i < 2; i++) {
            const Wide mean_impulse = load(m.mean_impulse[i]);
            const Wide target_mean = mean + splat(set.per_point) * (lambda[i] - mean);
            store(m.mean_impulse[i],
                  mean_impulse + splat(set.mean_rate) * (target_mean - mean_impulse));
        }
        // As in contact_kernel.h, a rotation about its only point also ages the manifold.
        const WideScale scale =
            any_unusual(meta) ? scale_of(meta, set.gravity_ratio) : WideScale{splat(1), splat(1)};
        const Wide lever = max(load(m.friction_radius), splat(0.3f) * scale.length);
        const Wide displacement = root(mx * mx + my * my) + lever * root(rotated * rotated) +
                                  splat(0.3f) * scale.length * root(dar * dar);
        const Wide age = load<ContactConstraintWideMeta>(meta.moved) + displacement;
        store<ContactConstraintWideMeta>(meta.moved, age);
        report.needs_rebuild = lane_bits(age > splat(set.rebuild_drift) * scale.length) |
                               lane_bits(displacement > splat(set.rebuild_motion) * scale.speed);
        report.touching = lane_bits(sum > zero) |
                          (touching_lanes(meta) &
                           lane_bits(min(gap0, gap1) < splat(set.touch_gap) * scale.length));
    }
    return report;
}

}  // namespace jostle::physics::JOSTLE_ISA
