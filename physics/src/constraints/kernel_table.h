// SPDX-License-Identifier: MIT
//
// Defines the table of one instruction set. Included by constraints/kernels_*.cpp alone, each with
// its own JOSTLE_ISA and compiler flags. Nothing in here or below may be an inline function of
// another namespace that is not always inlined: the linker would keep one copy for all CPUs.
#pragma once

#include "constraints/body_kernel.h"
#include "constraints/contact_kernel.h"
#include "constraints/joints/joint_kernel.h"
#include "constraints/kernels.h"
#include "constraints/planar_kernel.h"
#include "jostle/physics/tuning.h"

namespace jostle::physics::JOSTLE_ISA {

template <Second kValue>
struct SecondIs {
    static constexpr Second value = kValue;
};
template <Inertia kValue>
struct InertiaIs {
    static constexpr Inertia value = kValue;
};

// Calls pass(block index, second, inertia) for every block, the latter two as types.
template <class Pass>
JOSTLE_INLINE void each_block(const BlockRange& range, Pass pass) {
    const auto with_inertia = [&](auto second) {
        for (int k = range.begin; k < range.end; k++) {
            const BlockSide& side = range.sides[k];
            if (side.locked != 0)
                pass(k, second, InertiaIs<Inertia::locked>{});
            else if (side.turning != 0)
                pass(k, second, InertiaIs<Inertia::full>{});
            else
                pass(k, second, InertiaIs<Inertia::isotropic>{});
        }
    };
    switch (range.second) {
        case Second::moving:
            return with_inertia(SecondIs<Second::moving>{});
        case Second::driven:
            // Few: the kernel that is right for all bodies serves.
            for (int k = range.begin; k < range.end; k++)
                pass(k, SecondIs<Second::driven>{}, InertiaIs<Inertia::locked>{});
            return;
        case Second::fixed:
            return with_inertia(SecondIs<Second::fixed>{});
    }
}

JOSTLE_INLINE BlockRough* rough_of(const BlockRange& range, int k) {
    return range.sides[k].rough != 0 ? &range.roughs[k] : nullptr;
}

inline void warm_start_range(const BlockRange& range, HotBody* bodies, const ContactSettings& set) {
    each_block(range, [&](int k, auto second, auto inertia) {
        if (set.planar)
            warm_start_planar<second.value>(range.blocks[k], rough_of(range, k), bodies);
        else
            warm_start_block<second.value, inertia.value>(range.blocks[k], rough_of(range, k),
                                                          bodies);
    });
}

template <bool kRelax, bool kLast>
void solve_range(const BlockRange& range, HotBody* bodies, const ContactSettings& set) {
    each_block(range, [&](int k, auto second, auto inertia) {
        constexpr int all = 4;
        BlockSide& side = range.sides[k];
        BlockReport report;
        if (set.planar)
            report = solve_planar<second.value, kRelax, kLast>(range.blocks[k], side,
                                                               rough_of(range, k), bodies, set);
        else if (range.single)
            report = solve_block<1, second.value, inertia.value, kRelax, kLast>(
                range.blocks[k], side, rough_of(range, k), bodies, set, 1);
        else
            report = solve_block<all, second.value, inertia.value, kRelax, kLast>(
                range.blocks[k], side, rough_of(range, k), bodies, set,
                kRelax ? set.relax_sweeps : set.soft_sweeps);
        if constexpr (kLast) {
            side.aged = static_cast<std::uint8_t>(report.aged);
            side.pressing = static_cast<std::uint8_t>(report.touching);
        }
    });
}

inline void begin_bounce_range(const BlockRange& range, HotBody* bodies, const ContactSettings&) {
    each_block(range, [&](int k, auto second, auto inertia) {
        if (range.sides[k].bouncy != 0)
            begin_bounce<second.value, inertia.value>(range.blocks[k], range.bounces[k], bodies);
    });
}

inline void foresee_bounce_range(const BlockRange& range, HotBody* bodies,
                                 const ContactSettings& set) {
    each_block(range, [&](int k, auto second, auto inertia) {
        if (range.sides[k].bouncy != 0)
            foresee_bounce<second.value, inertia.value>(range.blocks[k], range.bounces[k], bodies,
                                                        set);
    });
}

inline void note_peaks_range(const BlockRange& range, HotBody*, const ContactSettings&) {
    for (int k = range.begin; k < range.end; k++)
        if (range.sides[k].bouncy != 0) note_peaks(range.blocks[k], range.bounces[k]);
}

inline void end_bounce_range(const BlockRange& range, HotBody* bodies, const ContactSettings& set) {
    each_block(range, [&](int k, auto second, auto inertia) {
        if (range.sides[k].bouncy != 0)
            end_bounce<second.value, inertia.value>(range.blocks[k], range.bounces[k],
                                                    range.sides[k].restitution, bodies, set);
    });
}

const Kernels table{
    .warm_start = warm_start_range,
    .solve = solve_range<false, false>,
    .relax = solve_range<true, false>,
    .relax_last = solve_range<true, true>,
    .begin_bounce = begin_bounce_range,
    .foresee_bounce = foresee_bounce_range,
    .note_peaks = note_peaks_range,
    .end_bounce = end_bounce_range,
    .accelerate_first = accelerate_range<true>,
    .accelerate = accelerate_range<false>,
    .advance = advance_range,
    .warm_start_joints = warm_start_joint_range,
    .solve_joints = solve_joint_range<false>,
    .relax_joints = solve_joint_range<true>,
    .begin_joints = begin_joints_range,
    .end_joints = end_joints_range,
};

}  // namespace jostle::physics::JOSTLE_ISA
