// SPDX-License-Identifier: MIT
//
// Defines the kernel table of one instruction set. Only constraints/kernels_*.cpp include it, each
// with its own JOSTLE_ISA and compiler flags. This file and its includes must not use inline
// functions of other namespaces that are not always inlined: the linker would keep one copy for all
// CPUs.
#pragma once

#include "physics/src/constraints/body_kernel.h"
#include "physics/src/constraints/contact_kernel.h"
#include "physics/src/constraints/gyroscopic_kernel.h"
#include "physics/src/constraints/joints/batch_kernel.h"
#include "physics/src/constraints/joints/joint_kernel.h"
#include "physics/src/constraints/kernels.h"
#include "physics/src/constraints/planar_kernel.h"

namespace jostle::physics::JOSTLE_ISA {

template <PairKind kValue>
struct PairKindIs {
    static constexpr PairKind value = kValue;
};
template <Inertia kValue>
struct InertiaIs {
    static constexpr Inertia value = kValue;
};

// Calls pass(block index, pair kind, inertia) for every block, with the latter two as types.
template <class Pass>
JOSTLE_INLINE void each_block(const ContactRange& range, Pass pass) {
    const auto with_inertia = [&](auto pair) {
        for (int k = range.begin; k < range.end; k++) {
            const ContactConstraintWideMeta& meta = range.metas[k];
            if (meta.bits(LaneFlag::locked) != 0)
                pass(k, pair, InertiaIs<Inertia::locked>{});
            else if (meta.bits(LaneFlag::anisotropic) != 0)
                pass(k, pair, InertiaIs<Inertia::full>{});
            else
                pass(k, pair, InertiaIs<Inertia::isotropic>{});
        }
    };
    switch (range.pair) {
        case PairKind::dynamic:
            return with_inertia(PairKindIs<PairKind::dynamic>{});
        case PairKind::kinematic:
            // Kinematic pairs are few: use the kernel that handles all bodies.
            for (int k = range.begin; k < range.end; k++)
                pass(k, PairKindIs<PairKind::kinematic>{}, InertiaIs<Inertia::locked>{});
            return;
        case PairKind::static_:
            return with_inertia(PairKindIs<PairKind::static_>{});
    }
}

JOSTLE_INLINE RollingWide* rolling_of(const ContactRange& range, int k) {
    return range.metas[k].bits(LaneFlag::rolls) != 0 ? &range.rollings[k] : nullptr;
}

inline void warm_start_range(const ContactRange& range, SolverBody* bodies,
                             const ContactSettings& set) {
    each_block(range, [&](int k, auto pair, auto inertia) {
        if (set.planar)
            warm_start_planar<pair.value>(range.blocks[k], rolling_of(range, k), bodies);
        else
            warm_start_block<pair.value, inertia.value>(range.blocks[k], rolling_of(range, k),
                                                        bodies);
    });
}

template <bool kRelax, bool kLast>
void solve_range(const ContactRange& range, SolverBody* bodies, const ContactSettings& set) {
    each_block(range, [&](int k, auto pair, auto inertia) {
        constexpr int all = 4;
        ContactConstraintWideMeta& meta = range.metas[k];
        PairReport report;
        if (set.planar)
            report = solve_planar<pair.value, kRelax, kLast>(range.blocks[k], meta,
                                                             rolling_of(range, k), bodies, set);
        else if (range.single)
            report = solve_block<1, pair.value, inertia.value, kRelax, kLast>(
                range.blocks[k], meta, rolling_of(range, k), bodies, set, 1);
        else
            report = solve_block<all, pair.value, inertia.value, kRelax, kLast>(
                range.blocks[k], meta, rolling_of(range, k), bodies, set,
                kRelax ? set.relax_sweeps : set.soft_sweeps);
        if constexpr (kLast) {
            meta.bits(LaneFlag::needs_rebuild) = static_cast<std::uint8_t>(report.needs_rebuild);
            meta.bits(LaneFlag::touching_now) = static_cast<std::uint8_t>(report.touching);
        }
    });
}

inline void begin_restitution_range(const ContactRange& range, SolverBody* bodies,
                                    const ContactSettings&) {
    each_block(range, [&](int k, auto pair, auto inertia) {
        if (range.metas[k].bits(LaneFlag::bounces) != 0)
            begin_restitution<pair.value, inertia.value>(range.blocks[k], range.restitutions[k],
                                                         bodies);
    });
}

inline void predict_approach_range(const ContactRange& range, SolverBody* bodies,
                                   const ContactSettings& set) {
    each_block(range, [&](int k, auto pair, auto inertia) {
        if (range.metas[k].bits(LaneFlag::bounces) != 0)
            predict_approach<pair.value, inertia.value>(range.blocks[k], range.restitutions[k],
                                                        bodies, set);
    });
}

inline void record_peaks_range(const ContactRange& range, SolverBody*, const ContactSettings&) {
    for (int k = range.begin; k < range.end; k++)
        if (range.metas[k].bits(LaneFlag::bounces) != 0)
            record_peaks(range.blocks[k], range.restitutions[k]);
}

inline void apply_restitution_range(const ContactRange& range, SolverBody* bodies,
                                    const ContactSettings& set) {
    each_block(range, [&](int k, auto pair, auto inertia) {
        if (range.metas[k].bits(LaneFlag::bounces) != 0)
            apply_restitution<pair.value, inertia.value>(range.blocks[k], range.restitutions[k],
                                                         range.metas[k].restitution, bodies, set);
    });
}

const Kernels table{
    .warm_start = warm_start_range,
    .solve = solve_range<false, false>,
    .relax = solve_range<true, false>,
    .relax_last = solve_range<true, true>,
    .begin_restitution = begin_restitution_range,
    .predict_approach = predict_approach_range,
    .record_peaks = record_peaks_range,
    .apply_restitution = apply_restitution_range,
    .accelerate_first = accelerate_range<true>,
    .accelerate = accelerate_range<false>,
    .advance = advance_range,
    .spin_freely = spin_freely_range,
    .begin_gyroscopic = begin_gyroscopic_range,
    .end_gyroscopic = end_gyroscopic_range,
    .warm_start_joints = warm_start_joint_range,
    .solve_joints = solve_joint_range<false, false>,
    .relax_joints = solve_joint_range<true, true>,
    .factor_batch = factor_batch,
    .solve_batch = solve_batch<BatchPass::first>,
    .solve_batch_again = solve_batch<BatchPass::again>,
    .relax_batch = solve_batch<BatchPass::relax>,
    .begin_joints = begin_joints_range,
    .end_joints = end_joints_range,
};

}  // namespace jostle::physics::JOSTLE_ISA
