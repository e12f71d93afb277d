// SPDX-License-Identifier: MIT
//
// Gears, racks and pulleys: one row couples the displacements of two ends, each relative to its
// carrier (gear_ends.h). Up to four bodies participate, each once, in any role.
#pragma once

#include "physics/src/constraints/joints/joint_pair.h"

namespace jostle::physics::JOSTLE_ISA {

struct GearKernel {
    // Indexed by end and slot, with the arm of that end. sides[0] accumulates velocity changes.
    JointSide sides[2][4];
    Wide3 axis[2];
    Wide travel[2];  // since the start of the step; for a rope, its length

    JOSTLE_INLINE GearKernel(const JointGearWide& t, const SolverBody* bodies) {
        for (int end = 0; end < 2; end++) {
            Wide3 moved{splat(0), splat(0), splat(0)}, turned = moved;
            for (int k = 0; k < 4; k++) {
                JointSide& side = sides[end][k];
                side.load_from(bodies, t.body[k], t.arm[end][k]);
                const Wide sign = load(t.sign[end][k]);
                moved = moved + (side.dp + side.swept) * sign;
                turned = turned + side.turned * sign;
            }
            // A rope's direction follows its end; an axis rotates with its body.
            const WideMask rope = load(t.rope) > splat(0), turns = load(t.turns[end]) > splat(0);
            const Wide3 start = load3(t.axis[end]);
            const Wide3 hangs = start * load(t.travel[end]) + moved;
            const Wide3 along = rotate(sides[end][end].rotation, start);
            axis[end] = select(rope, normalized(hangs, start), along);
            travel[end] =
                select(rope, root(dot(hangs, hangs)), dot(along, select(turns, turned, moved)));
        }
    }
    JOSTLE_INLINE void store() {
        for (JointSide& side : sides[0]) side.store_to();
    }

    struct Slot {
        Wide3 linear, angular;
    };
    JOSTLE_INLINE Slot jacobian(const JointGearWide& t, int k) const {
        const Wide3 zero{splat(0), splat(0), splat(0)};
        Slot row{zero, zero};
        for (int end = 0; end < 2; end++) {
            const Wide3 v = axis[end] * (load(t.sign[end][k]) * load(t.scale[end]));
            const WideMask turns = load(t.turns[end]) > splat(0);
            row.linear = row.linear + select(turns, zero, v);
            row.angular = row.angular + select(turns, v, cross(sides[end][k].arm, v));
        }
        return row;
    }
    JOSTLE_INLINE void apply(const Slot* rows, Wide impulse) {
        for (int k = 0; k < 4; k++) {
            JointSide& side = sides[0][k];
            side.v = side.v + side.push(rows[k].linear) * impulse;
            side.w = side.w + side.inverse_inertia * rows[k].angular * impulse;
        }
    }

    static void warm_start(const JointGearWide& t, SolverBody* bodies) {
        GearKernel gear(t, bodies);
        Slot rows[4];
        for (int k = 0; k < 4; k++) rows[k] = gear.jacobian(t, k);
        gear.apply(rows, load(t.impulse));
        gear.store();
    }

    template <bool kRelax>
    static JointLoad solve(const JointStep& step, JointGearWide& t, SolverBody* bodies) {
        GearKernel gear(t, bodies);
        Slot rows[4];
        Wide rate = splat(0), effect = splat(0);
        for (int k = 0; k < 4; k++) {
            rows[k] = gear.jacobian(t, k);
            const JointSide& side = gear.sides[0][k];
            rate = rate + (dot(rows[k].linear, side.v) + dot(rows[k].angular, side.w));
            effect = effect + (dot(rows[k].linear, side.push(rows[k].linear)) +
                               dot(rows[k].angular, side.inverse_inertia * rows[k].angular));
        }
        const Wide scale_a = load(t.scale[0]), scale_b = load(t.scale[1]);
        const WideMask rope = load(t.rope) > splat(0);
        const Wide since_a = gear.travel[0] - load(t.travel[0]);
        const Wide since_b = gear.travel[1] - load(t.travel[1]);
        const Wide error = load(t.error) + since_a * scale_a + since_b * scale_b;
        // A slack rope may be taken up within the sub-step. It never pushes.
        const WideMask slack = rope & (splat(0) > error);
        const WideSoft s = rigid<kRelax>(step);
        const Wide none = splat(0), one = splat(1);
        const WideMask lengths = one > load(t.turns[0]) * load(t.turns[1]);
        const Wide most =
            select(lengths, s.push_speed, s.push_spin) * max(absolute(scale_a), absolute(scale_b));
        const Wide push = error * s.position_rate;
        const WideMask over = absolute(push) > max_push(s, most);
        const WideMask stiff = ~(~slack & ~over);
        const Wide want = rate * select(stiff, one, s.velocity_scale) +
                          select(slack, error * splat(step.inverse_h),
                                 select(over, max(min(push, most), -most), push));
        const Wide old_impulse = load(t.impulse);
        Wide now = old_impulse - want * inverse_above(effect, none) -
                   select(stiff, none, s.impulse_scale) * old_impulse;
        now = select(rope, min(now, none), now);
        gear.apply(rows, now - old_impulse);
        gear.store();
        jostle::physics::JOSTLE_ISA::store(t.impulse, now);
        if constexpr (kRelax) {
            jostle::physics::JOSTLE_ISA::store(t.moved[0], since_a);
            jostle::physics::JOSTLE_ISA::store(t.moved[1], since_b);
        }
        // About b's anchor, with the arm of b's own end.
        return {rows[1].linear * now,
                (rows[1].angular - cross(gear.sides[1][1].arm, rows[1].linear)) * now};
    }
};

// Tag of the kinds that use GearKernel, which loads its bodies itself.
struct GearTag {
    using Own = JointGearWide;
};

}  // namespace jostle::physics::JOSTLE_ISA
