// SPDX-License-Identifier: MIT
//
// The passes over one block of eight manifolds or, with sixteen lanes, over two consecutive blocks.
// Templates make each combination of second body, inertia and pass branch-free code. Lane k of
// every value is manifold k; no operation crosses lanes. The bodies of a block are distinct (and
// within a colour, too), so they are loaded, changed and stored independently of other blocks.
#pragma once

#include "physics/src/constraint_graph/constraint_graph.h"
#include "physics/src/constraint_graph/solver_body.h"
#include "physics/src/constraints/contact_settings.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/math/wide.h"

namespace jostle::physics::JOSTLE_ISA {

// The mass data that the bodies of a block need. Determines which data is loaded.
enum class Inertia : unsigned char {
    isotropic,  // one scalar each for mass and inertia
    full,       // an inertia matrix
    locked,     // an inertia matrix, and a mass per axis
};

// A row of a per-block record. Record is the type that contains the row, usually
// ContactConstraintWide.
#if defined(JOSTLE_TWO_BLOCKS)
template <class Record = ContactConstraintWide>
JOSTLE_INLINE Wide load(const float* row) {
    return load_two<sizeof(Record) / sizeof(float)>(row);
}
template <class Record = ContactConstraintWide>
JOSTLE_INLINE void store(float* row, Wide w) {
    store_two<sizeof(Record) / sizeof(float)>(row, w);
}
#else
template <class Record>
JOSTLE_INLINE Wide load(const float* row) {
    return load(row);
}
template <class Record>
JOSTLE_INLINE void store(float* row, Wide w) {
    store(row, w);
}
#endif

struct WideSide {
    const float* rows[lane_count];
    Wide state[8];    // row 0
    Wide inertia[8];  // row 2
    Wide3 v, w;
    Wide free_z;  // locked only: 1 if the body may move along z; x and y are in row 2
};

JOSTLE_INLINE Wide3 load3(const float (*rows)[8]) {
    return {load(rows[0]), load(rows[1]), load(rows[2])};
}

template <Inertia kInertia>
JOSTLE_INLINE void load_inertia(WideSide& s) {
    if constexpr (kInertia == Inertia::isotropic) return;
    load_rows(s.rows, 16, s.inertia);
    if constexpr (kInertia == Inertia::locked)
        for (int k = 0; k < lane_count; k++) s.free_z[k] = s.rows[k][8 + 6];
}

// Index of the body of a lane, relative to the first one of the block. Lanes from 8 belong to the
// next block.
constexpr int side_index(int lane) {
    constexpr auto next = static_cast<int>(sizeof(ContactConstraintWide) / sizeof(std::int32_t));
    return lane < 8 ? lane : next + lane - 8;
}

JOSTLE_INLINE void load_side(WideSide& s, const SolverBody* bodies, const std::int32_t* index) {
    for (int k = 0; k < lane_count; k++) s.rows[k] = bodies[index[side_index(k)]].v;
    load_rows(s.rows, 0, s.state);
    s.v = {s.state[0], s.state[1], s.state[2]};
    s.w = {s.state[3], s.state[4], s.state[5]};
}

JOSTLE_INLINE void load_motion(const WideSide& s, Wide3& dp, Wide3& dr) {
    Wide t[8];
    load_rows(s.rows, 8, t);
    dp = {t[0], t[1], t[2]};
    dr = {t[3], t[4], t[5]};
}

JOSTLE_INLINE void store_side(WideSide& s) {
    s.state[0] = s.v.x, s.state[1] = s.v.y, s.state[2] = s.v.z;
    s.state[3] = s.w.x, s.state[4] = s.w.y, s.state[5] = s.w.z;
    store_rows(const_cast<float* const*>(s.rows), s.state);
}

// Change of spin from the angular impulse l.
template <Inertia kInertia>
JOSTLE_INLINE Wide3 spin(const WideSide& s, Wide3 l) {
    if constexpr (kInertia == Inertia::isotropic) return l * s.state[7];
    const Wide* i = s.inertia;
    return {dot({i[0], i[3], i[4]}, l), dot({i[3], i[1], i[5]}, l), dot({i[4], i[5], i[2]}, l)};
}

// Velocity after the impulse p.
template <Inertia kInertia>
JOSTLE_INLINE Wide3 pushed(const WideSide& s, Wide3 p) {
    if constexpr (kInertia == Inertia::locked)
        p = {p.x * s.inertia[6], p.y * s.inertia[7], p.z * s.free_z};
    return fma(p, s.state[6], s.v);
}

// Relative motion of the bodies of a block since the start of the step: of b relative to a, at the
// centre of the manifold.
struct PairMotion {
    Wide3 moved, rotated;
    Wide3 rotated_a;  // of a alone
};

// The two bodies of a block and the geometry of their manifolds.
template <PairKind kPair, Inertia kInertia>
struct PairBodies {
    WideSide a, b;
    Wide3 n, t1, t2, arm_a, arm_b;
    Wide3 arm_now;  // of a kinematic body b at the current poses, set by follow()

    JOSTLE_INLINE PairBodies(const ContactConstraintWide& m, const SolverBody* bodies) {
        load_side(a, bodies, m.a);
        load_inertia<kInertia>(a);
        if constexpr (kPair != PairKind::static_) load_side(b, bodies, m.b);
        if constexpr (kPair == PairKind::dynamic) load_inertia<kInertia>(b);
        n = load3(m.normal);
        t1 = load3(m.tangent);
        t2 = cross(n, t1);
        arm_a = load3(m.arm_a);
        arm_b = load3(m.arm_b);
    }

    // Velocity (or motion) of b relative to a at the centre of the manifold.
    JOSTLE_INLINE Wide3 relative(Wide3 va, Wide3 wa, Wide3 vb, Wide3 wb) const {
        if constexpr (kPair == PairKind::static_) return -(va + cross(wa, arm_a));
        return (vb + cross(wb, arm_b)) - (va + cross(wa, arm_a));
    }
    JOSTLE_INLINE Wide3 relative_velocity() const { return relative(a.v, a.w, b.v, b.w); }
    JOSTLE_INLINE Wide3 relative_spin() const {
        if constexpr (kPair == PairKind::static_) return -a.w;
        return b.w - a.w;
    }

    // Moves the arms to the poses of the current sub-step and to a common world point. Impulses on
    // both bodies then act along the same line, and angular momentum is conserved.
    //
    // The surface of a kinematic body moves with a point that depends on where body a is. It is
    // taken in the middle of a sub-step, `ahead` seconds after the current poses: the velocity at
    // either end of a sub-step would carry a body on a carousel outwards or inwards by w^2 r h / 2
    // per second.
    JOSTLE_INLINE PairMotion follow(const ContactConstraintWide& m, float ahead) {
        Wide3 dp_a, dr_a, dp_b{}, dr_b{};
        load_motion(a, dp_a, dr_a);
        if constexpr (kPair != PairKind::static_) load_motion(b, dp_b, dr_b);
        const Wide3 moved = relative(dp_a, dr_a, dp_b, dr_b);
        if constexpr (kPair == PairKind::static_) return {moved, -dr_a, dr_a};
        if constexpr (kPair == PairKind::kinematic) {
            arm_now = arm_b + (dp_a - dp_b);
            arm_b = fma(a.v - b.v, splat(ahead), arm_now);
        }
        if constexpr (kPair == PairKind::dynamic) {
            // Skipped for bodies whose relative motion exceeds the length of the arms.
            const Wide3 displacement = dp_b - dp_a;
            const WideMask small =
                dot(displacement, displacement) < splat(tuning::arm_follows) * dot(arm_a, arm_a);
            const Wide3 apart = displacement * select(small, splat(1), splat(0));
            const Wide3 step_a = apart * load(m.anchor_blend);
            arm_a = arm_a + step_a;
            arm_b = arm_b + (step_a - apart);
        }
        return {moved, dr_b - dr_a, dr_a};
    }

    // Applies impulse p at the centre: -p to a and p to b.
    JOSTLE_INLINE void apply(Wide3 p) {
        a.v = pushed<kInertia>(a, -p);
        a.w = a.w - spin<kInertia>(a, cross(arm_a, p));
        if constexpr (kPair == PairKind::dynamic) {
            b.v = pushed<kInertia>(b, p);
            b.w = b.w + spin<kInertia>(b, cross(arm_b, p));
        }
    }
    // Applies impulse p and angular impulse l.
    JOSTLE_INLINE void apply(Wide3 p, Wide3 l) {
        a.v = pushed<kInertia>(a, -p);
        a.w = a.w - spin<kInertia>(a, cross(arm_a, p) + l);
        if constexpr (kPair == PairKind::dynamic) {
            b.v = pushed<kInertia>(b, p);
            b.w = b.w + spin<kInertia>(b, cross(arm_b, p) + l);
        }
    }
    JOSTLE_INLINE void store() {
        store_side(a);
        if constexpr (kPair == PairKind::dynamic) store_side(b);
    }
};

// Sum of the point impulses and their two moments.
struct WideImpulse {
    Wide total = splat(0), m1 = splat(0), m2 = splat(0);

    JOSTLE_INLINE void add(Wide x, Wide y, Wide impulse) {
        total += impulse;
        m1 = fma(y, impulse, m1);
        m2 = fnma(x, impulse, m2);
    }
};

// u0 + y u1 - x u2: the normal component at a point, from the motion of the centre and its two
// tilts.
JOSTLE_INLINE Wide at_point(Wide x, Wide y, Wide u0, Wide u1, Wide u2) {
    return fnma(x, u2, fma(y, u1, u0));
}

// G (1, y, -x): response of (approach, tilt 1, tilt 2) to a unit impulse at a point.
struct PointResponse {
    Wide r0, r1, r2, k;
};
JOSTLE_INLINE PointResponse response_of(const ContactConstraintWide& m, Wide x, Wide y) {
    const Wide g01 = load(m.g[1]), g02 = load(m.g[2]), g12 = load(m.g[4]);
    const Wide r0 = at_point(x, y, load(m.g[0]), g01, g02),
               r1 = at_point(x, y, g01, load(m.g[3]), g12),
               r2 = at_point(x, y, g02, g12, load(m.g[5]));
    return {r0, r1, r2, at_point(x, y, r0, r1, r2)};
}

template <PairKind kPair, Inertia kInertia>
void warm_start_block(ContactConstraintWide& m, const RollingWide* rolling, SolverBody* bodies) {
    PairBodies<kPair, kInertia> pair(m, bodies);
    WideImpulse sum;
    for (int i = 0; i < 4; i++) sum.add(load(m.x[i]), load(m.y[i]), load(m.lambda[i]));
    if (rolling != nullptr) {
        sum.m1 += load<RollingWide>(rolling->roll[0]);
        sum.m2 += load<RollingWide>(rolling->roll[1]);
    }
    pair.apply(
        fma(pair.t2, load(m.friction[1]), fma(pair.t1, load(m.friction[0]), pair.n * sum.total)),
        fma(pair.n, load(m.torsion), fma(pair.t2, sum.m2, pair.t1 * sum.m1)));
    pair.store();
}

// Rolling resistance: an angular impulse about the tangents, limited by the material in proportion
// to the normal impulse.
template <PairKind kPair, Inertia kInertia>
JOSTLE_INLINE void solve_rolling(ContactConstraintWide& m, RollingWide& rolling,
                                 Wide normal_impulse, PairBodies<kPair, kInertia>& pair,
                                 WideMask of) {
    const Wide3 w = pair.relative_spin();
    const Wide w1 = dot(pair.t1, w), w2 = dot(pair.t2, w);
    const Wide k00 = load(m.g[3]), k01 = load(m.g[4]), k11 = load(m.g[5]);
    // For bodies that cannot rotate the matrix is singular.
    const Wide det = max(k00 * k11 - k01 * k01, splat(1e-30f));
    const Wide old1 = load<RollingWide>(rolling.roll[0]), old2 = load<RollingWide>(rolling.roll[1]);
    Wide r1 = old1 - (k11 * w1 - k01 * w2) / det;
    Wide r2 = old2 - (k00 * w2 - k01 * w1) / det;
    const Wide limit = load<RollingWide>(rolling.rolling) * normal_impulse,
               length2 = r1 * r1 + r2 * r2;
    const Wide scale =
        select(length2 > limit * limit, limit / root(max(length2, splat(1e-30f))), splat(1));
    r1 = select(of, r1 * scale, old1);
    r2 = select(of, r2 * scale, old2);
    store<RollingWide>(rolling.roll[0], r1);
    store<RollingWide>(rolling.roll[1], r2);
    const Wide zero = splat(0);
    pair.apply({zero, zero, zero}, fma(pair.t2, r2 - old2, pair.t1 * (r1 - old1)));
}

struct WidePair {
    Wide x, y;
};

// With three iterations the direction of friction is right to 1e-3 rad for masses that differ by a
// factor of 1000 between the tangents, and to 1e-6 rad for a factor of 4.
inline constexpr int sliding_iterations = 4;

// Friction impulse of a sliding contact, from the impulse (f1, f2) that would stop it, which
// exceeds the limit, and the effective mass M = (m00 m01; m01 m11) along the two tangents. Friction
// opposes the sliding that remains (maximum dissipation): M^-1 (f - f_stick) = -s f with |f| at the
// limit and s > 0, so f = (1 + s M)^-1 f_stick. Shortening f_stick instead would deflect every body
// whose response to friction depends on the direction. 1 / |f| is concave and nearly linear in s:
// Newton's method from below converges monotonically (the trust-region step of Hebden, 1973, and
// More, 1978).
JOSTLE_INLINE WidePair sliding_friction(Wide f1, Wide f2, Wide m00, Wide m01, Wide m11,
                                        Wide limit) {
    const Wide one = splat(1), least = splat(1e-30f);
    const Wide half_trace = splat(0.5f) * (m00 + m11), half_difference = splat(0.5f) * (m00 - m11);
    const Wide stiffest = half_trace + root(fma(m01, m01, half_difference * half_difference));
    const Wide length = root(fma(f2, f2, f1 * f1));
    // Below this fraction the direction of f no longer depends on the limit.
    const Wide bounded = max(limit, length * splat(1e-5f));
    Wide s = max((length / bounded - one) / max(stiffest, least), splat(0));
    Wide x = f1, y = f2, size = length;
    JOSTLE_UNROLL
    for (int i = 0; i < sliding_iterations; i++) {
        const Wide a00 = fma(s, m00, one), a01 = s * m01, a11 = fma(s, m11, one);
        const Wide scale = one / (a00 * a11 - a01 * a01);
        x = (a11 * f1 - a01 * f2) * scale;
        y = (a00 * f2 - a01 * f1) * scale;
        size = root(fma(y, y, x * x));
        if (i + 1 == sliding_iterations) break;
        // x, y and their derivative -(1 + s M)^-1 M f.
        const Wide p = fma(m01, y, m00 * x), q = fma(m11, y, m01 * x);
        const Wide slope = fma(y, a00 * q - a01 * p, x * (a11 * p - a01 * q)) * scale;
        s += (size - bounded) / bounded * ((size * size) / max(slope, least));
    }
    const Wide scale = limit / max(size, least);
    return {x * scale, y * scale};
}

// Largest torsional friction impulse at this limit of friction.
JOSTLE_INLINE Wide torsion_limit(const ContactConstraintWide& m, const RollingWide* rolling,
                                 Wide limit, Wide normal_impulse) {
    const Wide at_points = limit * load(m.friction_radius);
    if (rolling == nullptr) return at_points;
    return max(at_points, load<RollingWide>(rolling->torsional_friction) * normal_impulse);
}

// Solves the friction cone at the centre, then torsional friction, in the lanes of `of`. The limit
// uses the most recent normal impulse. Returns the lanes at the limit.
template <PairKind kPair, Inertia kInertia>
JOSTLE_INLINE WideMask solve_friction(ContactConstraintWide& m, RollingWide* rolling,
                                      PairBodies<kPair, kInertia>& pair, WideMask of) {
    const Wide3 u = pair.relative_velocity(), w = pair.relative_spin();
    const Wide normal_impulse =
        (load(m.lambda[0]) + load(m.lambda[1])) + (load(m.lambda[2]) + load(m.lambda[3]));
    const Wide limit = load(m.mu) * normal_impulse;
    Wide u1 = dot(pair.t1, u), u2 = dot(pair.t2, u);
    if (rolling != nullptr) {
        u1 += load<RollingWide>(rolling->surface[0]);
        u2 += load<RollingWide>(rolling->surface[1]);
    }
    const Wide m00 = load(m.friction_mass[0]), m01 = load(m.friction_mass[1]),
               m11 = load(m.friction_mass[2]);
    const Wide old1 = load(m.friction[0]), old2 = load(m.friction[1]),
               old_torsion = load(m.torsion);
    Wide f1 = old1 - fma(m01, u2, m00 * u1);
    Wide f2 = old2 - fma(m11, u2, m01 * u1);
    // Lanes that slip or have a limit of zero. Usually no lane slips.
    const WideMask over = fma(f2, f2, f1 * f1) > limit * limit;
    if (lane_bits(over) != 0) {
        const WidePair sliding = sliding_friction(f1, f2, m00, m01, m11, limit);
        f1 = select(over, sliding.x, f1);
        f2 = select(over, sliding.y, f2);
    }
    f1 = select(of, f1, old1);
    f2 = select(of, f2, old2);
    const Wide unclamped = fnma(load(m.torsion_mass), dot(pair.n, w), old_torsion);
    const Wide most = torsion_limit(m, rolling, limit, normal_impulse);
    const Wide torsion = select(of, max(-most, min(unclamped, most)), old_torsion);
    store(m.friction[0], f1);
    store(m.friction[1], f2);
    store(m.torsion, torsion);
    pair.apply(fma(pair.t2, f2 - old2, pair.t1 * (f1 - old1)), pair.n * (torsion - old_torsion));
    if (rolling != nullptr) solve_rolling(m, *rolling, normal_impulse, pair, of);
    return over | (absolute(unclamped) > most);
}

// A contact that separates at more than `speed` without normal impulse has no friction: the
// warm-started friction is removed before it rotates the bodies further. A contact that sinks
// towards its slop also has little normal impulse, but retains its friction.
template <PairKind kPair, Inertia kInertia>
JOSTLE_INLINE void drop_friction_of_parted(ContactConstraintWide& m, Wide parting, Wide speed,
                                           PairBodies<kPair, kInertia>& pair) {
    const Wide zero = splat(0);
    const Wide normal_impulse =
        (load(m.lambda[0]) + load(m.lambda[1])) + (load(m.lambda[2]) + load(m.lambda[3]));
    const Wide f1 = load(m.friction[0]), f2 = load(m.friction[1]), torsion = load(m.torsion);
    const WideMask parted = ~(normal_impulse > zero) & (parting > speed) &
                            ((absolute(f1) + absolute(f2)) + absolute(torsion) > zero);
    if (lane_bits(parted) == 0) return;  // usual case
    pair.apply(fma(pair.t2, select(parted, -f2, zero), pair.t1 * select(parted, -f1, zero)),
               pair.n * select(parted, -torsion, zero));
    store(m.friction[0], select(parted, zero, f1));
    store(m.friction[1], select(parted, zero, f2));
    store(m.torsion, select(parted, zero, torsion));
}

// Fraction by which friction with a body that contacts do not move may exceed the limit of the
// latest normal impulses before it is solved again. In piles the impulses of the two passes differ
// by less. The end of a push-out then has up to a quarter too much friction: 0.7 % of the way at 4
// m/s and 60 Hz. Between two dynamic bodies the larger limit remains, because it keeps bodies that
// are pushed out of each other from tilting: without it, five overlapping boxes of 2 mm topple.
// Manifolds of one point keep it, too: a limp figure would rock for ever.
inline constexpr float limit_tolerance = 0.25f;
// Whether the soft pass pushes a point with this gap out faster than a quarter of what gravity adds
// in a sub-step. At rest it does not.
JOSTLE_INLINE WideMask is_pushed_out(Wide gap, const ContactSettings& set) {
    const float fall =
        0.25f * static_cast<float>(tuning::usual_gravity) * set.gravity_ratio * set.h;
    return (gap + splat(set.slop)) * splat(set.bias_rate) < splat(-fall);
}

// Whether the bodies move faster along their contact than bodies that may count as resting.
template <PairKind kPair, Inertia kInertia>
JOSTLE_INLINE WideMask is_sliding(const PairBodies<kPair, kInertia>& pair) {
    const Wide3 u = pair.relative_velocity();
    const Wide u1 = dot(pair.t1, u), u2 = dot(pair.t2, u);
    constexpr auto least = static_cast<float>(tuning::drift_speed);
    return fma(u2, u2, u1 * u1) > splat(least * least);
}

struct PairReport {
    unsigned needs_rebuild = 0, touching = 0;  // bit masks of lanes
};

JOSTLE_INLINE unsigned touching_lanes(const ContactConstraintWideMeta& meta) {
    if constexpr (lane_count == 8) return meta.bits(LaneFlag::touching);
    return meta.bits(LaneFlag::touching) |
           static_cast<unsigned>((&meta)[1].bits(LaneFlag::touching)) << 8;
}

// Scale factors of the default lengths and speeds for each lane (foundation/size_scale.h).
struct WideScale {
    Wide length, speed;
};
JOSTLE_INLINE bool any_unusual(const ContactConstraintWideMeta& meta) {
    if constexpr (lane_count == 8) return meta.bits(LaneFlag::unusual) != 0;
    return (meta.bits(LaneFlag::unusual) | (&meta)[1].bits(LaneFlag::unusual)) != 0;
}
inline WideScale scale_of(const ContactConstraintWideMeta& meta, float gravity_ratio) {
    Wide size;
    for (int k = 0; k < lane_count; k++) {
        const std::uint32_t upper = k < 8 ? meta.size[k] : (&meta)[1].size[k - 8];
        size[k] = __builtin_bit_cast(float, upper << 16);
    }
    const auto scale = [](Wide s) {
        return min(s * splat(static_cast<float>(1 / tuning::min_usual_size)),
                   max(s * splat(static_cast<float>(1 / tuning::max_usual_size)), splat(1)));
    };
    const WideMask some = size > splat(0);
    return {select(some, scale(size), splat(1)),
            select(some, root(scale(size * splat(gravity_ratio))), splat(1))};
}

// kRelax: rigid, without push-out, with friction. kLast: the relaxing pass that ends the step. It
// also moves the gaps and the arms of kinematic bodies to the new poses and reports lanes that
// moved too far to be reused and lanes with normal impulse. kPoints: 4, or 1 for blocks of
// single-point manifolds, whose point is at the centre.
template <int kPoints, PairKind kPair, Inertia kInertia, bool kRelax, bool kLast>
PairReport solve_block(ContactConstraintWide& m, ContactConstraintWideMeta& meta,
                       RollingWide* rolling, SolverBody* bodies, const ContactSettings& set,
                       int sweeps) {
    PairBodies<kPair, kInertia> pair(m, bodies);
    // The relaxing pass follows the advance of the bodies.
    const PairMotion motion = pair.follow(m, kRelax ? -0.5f * set.h : 0.5f * set.h);
    const Wide zero = splat(0);
    // Friction comes before the normals, with the limit of the soft pass. The normals are solved
    // last, so they hold exactly.
    WideMask slips = zero > zero;
    Wide pressed = zero;
    WideMask slides = zero > zero;
    if constexpr (kRelax) {
        if constexpr (kPoints > 1 && kPair != PairKind::dynamic) slides = is_sliding(pair);
        pressed = (load(m.lambda[0]) + load(m.lambda[1])) + (load(m.lambda[2]) + load(m.lambda[3]));
        slips = solve_friction<kPair, kInertia>(m, rolling, pair, zero >= zero);
    }

    const Wide s0 = dot(pair.n, motion.moved), s1 = dot(pair.t1, motion.rotated),
               s2 = dot(pair.t2, motion.rotated);
    const Wide3 u = pair.relative_velocity(), w = pair.relative_spin();
    const Wide u0 = dot(pair.n, u), u1 = dot(pair.t1, w), u2 = dot(pair.t2, w);
    // A sweep gives each point its unclamped impulse and subtracts its effect from the impulses of
    // the other points: lambda_i = max(unclamped_i, 0), unclamped_j -= coupling_ji (change of
    // lambda_i). The point's own unclamped impulse does not change: the leak of a soft point and
    // its renewed demand cancel (contact_settings.cpp: mass_scale + impulse_scale = 1). The
    // dependency chain from one point to the next is a fused multiply-add, a maximum and a
    // difference.
    Wide x[kPoints], y[kPoints], gap[kPoints], lambda[kPoints], unclamped[kPoints], rate[kPoints],
        off_diagonal[kPoints][kPoints];
    PointResponse r[kPoints];
    Wide slop = splat(set.slop), push_speed = splat(set.push_speed);
    if (!kRelax && any_unusual(meta)) {
        const WideScale scale = scale_of(meta, set.gravity_ratio);
        slop = slop * scale.length;
        push_speed = push_speed * scale.speed;
    }
    JOSTLE_UNROLL
    for (int i = 0; i < kPoints; i++) {
        Wide vn = u0;
        if constexpr (kPoints == 1) {
            x[i] = y[i] = zero;
            gap[i] = load(m.gap[i]) + s0;
            r[i] = {load(m.g[0]), zero, zero, load(m.g[0])};
        } else {
            x[i] = load(m.x[i]), y[i] = load(m.y[i]);
            gap[i] = at_point(x[i], y[i], load(m.gap[i]) + s0, s1, s2);
            vn = at_point(x[i], y[i], u0, u1, u2);
            r[i] = response_of(m, x[i], y[i]);
        }
        lambda[i] = load(m.lambda[i]);
        // Separated points may close their gap within the sub-step, but not more. Overlapping
        // points are rigid, or pushed out softly.
        const WideMask apart = gap[i] > zero;
        const Wide meet = gap[i] * splat(set.inverse_h);
        if constexpr (kRelax) {
            rate[i] = splat(1) / r[i].k;
            unclamped[i] = fnma(rate[i], vn + select(apart, meet, zero), lambda[i]);
        } else {
            const Wide soft = max((gap[i] + slop) * splat(set.bias_rate), -push_speed);
            const Wide impulse_scale = select(apart, zero, splat(set.impulse_scale));
            rate[i] = (splat(1) - impulse_scale) / r[i].k;
            const Wide retained =
                fma(impulse_scale, load(m.mean_impulse[i]) - lambda[i], lambda[i]);
            unclamped[i] = fnma(rate[i], vn + select(apart, meet, soft), retained);
        }
    }
    // Usually no point is squeezed. A squeezed point gives up as much impulse as a soft one.
    const Wide deep2 = splat(set.squeezed * set.squeezed) * dot(pair.arm_a, pair.arm_a);
    const auto is_squeezed = [&](Wide g) { return (g < zero) & (g * g > deep2); };
    bool any_squeezed = false;
    if (kRelax && set.squeezed < float{tuning::never_squeezed}) {
        Wide deepest = zero;
        JOSTLE_UNROLL
        for (int i = 0; i < kPoints; i++) deepest = min(deepest, gap[i]);
        any_squeezed = lane_bits(deepest * deepest > deep2) != 0;
    }
    if (any_squeezed) {
        for (int i = 0; i < kPoints; i++) {
            const Wide vn = kPoints == 1 ? u0 : at_point(x[i], y[i], u0, u1, u2);
            const Wide leak = select(is_squeezed(gap[i]), splat(set.impulse_scale), zero);
            rate[i] = (splat(1) - leak) / r[i].k;
            const Wide meet = select(gap[i] > zero, gap[i] * splat(set.inverse_h), zero);
            unclamped[i] =
                fnma(rate[i], vn + meet, fma(leak, load(m.mean_impulse[i]) - lambda[i], lambda[i]));
        }
    }
    JOSTLE_UNROLL
    for (int i = 0; i < kPoints; i++) {
        JOSTLE_UNROLL
        for (int j = 0; j < i; j++) {
            const Wide response = at_point(x[i], y[i], r[j].r0, r[j].r1, r[j].r2);
            off_diagonal[i][j] = rate[i] * response;
            off_diagonal[j][i] = rate[j] * response;
        }
    }
    for (int sweep = 0; sweep < sweeps; sweep++) {
        JOSTLE_UNROLL
        for (int i = 0; i < kPoints; i++) {
            const Wide now = max(unclamped[i], zero);
            const Wide change = now - lambda[i];
            lambda[i] = now;
            JOSTLE_UNROLL
            for (int j = 0; j < kPoints; j++)
                if (j != i) unclamped[j] = fnma(off_diagonal[j][i], change, unclamped[j]);
        }
    }
    WideImpulse sum;
    Wide nearest = splat(no_point);
    JOSTLE_UNROLL
    for (int i = 0; i < kPoints; i++) {
        sum.add(x[i], y[i], lambda[i] - load(m.lambda[i]));
        store(m.lambda[i], lambda[i]);
        if constexpr (kLast) {
            store(m.gap[i], gap[i]);
            nearest = min(nearest, gap[i]);
        }
    }
    if constexpr (kPoints == 1)
        pair.apply(pair.n * sum.total);
    else
        pair.apply(pair.n * sum.total, fma(pair.t2, sum.m2, pair.t1 * sum.m1));
    // Friction is solved again where its limit was not the load. The soft pass yields less than the
    // load while a body sinks towards the slop, and more while it is pushed out of an overlap.
    if constexpr (kRelax) {
        const Wide presses =
            (load(m.lambda[0]) + load(m.lambda[1])) + (load(m.lambda[2]) + load(m.lambda[3]));
        WideMask again = slips & (presses > pressed);
        if constexpr (kPoints > 1 && kPair != PairKind::dynamic) {
            const Wide limit = splat(1 + limit_tolerance) * (load(m.mu) * presses);
            const Wide f1 = load(m.friction[0]), f2 = load(m.friction[1]);
            Wide deepest = zero;
            JOSTLE_UNROLL
            for (int i = 0; i < kPoints; i++) deepest = min(deepest, gap[i]);
            again =
                again | (slides & is_pushed_out(deepest, set) &
                         ((fma(f2, f2, f1 * f1) > limit * limit) |
                          (absolute(load(m.torsion)) > torsion_limit(m, rolling, limit, presses))));
        }
        if (lane_bits(again) != 0) solve_friction<kPair, kInertia>(m, rolling, pair, again);
    } else {
        drop_friction_of_parted<kPair, kInertia>(m, u0, slop * splat(set.inverse_h), pair);
    }
    pair.store();

    PairReport report;
    if constexpr (kLast && kPair == PairKind::kinematic) {
        store(m.arm_b[0], pair.arm_now.x);
        store(m.arm_b[1], pair.arm_now.y);
        store(m.arm_b[2], pair.arm_now.z);
    }
    if constexpr (kLast) {
        // Low islands remember the force of each point. Slender islands remember only the total
        // force of the manifold, not its moments, which would let stacks sway with growing
        // amplitude.
        Wide total = load(m.lambda[0]), points = splat(1);
        if constexpr (kPoints > 1) {
            total = (total + load(m.lambda[1])) + (load(m.lambda[2]) + load(m.lambda[3]));
            JOSTLE_UNROLL
            for (int i = 1; i < kPoints; i++)
                points += select(load(m.gap[i]) < splat(0.5f * no_point), splat(1), zero);
        }
        const Wide mean = total / points;
        JOSTLE_UNROLL
        for (int i = 0; i < kPoints; i++) {
            Wide mean_impulse = load(m.mean_impulse[i]);
            Wide target = mean + splat(set.per_point) * (load(m.lambda[i]) - mean);
            if (any_squeezed) {
                // A change of tier leaves a mean below zero where impulses are far above it
                // (impulse_scale.cpp). As it no longer rises, it would pull the bodies together.
                const WideMask held = is_squeezed(gap[i]);
                mean_impulse = select(held, max(mean_impulse, zero), mean_impulse);
                target = select(held, min(target, mean_impulse), target);
            }
            store(m.mean_impulse[i], mean_impulse + splat(set.mean_rate) * (target - mean_impulse));
        }
        // Slip, relative rotation and a third of the common rotation (which the normal does not
        // follow) age the manifold. So does a rotation about its only point, because a long body
        // may come down next to it.
        Wide drift = splat(set.rebuild_drift), touch_gap = splat(set.touch_gap),
             turn_radius = splat(1),
             max_displacement =
                 splat(kPoints == 1 ? set.single_rebuild_motion : set.rebuild_motion);
        if (any_unusual(meta)) {
            const WideScale scale = scale_of(meta, set.gravity_ratio);
            turn_radius = scale.length;
            drift = drift * scale.length;
            touch_gap = touch_gap * scale.length;
            max_displacement = max_displacement * scale.speed;
        }
        const Wide lever =
            max(load(m.friction_radius), splat(tuning::min_turn_radius) * turn_radius);
        const Wide displacement = root(dot(motion.moved, motion.moved)) +
                                  lever * root(dot(motion.rotated, motion.rotated)) +
                                  splat(tuning::common_turn_radius) * turn_radius *
                                      root(dot(motion.rotated_a, motion.rotated_a));
        const Wide age = load<ContactConstraintWideMeta>(meta.moved) + displacement;
        store<ContactConstraintWideMeta>(meta.moved, age);
        report.needs_rebuild = lane_bits(age > drift) | lane_bits(displacement > max_displacement);
        // Touching: the point has normal impulse; or it had, but gave it up because it was
        // squeezed; or it touched a step ago and has hardly separated.
        report.touching = lane_bits(total > zero) |
                          (any_squeezed ? lane_bits(is_squeezed(nearest) & (pressed > zero)) : 0) |
                          (touching_lanes(meta) & lane_bits(nearest < touch_gap));
    }
    return report;
}

// Records the approach speed of each point at the start of the step.
template <PairKind kPair, Inertia kInertia>
void begin_restitution(const ContactConstraintWide& m, RestitutionWide& restitution_wide,
                       const SolverBody* bodies) {
    const PairBodies<kPair, kInertia> pair(m, bodies);
    const Wide3 u = pair.relative_velocity(), w = pair.relative_spin();
    const Wide u0 = dot(pair.n, u), u1 = dot(pair.t1, w), u2 = dot(pair.t2, w);
    for (int i = 0; i < 4; i++) {
        store<RestitutionWide>(restitution_wide.approach[i],
                               at_point(load(m.x[i]), load(m.y[i]), u0, u1, u2));
        store<RestitutionWide>(restitution_wide.peak[i], splat(0));
    }
}

// After the first acceleration by h: adds the speed that free fall over the gap adds to the
// approach. Without it, a ball that reaches the floor late in a step would lose the speed that it
// gained in that step, up to g dt per bounce.
template <PairKind kPair, Inertia kInertia>
void predict_approach(const ContactConstraintWide& m, RestitutionWide& restitution_wide,
                      const SolverBody* bodies, const ContactSettings& set) {
    const PairBodies<kPair, kInertia> pair(m, bodies);
    const Wide3 u = pair.relative_velocity(), w = pair.relative_spin();
    const Wide u0 = dot(pair.n, u), u1 = dot(pair.t1, w), u2 = dot(pair.t2, w);
    for (int i = 0; i < 4; i++) {
        const Wide old_approach = load<RestitutionWide>(restitution_wide.approach[i]);
        const Wide now = at_point(load(m.x[i]), load(m.y[i]), u0, u1, u2);
        const Wide pull = (old_approach - now) * splat(set.inverse_h);
        const Wide gap = max(load(m.gap[i]), splat(0));
        const Wide square = old_approach * old_approach + (pull + pull) * gap;
        const WideMask nears = old_approach < splat(0);
        store<RestitutionWide>(restitution_wide.approach[i],
                               select(nears, -root(max(square, splat(0))), old_approach));
    }
}

// After each sub-step: a point with normal impulse in any sub-step was hit.
inline void record_peaks(const ContactConstraintWide& m, RestitutionWide& restitution_wide) {
    for (int i = 0; i < 4; i++)
        store<RestitutionWide>(
            restitution_wide.peak[i],
            max(load<RestitutionWide>(restitution_wide.peak[i]), load(m.lambda[i])));
}

// At the end of the step, points that were hit leave with restitution times their approach speed
// (Newton's hypothesis). A bouncing manifold carries no impulse into the next step, because it is
// about to separate.
template <PairKind kPair, Inertia kInertia>
void apply_restitution(ContactConstraintWide& m, const RestitutionWide& restitution_wide,
                       const float* restitution, SolverBody* bodies, const ContactSettings& set) {
    PairBodies<kPair, kInertia> pair(m, bodies);
    // The last pass has moved the arms of kinematic bodies to the poses at the end of the step.
    if constexpr (kPair == PairKind::dynamic) pair.follow(m, 0);
    const Wide3 u = pair.relative_velocity(), w = pair.relative_spin();
    Wide u0 = dot(pair.n, u), u1 = dot(pair.t1, w), u2 = dot(pair.t2, w);
    WideImpulse sum;
    const Wide zero = splat(0);
    Wide applied[4] = {zero, zero, zero, zero};
    Wide left_with = zero;
    // Several sweeps, because the points of a face share the bounce.
    for (int sweep = 0; sweep < 4; sweep++)
        for (int i = 0; i < 4; i++) {
            const Wide x = load(m.x[i]), y = load(m.y[i]);
            const PointResponse r = response_of(m, x, y);
            const Wide approach = load<RestitutionWide>(restitution_wide.approach[i]);
            const Wide vn = at_point(x, y, u0, u1, u2);
            const WideMask hit = (load<RestitutionWide>(restitution_wide.peak[i]) > zero) &
                                 (approach < splat(-set.restitution_speed)) &
                                 (load<ContactConstraintWideMeta>(restitution) > zero);
            const Wide unclamped = -load<ContactConstraintWideMeta>(restitution) * approach;
            const Wide now = max(applied[i] + (unclamped - vn) / r.k, zero);
            const Wide d = select(hit, now - applied[i], zero);
            applied[i] = applied[i] + d;
            left_with = max(left_with, applied[i]);
            u0 = fma(r.r0, d, u0);
            u1 = fma(r.r1, d, u1);
            u2 = fma(r.r2, d, u2);
            sum.add(x, y, d);
        }
    pair.apply(pair.n * sum.total, fma(pair.t2, sum.m2, pair.t1 * sum.m1));
    pair.store();
    const WideMask bounced = left_with > zero;
    for (auto& lambda : m.lambda) store(lambda, select(bounced, zero, load(lambda)));
    for (auto& friction : m.friction) store(friction, select(bounced, zero, load(friction)));
    store(m.torsion, select(bounced, zero, load(m.torsion)));
}

}  // namespace jostle::physics::JOSTLE_ISA
